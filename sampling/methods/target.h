#pragma once

/// Log density on R^n that samplers draw from, evaluated at several points at once.

#include <Eigen/Core>

namespace thenar {

enum class WithGradient { kNo, kYes };

/// Log densities of some points, prior and likelihood apart, so that tempering can weigh them.
struct Densities {
  Eigen::VectorXd log_prior;            // up to a constant; -inf: impossible (points)
  Eigen::VectorXd log_likelihood;       // the same; NaN or +inf: not computable (points)
  Eigen::MatrixXd prior_gradient;       // by x; empty if not asked for (n, points)
  Eigen::MatrixXd likelihood_gradient;  // by x; empty if not asked for (n, points)
};

/// A log density  log_prior(x) + log_likelihood(x).  Constant once built; asked by many threads.
class Target {
 public:
  virtual ~Target() = default;

  [[nodiscard]] virtual int size() const = 0;

  /// Number of points in a batch at which the cost of each point is least.
  [[nodiscard]] virtual int preferred_batch_size() const { return 1; }

  /// Densities at the columns of x (n, points). The result of a column does not depend, to the last
  /// bit, on the columns beside it. A density that cannot be computed is NaN, never an exception:
  /// samplers count such points and never go there.
  [[nodiscard]] virtual Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                           WithGradient want) const = 0;
};

}  // namespace thenar

namespace thenar::internal {

/// Tempered density,  log prior + beta * log likelihood,  at one point.
struct TemperedDensity {
  double value = 0;         // -inf where the density is zero or non_finite [1]
  bool non_finite = false;  // NaN or +inf came, where the prior allows the point
};

/// A likelihood that is zero or cannot be computed makes the density zero at every beta, also at 0:
/// the hottest chain samples the prior only where the likelihood exists, so that each of its states
/// could be swapped down.
/// @param point  column of `at`
[[nodiscard]] TemperedDensity tempered(const Densities& at, Eigen::Index point, double beta);

}  // namespace thenar::internal
