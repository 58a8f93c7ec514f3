#pragma once

/// A subject of any size, from proportions.

#include "data/io/anthropometry.h"
#include "data/io/subject.h"

namespace thenar {

/// What a tape measure says of a hand.
struct HandSize {
  double length;   // wrist crease to the tip of the middle finger [m]
  double breadth;  // across the heads of metacarpals II to V      [m]
};

/// A right hand of that size with simple axes: every joint turns about a line square to its
/// bone, and abduction crosses flexion at a right angle.
///
/// The reference posture is a flat hand, x radial, y proximal, z dorsal, origin at the wrist
/// under the middle finger. Bones are straight; there are no masses and no muscles.
/// Source of the proportions: whatever `proportions` was read from, e.g. [Buchholz1992].
/// @throws InputError unless both lengths are positive and finite.
[[nodiscard]] Subject scale_hand(const HandProportions& proportions, const HandSize& size);

}  // namespace thenar
