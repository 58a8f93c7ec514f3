#pragma once

/// The thumb posterior for samplers that ask for one point after the other.

#include <vector>

#include "kinematics_fit/fit_problem.h"
#include "kinematics_fit/kernel/batch.h"
#include "kinematics_fit/kernel/compile.h"

namespace thenar::bench {

/// log p(z) = -|z|^2 / 2 - sum ((f(z) - f) / sd)^2 / 2  within bounds, -inf beyond them; up to a
/// constant.
///
/// Forces come from the scalar unit of the kernel, called directly: no lanes, and nothing is
/// allocated, gathered or checked for each point. HandPosterior has the same density of z, without
/// sphere priors and with known noise, behind a map that has no bounds.
class ThumbDensity {
 public:
  /// @throws InputError unless the problem has one experiment and one specimen.
  explicit ThumbDensity(const FitProblem& problem);

  [[nodiscard]] int size() const { return static_cast<int>(scale_.size()); }
  [[nodiscard]] double operator()(const Eigen::VectorXd& z);  // (size)

 private:
  struct Compiled {
    explicit Compiled(const FitProblem& problem);
    kernel::Program program;
  };

  Compiled compiled_;
  const kernel::SimdBackend* unit_;
  Eigen::VectorXd lower_, upper_, scale_;  // of z [1, 1, SI]
  Eigen::VectorXd measured_, precision_;   // [N], 1 / sd [1/N] (3 trials)
  Eigen::VectorXd u_, force_;              // [SI], [N]
  kernel::SimdBuffer tape_, scratch_;
};

}  // namespace thenar::bench
