#pragma once

/// Joint centres, bones and breadths of a subject, the input of its skin.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"

namespace thenar {

/// Bone of a digit, between joint centres.
struct DigitBone {
  std::string segment;
  Eigen::Vector3d proximal;  // joint centre at its proximal end [m] (3)
  Eigen::Vector3d distal;    // joint centre at its distal end, or the end of the digit [m] (3)
  double radius;             // mean radius of the flesh around it [m]
  Eigen::Vector3d dorsal;    // unit direction across the bone (3)
  Eigen::Vector3d radial;    // unit direction across both (3)
};

/// Digit from the wrist outwards: a finger's three phalanges, the thumb's metacarpal and two.
struct DigitAnatomy {
  std::string name;
  std::string root;  // segment that carries its first bone
  std::vector<DigitBone> bones;
};

/// Palm as a slab.
struct PalmAnatomy {
  std::string segment;
  Eigen::Vector3d wrist;                   // centre of the wrist [m] (3)
  Eigen::Vector3d radial, distal, dorsal;  // unit directions, right-handed in a right hand (3)
  double breadth;                          // breadth across the heads of metacarpals II to V [m]
  double thickness;                        // thickness without thenar and hypothenar [m]
};

/// Anatomy of a hand for its surface.
struct HandAnatomy {
  double length;  // distance from the wrist to the tip of the middle finger [m]
  std::vector<DigitAnatomy> digits;
  std::optional<PalmAnatomy> palm;    // absent: a single digit
  std::vector<std::string> warnings;  // values taken from proportions
};

/// Derives the anatomy of a subject.
///
/// A joint's centre is the point of its flexion axis next to the bone's end, so that skin lies
/// around the joint even where landmarks were digitised on the back of the hand; where the subject
/// has the surface of the joint's head, it is the point next to the middle of that head and the
/// bone's end. The centre is at most one and a half radii from the bone's end. A digit ends at its
/// tip, or at the end of the tip's bone where that reaches further. Segments whose name ends in
/// "_link", or of zero length, are hinges of universal joints, without flesh. Radii that the
/// subject does not state are those of [Mirakhorlo2016] in proportion to the length of the hand; a
/// length that it does not state follows from the bones by [Buchholz1992], a breadth from the
/// length likewise. The thickness of the palm is its breadth times 24/68, from the hand's breadth
/// and circumference in [Mirakhorlo2016].
/// @throws InputError if there is no digit, a digit has fewer than three bones to its tip, the base
/// not counted, or a bone no length.
[[nodiscard]] HandAnatomy find_anatomy(const Subject& subject);

/// Returns the digit of that name; nullptr if there is none.
[[nodiscard]] const DigitAnatomy* digit_named(const HandAnatomy& hand, const std::string& name);

}  // namespace thenar
