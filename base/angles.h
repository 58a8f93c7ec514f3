#pragma once

/// Degrees are for people and files; everything inside is in radians.

namespace thenar {

inline constexpr double kPi = 3.14159265358979323846;  // half a turn [rad]
inline constexpr double kDegree = kPi / 180;           // [rad]

/// @param angle [deg]  @return [rad]
[[nodiscard]] constexpr double radians(double angle) { return angle * kDegree; }

/// @param angle [rad]  @return [deg]
[[nodiscard]] constexpr double degrees(double angle) { return angle / kDegree; }

}  // namespace thenar
