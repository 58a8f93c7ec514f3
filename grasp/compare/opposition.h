#pragma once

/// Opposition of the thumb, with Kapandji's score.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Opposition of the thumb, on a scale of 0 to 10.
struct Opposition {
  double score = 0;                  // score; NaN: the hand has fewer than two digits
  std::string scale;                 // name of the scale
  std::vector<std::string> reached;  // landmarks or digits that the thumb meets
};

/// Measures opposition. For a hand with `places` it is Kapandji's score: the highest landmark that
/// the pad of the thumb meets. For others it is ten times the share of other tips that the tip of
/// the thumb meets, the maximum over all digits if none is called thumb. Two points meet if a
/// posture within the limits brings them within 10 mm, centres of tips within 20 mm; soft tissue
/// may overlap, and orientations do not count. Postures are searched from 12 random starts by
/// damped least squares, clamped to the limits. Source: [Kapandji1986].
[[nodiscard]] Opposition measure_opposition(const ComparedHand& hand, std::mt19937& random,
                                            const Progress& progress = {});

}  // namespace thenar
