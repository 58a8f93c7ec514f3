#pragma once

/// Joint centres, bones and breadths of a subject, as its skin needs them.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"

namespace thenar {

/// A bone of a digit, between joint centres.
struct DigitBone {
  std::string segment;
  Eigen::Vector3d proximal;  // joint centres, the last end is that of the digit [m] (3)
  Eigen::Vector3d distal;
  double radius;           // mean of the flesh around it [m]
  Eigen::Vector3d dorsal;  // unit, across the bone (3)
  Eigen::Vector3d radial;  // unit, across both (3)
};

/// A digit from the wrist outwards: a finger's three phalanges, the thumb's metacarpal and two.
struct DigitAnatomy {
  std::string name;
  std::string root;  // segment that carries its first bone
  std::vector<DigitBone> bones;
};

/// The palm as a slab.
struct PalmAnatomy {
  std::string segment;
  Eigen::Vector3d wrist;                   // centre of the wrist [m] (3)
  Eigen::Vector3d radial, distal, dorsal;  // right-handed in a right hand, unit (3)
  double breadth;                          // across the heads of metacarpals II to V [m]
  double thickness;                        // without thenar and hypothenar [m]
};

/// Anatomy of a hand for its surface.
struct HandAnatomy {
  double length;  // wrist to the tip of the middle finger [m]
  std::vector<DigitAnatomy> digits;
  std::optional<PalmAnatomy> palm;    // absent: a single digit
  std::vector<std::string> warnings;  // what was taken from proportions
};

/// Finds the anatomy of a subject.
///
/// A joint's centre is the point of its flexion axis next to the bone's end, so that skin lies
/// around the joint even where landmarks were digitised on the back of the hand; where the subject
/// has the surface of the joint's head, next to the middle of that and the bone's end. It moves
/// no further than one and a half radii. A digit ends at its tip, or at the end of the tip's bone
/// where that reaches further. Segments whose name ends in "_link", or of no length, are hinges of
/// universal joints, without flesh. Radii that the subject does not state are those of
/// [Mirakhorlo2016] in proportion to the length of the hand; a length that it does not state
/// follows from the bones by [Buchholz1992], a breadth from the length as there. The palm is as
/// thick as breadth times 24/68, of the hand's breadth and circumference in [Mirakhorlo2016].
/// @throws InputError if there is no digit, a digit has fewer than three bones to its tip, or a
/// bone no length.
[[nodiscard]] HandAnatomy find_anatomy(const Subject& subject);

/// The digit of that name; nullptr if there is none.
[[nodiscard]] const DigitAnatomy* digit_named(const HandAnatomy& hand, const std::string& name);

}  // namespace thenar
