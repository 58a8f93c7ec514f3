#pragma once

/// Laplace approximation of a posterior at a mode: J'J of the residuals, by blocks where available.

#include <optional>
#include <vector>

#include "solvers/least_squares.h"

namespace thenar {

/// J'J at a point over the coordinates that their bounds do not fix; fixed coordinates have no
/// variance. If the residuals come in blocks, J'J is stored as their factor, whose size is
/// proportional to the number of blocks; otherwise as eigenvectors, with at least 1e-12 of the
/// largest curvature in directions that neither data nor priors determine.
class ModeCurvature {
 public:
  /// Evaluates J'J at z (n).
  ModeCurvature(const LeastSquares& problem, const Eigen::VectorXd& z);

  /// Returns |J apart|^2. @param apart  difference of two points (n)
  [[nodiscard]] double squared_norm(const Eigen::VectorXd& apart) const;
  /// Returns log det(J'J) over the free coordinates.
  [[nodiscard]] double log_determinant() const;
  /// Returns a vector with covariance (J'J)^-1 if `normal` is standard normal (n).
  [[nodiscard]] Eigen::VectorXd transform_normal(const Eigen::VectorXd& normal) const;
  /// Returns (J'J)^-1, zero where a coordinate is fixed (n, n). Large for many specimens.
  [[nodiscard]] Eigen::MatrixXd covariance() const;

 private:
  Eigen::Index size_;
  std::vector<int> free_;   // indices in z of the free coordinates
  Eigen::MatrixXd axes_;    // eigenvectors as orthonormal columns (free, free)
  Eigen::VectorXd lambda_;  // curvature along each axis: 1 / variance, > 0 (free)
  std::optional<ArrowFactor>
      blocks_;  // factor that replaces axes_ and lambda_ if the residuals come in blocks
};

}  // namespace thenar
