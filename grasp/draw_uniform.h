#pragma once

/// Uniform draws, the same on every machine: std::uniform_real_distribution is not.

#include <random>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// In [0, 1).
[[nodiscard]] inline double draw_uniform(std::mt19937& random) { return random() * 0x1p-32; }

/// In [lower, upper).
[[nodiscard]] inline double draw_between(double lower, double upper, std::mt19937& random) {
  return lower + draw_uniform(random) * (upper - lower);
}

/// A posture within a hand's limits. (coordinates)
[[nodiscard]] inline Eigen::VectorXd draw_posture(const HandLayout& layout, std::mt19937& random) {
  Eigen::VectorXd q(layout.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    q[j] = draw_between(layout.lower[j], layout.upper[j], random);
  return q;
}

}  // namespace thenar
