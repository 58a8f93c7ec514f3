#pragma once

/// The Laplace approximation of a posterior at a mode: J'J of residuals, by blocks where there are.

#include <optional>
#include <vector>

#include "solvers/least_squares.h"

namespace thenar {

/// J'J at a point, over the coordinates whose bounds leave them room; the others are fixed and have
/// no variance. Where residuals come in blocks it is held as their factor, which grows in
/// proportion to their number; otherwise in its eigenvectors, those that neither data nor priors
/// know having 1e-12 of the largest curvature.
class ModeCurvature {
 public:
  ModeCurvature(const LeastSquares& problem, const Eigen::VectorXd& z);

  /// |J apart|^2 (n).
  [[nodiscard]] double squared_norm(const Eigen::VectorXd& apart) const;
  [[nodiscard]] double log_determinant() const;
  /// A vector that has the covariance (J'J)^-1 if `normal` is standard normal (n).
  [[nodiscard]] Eigen::VectorXd spread(const Eigen::VectorXd& normal) const;
  /// (J'J)^-1, zero where a coordinate is fixed (n, n): of many specimens it is large.
  [[nodiscard]] Eigen::MatrixXd covariance() const;

 private:
  Eigen::Index size_;
  std::vector<int> free_;              // indices in z
  Eigen::MatrixXd axes_;               // orthonormal columns (free, free)
  Eigen::VectorXd lambda_;             // 1 / variance, > 0 (free)
  std::optional<ArrowFactor> blocks_;  // instead of both, where residuals come in blocks
};

}  // namespace thenar
