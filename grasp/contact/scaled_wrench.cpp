#include "grasp/contact/scaled_wrench.h"

namespace thenar {

ScaledWrench ScaledWrench::unit(Eigen::Index axis) {
  return from_coordinates(WrenchCoordinates::Unit(axis));
}

WrenchCoordinates ScaledWrench::vector() const {
  WrenchCoordinates six;
  six << force, moment_over_length;
  return six;
}

// All six numbers count equally.
double ScaledWrench::dot(const ScaledWrench& b) const { return vector().dot(b.vector()); }
double ScaledWrench::norm() const { return vector().norm(); }
bool ScaledWrench::is_zero() const { return vector().isZero(0); }
bool ScaledWrench::is_finite() const { return vector().allFinite(); }

bool operator==(const ScaledWrench& a, const ScaledWrench& b) {
  return a.force == b.force && a.moment_over_length == b.moment_over_length;
}

Eigen::Matrix<double, 6, 1> ScaledMotion::vector() const {
  Eigen::Matrix<double, 6, 1> six;
  six << translation, rotation_times_length;
  return six;
}

}  // namespace thenar
