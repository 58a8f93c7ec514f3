#pragma once

/// Shortest string between two points round one obstacle, in closed form: for nets and for paths
/// that meet one surface at a time.

#include <Eigen/Core>

#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// Length of a string from a to b and its derivatives by the stacked ends (a, b).
struct WrappedString {
  double length = 0;                  // [m]
  bool bent = false;                  // true: it touches the surface
  bool possible = true;               // false: an end lies inside the surface
  Eigen::Matrix<double, 6, 1> slope;  // d length / d(a, b): unit tangents at the ends [1]
  Eigen::Matrix<double, 6, 6> curve;  // d2 length / d(a, b)2 [1/m]
  Eigen::Vector3d touch_a,
      touch_b;  // points where it meets and leaves the surface; a and b if straight [m] (3)
};

/// Computes the angle about z from `side` to p, in (-pi, pi].
[[nodiscard]] double angle_from(const Eigen::Vector3d& side, const Eigen::Vector3d& p);

/// Computes the length and derivatives of a straight string.
[[nodiscard]] WrappedString straight_string(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Computes the string over a sphere or a cylinder, with all points in the surface's frame S.
///   sphere    L = |a tangent| + arc + |b tangent|  in the plane of a, b and the centre
///   cylinder  L = sqrt(P^2 + dz^2), P the same in the plane across the axis
/// An end inside the surface counts as lying on it, at the nearest point; `possible` is then false
/// and `curve` omits the change of that nearest point.
/// Length and slope are continuous at lift-off, the second derivative is not.
/// @param side_S  direction from the axis towards the side on which the string passes, even if the
/// other is shorter (cylinder); on a sphere it only decides between antipodal ways (3)
[[nodiscard]] WrappedString wrap_string(const BoneSurface& surface, const Eigen::Vector3d& a_S,
                                        const Eigen::Vector3d& b_S, const Eigen::Vector3d& side_S);

}  // namespace thenar
