#pragma once

/// Hand proportions: bones and joints as fractions of the length and breadth of a hand.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "data/io/subject.h"

namespace thenar {

/// Axis about which a joint of a simple, orthogonal hand turns.
enum class SimpleAxis { kFlexion, kAbduction };
inline constexpr std::array kSimpleAxisNames{EnumName{SimpleAxis::kFlexion, "flexion"},
                                             EnumName{SimpleAxis::kAbduction, "abduction"}};

/// Joint at the proximal end of a segment.
struct SimpleJoint {
  std::string name;  // "MCP2_FE"
  SimpleAxis axis = SimpleAxis::kFlexion;
  double lower = 0;  // joint limit [rad]
  double upper = 0;  // joint limit [rad]
};

/// A bone as a fraction of the hand's length, with the joints at its proximal end.
struct SegmentProportion {
  std::string name;                 // "PP2"
  double length = 0;                // times hand length [1]
  std::vector<SimpleJoint> joints;  // joints from the wrist outwards
};

/// A digit of a flat hand.
struct DigitProportion {
  std::string name;         // "index"
  double joint_distal = 0;  // first joint, distal of the wrist, times hand length [1]
  double joint_radial = 0;  // first joint, radial of the middle finger, times hand breadth [1]
  double splay = 0;         // turned away from the middle finger, radially [rad]
  double roll = 0;          // turned about its own length, thumb pad towards the palm [rad]
  std::vector<SegmentProportion> segments;
};

/// Proportions of a whole hand.
struct HandProportions {
  std::string name;
  std::string description;
  std::vector<DigitProportion> digits;
};

/// Reads data/anthropometry/*.toml; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] HandProportions read_proportions(const std::string& path);

/// Parses hand proportions from text already in memory; `path` only names it in messages.
[[nodiscard]] HandProportions parse_proportions(const std::string& text, const std::string& path);

/// Size of a hand by tape measure.
struct HandSize {
  double length;   // wrist crease to the tip of the middle finger [m]
  double breadth;  // across the heads of metacarpals II to V      [m]
};

/// Builds a right hand of that size with simple axes: flexion axes are perpendicular to the bone,
/// and abduction axes perpendicular to these.
///
/// The reference posture is a flat hand, x radial, y proximal, z dorsal, origin at the wrist
/// under the middle finger. Bones are straight; there are no masses and no muscles.
/// Source of the proportions: whatever `proportions` was read from, e.g. [Buchholz1992].
/// @throws InputError unless both lengths are positive and finite.
[[nodiscard]] Subject scale_hand(const HandProportions& proportions, const HandSize& size);

}  // namespace thenar
