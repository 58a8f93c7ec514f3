#pragma once

/// The shortest string between two points round one obstacle, in closed form: for nets and for
/// paths that meet one surface at a time.

#include <Eigen/Core>

#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// Length of a string from a to b and its derivatives; (a, b) stacked.
struct WrappedString {
  double length;                      // [m]
  bool bent;                          // whether it touches the surface
  bool possible = true;               // false: an end lies inside the surface
  Eigen::Matrix<double, 6, 1> slope;  // d length / d(a, b); ends are unit tangents [1]
  Eigen::Matrix<double, 6, 6> curve;  // second derivative [1/m]
  Eigen::Vector3d touch_a, touch_b;   // where it meets and leaves the surface; a and b if straight
};

/// Straight string.
[[nodiscard]] WrappedString straight_string(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// String over a sphere or a cylinder, with all points in the surface's frame S.
///   sphere    L = |a tangent| + arc + |b tangent|  in the plane of a, b and the centre
///   cylinder  L = sqrt(P^2 + dz^2), P the same in the plane across the axis
/// An end inside the surface counts as lying on it, at the nearest point; `possible` is then false
/// and `curve` leaves out how that point turns.
/// Length and slope are continuous at lift-off, the second derivative is not.
/// @param side_S  direction from the axis towards the side on which the string passes, whatever is
///                shorter (cylinder); on a sphere it only decides between antipodal ways (3)
[[nodiscard]] WrappedString wrap_string(const BoneSurface& surface, const Eigen::Vector3d& a_S,
                                        const Eigen::Vector3d& b_S, const Eigen::Vector3d& side_S);

}  // namespace thenar
