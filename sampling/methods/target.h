#pragma once

/// Log density on R^n to be sampled, evaluated at several points at once.

#include <Eigen/Core>

namespace thenar {

/// Request for the gradient of a log density.
enum class WithGradient { kNo, kYes };

/// Log densities of several points, with separate prior and likelihood for tempering.
struct Densities {
  Eigen::VectorXd log_prior;  // log prior up to a constant; -inf: impossible (points)
  Eigen::VectorXd
      log_likelihood;  // log likelihood up to a constant; NaN or +inf: not computable (points)
  Eigen::MatrixXd prior_gradient;       // gradient by x; empty unless requested (n, points)
  Eigen::MatrixXd likelihood_gradient;  // gradient by x; empty unless requested (n, points)
};

/// Log density  log_prior(x) + log_likelihood(x).  Immutable once built; called from many threads.
class Target {
 public:
  virtual ~Target() = default;

  [[nodiscard]] virtual int size() const = 0;

  /// Returns the number of points in a batch for which the cost per point is lowest.
  [[nodiscard]] virtual int preferred_batch_size() const { return 1; }

  /// Evaluates the densities at the columns of x (n, points). The result of a column does not
  /// depend, to the last bit, on the other columns. A density that cannot be computed is NaN, never
  /// an exception: samplers count such points and reject them.
  [[nodiscard]] virtual Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                           WithGradient want) const = 0;
};

}  // namespace thenar

namespace thenar::internal {

/// Tempered density,  log prior + beta * log likelihood,  at one point.
struct TemperedDensity {
  double value = 0;         // log density; -inf if the density is zero or not finite [1]
  bool non_finite = false;  // the log density is NaN or +inf although the prior allows the point
};

/// Computes the tempered density at one point. A likelihood that is zero or cannot be computed
/// makes the density zero at every beta, including 0: the hottest chain samples the prior only
/// where the likelihood exists, so that each of its states may be swapped down.
/// @param point  column of `at`
[[nodiscard]] TemperedDensity tempered_density(const Densities& at, Eigen::Index point,
                                               double beta);

}  // namespace thenar::internal
