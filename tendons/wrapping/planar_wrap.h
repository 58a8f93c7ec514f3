#pragma once

/// String round a circle, in its plane.

#include <optional>

#include <Eigen/Core>

namespace thenar {

/// Contact of a string from a to b with the circle of radius r about the origin.
struct PlanarWrap {
  Eigen::Vector2d touch_a, touch_b;  // touch points on the sides of a and b [m] (2)
  double sense = 0;                  // sense of wrapping: 1 counterclockwise, -1 clockwise
  double angle = 0;                  // wrapped angle, 0 .. 2 pi [rad]
  double free_a = 0, free_b = 0;     // lengths of the straight parts [m]
};

/// Wraps a string so that it never crosses the half line from the origin opposite to `side`.
/// Returns nothing if the string is straight. Ends inside the circle count as lying on it.
[[nodiscard]] std::optional<PlanarWrap> wrap_circle(double r, const Eigen::Vector2d& a,
                                                    const Eigen::Vector2d& b,
                                                    const Eigen::Vector2d& side);

/// Returns whether a point that moved round the origin by less than half a turn crossed the half
/// line opposite to `side`, where wrap_circle() jumps.
[[nodiscard]] bool crossed_far_side(const Eigen::Vector2d& side, const Eigen::Vector2d& was,
                                    const Eigen::Vector2d& is);

}  // namespace thenar
