#pragma once

/// Two fingers on opposite sides of a ball, each on a slide along x with its own motor.

#include <limits>

#include "grasp/limits/force_set.h"

namespace thenar {

inline constexpr double kRadius = 0.03;  // of the ball [m]
inline constexpr double kScale = 0.02;   // torques are divided by it [m]

inline std::vector<Contact> pinch_contacts(double friction, double torsion) {
  return {{{-kRadius, 0, 0}, {1, 0, 0}, friction, torsion},
          {{kRadius, 0, 0}, {-1, 0, 0}, friction, torsion}};
}

inline WrenchSet pinch(double friction, double torsion) {
  return wrench_set(pinch_contacts(friction, torsion), {0, 0, 0}, kScale);
}

/// Motor i feels the normal force of finger i, and nothing else: its slide bears the rest.
inline Eigen::MatrixXd pinch_torques(double friction, double torsion) {
  const int size = 1 + (friction > 0 ? 2 : 0) + (torsion > 0 ? 1 : 0);
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(2, 2L * size);
  T(0, 0) = T(1, size) = 1;
  return T;
}

inline Actuation pinch_motors(double least, double most) {
  return {Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant(least),
          Eigen::Vector2d::Constant(most)};
}

}  // namespace thenar
