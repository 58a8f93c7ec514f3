#pragma once

/// Wrenches in one unit: the force, and the moment divided by a length, both in newtons.

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// Six numbers of a scaled wrench [N]: force x, y, z, then moment / length x, y, z. Every matrix of
/// scaled wrenches (6, n) has its rows in this order, and so have points and directions of the
/// six-dimensional space in which the wrenches of a grasp form a body.
using WrenchCoordinates = Eigen::Matrix<double, 6, 1>;

/// A wrench as two vectors of forces. It is no vector of six numbers, so that a `Wrench` as six
/// numbers, whose moment comes first and has its own unit, cannot stand in its place.
struct ScaledWrench {
  Eigen::Vector3d force{0, 0, 0};               // [N] (3)
  Eigen::Vector3d moment_over_length{0, 0, 0};  // moment / torque scale [N] (3)

  /// Returns the wrench of six numbers in the order of WrenchCoordinates.
  [[nodiscard]] static ScaledWrench from_coordinates(const WrenchCoordinates& six) {
    return {six.head<3>(), six.tail<3>()};
  }
  /// Returns the unit wrench along an axis: 0..2 forces, 3..5 moments.
  [[nodiscard]] static ScaledWrench unit(Eigen::Index axis);
  /// Returns the six numbers in the order of WrenchCoordinates.
  [[nodiscard]] WrenchCoordinates vector() const;

  [[nodiscard]] double dot(const ScaledWrench& b) const;
  [[nodiscard]] double norm() const;
  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] bool is_finite() const;

  ScaledWrench& operator+=(const ScaledWrench& b) {
    force += b.force;
    moment_over_length += b.moment_over_length;
    return *this;
  }
  friend ScaledWrench operator+(ScaledWrench a, const ScaledWrench& b) { return a += b; }
  friend ScaledWrench operator-(const ScaledWrench& a, const ScaledWrench& b) {
    return {a.force - b.force, a.moment_over_length - b.moment_over_length};
  }
  friend ScaledWrench operator-(const ScaledWrench& a) { return {-a.force, -a.moment_over_length}; }
  friend ScaledWrench operator*(double factor, const ScaledWrench& a) {
    return {factor * a.force, factor * a.moment_over_length};
  }
  friend bool operator==(const ScaledWrench& a, const ScaledWrench& b);
};

/// Divides the moment of a wrench by a length.
/// @param torque_scale  above 0 [m]
[[nodiscard]] inline ScaledWrench scaled_wrench(const Wrench& wrench, double torque_scale) {
  return {wrench.force, wrench.moment / torque_scale};
}

/// The inverse of scaled_wrench().
[[nodiscard]] inline Wrench unscaled_wrench(const ScaledWrench& wrench, double torque_scale) {
  return {torque_scale * wrench.moment_over_length, wrench.force};
}

/// A small displacement that does work with scaled wrenches, in one unit too.
struct ScaledMotion {
  Eigen::Vector3d way{0, 0, 0};                // [m] (3)
  Eigen::Vector3d turn_times_length{0, 0, 0};  // rotation vector x torque scale [m] (3)

  /// Returns the six numbers, the way first, as conjugate to WrenchCoordinates.
  [[nodiscard]] Eigen::Matrix<double, 6, 1> vector() const;
};

}  // namespace thenar
