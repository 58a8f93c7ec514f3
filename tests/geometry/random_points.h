#pragma once

/// Random points by our own arithmetic, so that every platform draws the same.

#include <cstdlib>
#include <random>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thenar {

/// In [0, 1).
[[nodiscard]] inline double uniform(std::mt19937& rng) { return rng() * 0x1p-32; }

/// In the box [-1, 1)^3.
[[nodiscard]] inline Eigen::Vector3d random_in_cube(std::mt19937& rng) {
  const double x = uniform(rng), y = uniform(rng), z = uniform(rng);
  return 2 * Eigen::Vector3d(x, y, z) - Eigen::Vector3d::Ones();
}

[[nodiscard]] inline Eigen::Vector3d random_direction(std::mt19937& rng) {
  for (;;) {
    const Eigen::Vector3d p = random_in_cube(rng);
    const double norm = p.norm();
    if (norm <= 1 && norm > 1e-3) return p / norm;
  }
}

[[nodiscard]] inline Eigen::Matrix3d random_rotation(std::mt19937& rng) {
  return Eigen::AngleAxisd(6 * uniform(rng), random_direction(rng)).toRotationMatrix();
}

/// How many queries a test puts: `few`, or the number in THENAR_QUERIES.
[[nodiscard]] inline int queries(int few) {
  const char* asked = std::getenv("THENAR_QUERIES");
  return asked ? std::stoi(asked) : few;
}

}  // namespace thenar
