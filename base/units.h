#pragma once

/// Units of input and output; all internal numbers are in SI and radians.

namespace thenar {

inline constexpr double kPi = 3.14159265358979323846;  // Half a turn [rad]
inline constexpr double kDegree = kPi / 180;           // A degree [rad]
inline constexpr double kMm = 1e-3;                    // A millimetre [m]
inline constexpr double kNewtonMillimetre = 1e-3;      // A newton millimetre [N m]

/// Converts degrees to radians. @param angle [deg]  @return [rad]
[[nodiscard]] constexpr double radians(double angle) { return angle * kDegree; }

/// Converts radians to degrees. @param angle [rad]  @return [deg]
[[nodiscard]] constexpr double degrees(double angle) { return angle / kDegree; }

}  // namespace thenar
