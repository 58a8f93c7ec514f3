#pragma once

/// Wrenches in one unit: the force, and the moment divided by a length, both in newtons.

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// Components of a scaled wrench [N]: force x, y, z, then moment / length x, y, z. Every matrix of
/// scaled wrenches (6, n) has its rows in this order, and so have points and directions of the
/// six-dimensional space of the wrenches of a grasp.
using WrenchCoordinates = Eigen::Matrix<double, 6, 1>;

/// A wrench as two vectors of forces. It is a type of its own, not a vector of six numbers, so that
/// it cannot be confused with a `Wrench`, whose moment comes first and has another unit.
struct ScaledWrench {
  Eigen::Vector3d force{0, 0, 0};               // [N] (3)
  Eigen::Vector3d moment_over_length{0, 0, 0};  // moment / torque scale [N] (3)

  /// Returns the wrench with given components in the order of WrenchCoordinates.
  [[nodiscard]] static ScaledWrench from_coordinates(const WrenchCoordinates& six) {
    return {six.head<3>(), six.tail<3>()};
  }
  /// Returns the unit wrench along an axis: 0..2 forces, 3..5 moments.
  [[nodiscard]] static ScaledWrench unit(Eigen::Index axis);
  /// Returns the components in the order of WrenchCoordinates.
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

/// Multiplies the moment by the length again: the inverse of scaled_wrench().
[[nodiscard]] inline Wrench unscaled_wrench(const ScaledWrench& wrench, double torque_scale) {
  return {torque_scale * wrench.moment_over_length, wrench.force};
}

/// A small displacement, conjugate to scaled wrenches, with both parts in metres.
struct ScaledMotion {
  Eigen::Vector3d translation{0, 0, 0};            // [m] (3)
  Eigen::Vector3d rotation_times_length{0, 0, 0};  // rotation vector x torque scale [m] (3)

  /// Returns the components, translation first, conjugate to WrenchCoordinates.
  [[nodiscard]] Eigen::Matrix<double, 6, 1> vector() const;
};

}  // namespace thenar
