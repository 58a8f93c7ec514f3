#pragma once

/// Variability of a digit's joint axes between people.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"

namespace thenar {

/// Normal distribution of one axis about that of the mean subject. The axis passes through
///   p + along u + across w,   along ~ N(along, along_sd^2),  across ~ N(0, across_sd^2),
/// p the point of joint `beside`, u the bone's direction (distal), w perpendicular to u and to the
/// axis. Its direction is  d + tan(a) e1 + tan(b) e2, a and b ~ N(0, tilt_sd^2), e1 and e2
/// perpendicular to d.
struct AxisVariability {
  std::string joint;     // "MCP1_AA"
  std::string beside;    // joint of the mean subject from whose point places are measured
  std::string bone;      // segment of the mean subject that u goes along
  double along = 0;      // [m]
  double along_sd = 0;   // [m]
  double across_sd = 0;  // [m]
  double tilt_sd = 0;    // [rad]
  std::string source;    // citation keys
  std::vector<std::string> assumed;  // keys of the file whose numbers are not measured
};

/// Direction in a digit's reference posture.
enum class DigitDirection { kDistal, kDorsal, kRadial };
inline constexpr std::array kDigitDirectionNames{EnumName{DigitDirection::kDistal, "distal"},
                                                 EnumName{DigitDirection::kDorsal, "dorsal"},
                                                 EnumName{DigitDirection::kRadial, "radial"}};
[[nodiscard]] inline std::string name_of(DigitDirection direction) {
  return name_in(kDigitDirectionNames, direction);
}

/// Question whether the common normal from one axis to another points in a direction.
struct NormalQuestion {
  std::string first, second;  // joints
  DigitDirection toward = DigitDirection::kRadial;
};

/// Distribution of a digit's axes in people.
struct DigitVariability {
  std::string name, description;
  std::string mean_subject;  // name of a file in subjects/, without ending
  std::vector<AxisVariability> axes;
  NormalQuestion second;  // second criterion of types
};

/// Reads data/studies/thumb_axes_variability.toml; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] DigitVariability parse_variability(const std::string& text, const std::string& path);

[[nodiscard]] DigitVariability read_variability(const std::string& path);

}  // namespace thenar
