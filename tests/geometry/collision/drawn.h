#pragma once

/// Random points and poses, the same everywhere for the same seed.

#include <random>

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// In [-1, 1).
inline double drawn(std::mt19937& rng) {
  return 2 * (static_cast<double>(rng()) / 4294967296.0) - 1;
}

/// In a cube of half edge `size`.
inline Eigen::Vector3d drawn_point(std::mt19937& rng, double size) {
  const double x = drawn(rng), y = drawn(rng), z = drawn(rng);
  return size * Eigen::Vector3d(x, y, z);
}

inline Pose<double> drawn_pose(std::mt19937& rng, double size) {
  const Eigen::Vector3d axis = drawn_point(rng, 1).normalized();
  const double angle = 3 * drawn(rng);
  return {rotation_about<double>(axis, angle), drawn_point(rng, size)};
}

}  // namespace thenar
