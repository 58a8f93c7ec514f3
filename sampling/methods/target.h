#pragma once

/// What samplers draw from: a log density on R^n, asked at several points at once.

#include <Eigen/Core>

namespace thenar {

enum class WithGradient { kNo, kYes };

/// Log densities of some points, prior and likelihood apart, so that tempering may weigh them.
struct Densities {
  Eigen::VectorXd log_prior;            // up to a constant; -inf: impossible (points)
  Eigen::VectorXd log_likelihood;       // the same; NaN or +inf: the model broke (points)
  Eigen::MatrixXd prior_gradient;       // by x; empty if not asked for (n, points)
  Eigen::MatrixXd likelihood_gradient;  // by x; empty if not asked for (n, points)
};

/// A log density  log_prior(x) + log_likelihood(x).  Constant once built; asked by many threads.
class Target {
 public:
  virtual ~Target() = default;

  [[nodiscard]] virtual int size() const = 0;

  /// How many points cost least for each when they are asked together.
  [[nodiscard]] virtual int lanes() const { return 1; }

  /// Densities at the columns of x (n, points). What comes out for one column does not depend, to
  /// the last bit, on the columns beside it. A density that cannot be computed is NaN, never a
  /// throw: samplers count such points and never go there.
  [[nodiscard]] virtual Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                           WithGradient want) const = 0;
};

}  // namespace thenar

namespace thenar::internal {

// One density out of prior and likelihood.

/// log prior + beta * log likelihood at one point.
struct TemperedDensity {
  double value = 0;         // -inf where the density is zero or non_finite [1]
  bool non_finite = false;  // NaN or +inf came, where the prior allows the point
};

/// A likelihood of zero, or one that cannot be computed, makes the density zero at every beta,
/// at 0 too: the hottest chain samples the prior where there is a likelihood at all, so that every
/// place of it could be handed down.
/// @param point  column of `at`
[[nodiscard]] TemperedDensity tempered(const Densities& at, Eigen::Index point, double beta);

}  // namespace thenar::internal
