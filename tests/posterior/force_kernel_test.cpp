// Tests for posterior/force_kernel.cpp: forces and their adjoint against Ceres' derivatives.

#include "posterior/force_kernel.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

/// A kernel with what it was built from.
struct Case {
  explicit Case(const FitProblem& problem)
      : digit(problem.digit()),
        parameters(problem.parameters()),
        plan(problem.plans().front()),
        kernel(digit, parameters, plan) {}

  TendonDigit digit;
  FitParameters parameters;
  ExperimentPlan plan;
  ForceKernel kernel;
};

/// Greatest relative difference of forces and of J' w from Ceres' at `points` random places.
double error_against_ceres(const Case& c, double spread, int points, std::mt19937& rng) {
  Eigen::VectorXd sd(c.kernel.coordinates());
  for (Eigen::Index k = 0; k < sd.size(); ++k) sd[k] = c.parameters.all[c.parameters.leader[k]].sd;
  double error = 0;
  for (int point = 0; point < points; ++point) {
    const Eigen::VectorXd u = spread * sd.cwiseProduct(sample::normal(sd.size(), rng));
    const Eigen::VectorXd w = sample::normal(3 * c.kernel.trials(), rng);
    const ForceJacobian expected = force_jacobian(c.digit, c.parameters, c.plan, u);
    const auto recorded = c.kernel.record(u);
    const Eigen::VectorXd force = expected.force.reshaped(), pulled = expected.J.transpose() * w;
    const Eigen::VectorXd gradient = c.kernel.pull_back(recorded, w);
    error =
        std::max({error, (recorded.forces - force).norm() / force.norm(),
                  (gradient - pulled).cwiseProduct(sd).norm() / pulled.cwiseProduct(sd).norm()});
  }
  return error;
}

constexpr double kExact = 1e-10;  // relative: rounding times the condition of the held tip

TEST(ForceKernel, HasTheDerivativesOfMeasuredFingers) {
  std::mt19937 rng(1);
  for (const char* specimen : {"H01", "H02"}) {
    const Case c(build_problem(sample::finger_inputs("an_chao_middle", {specimen})));
    EXPECT_LT(error_against_ceres(c, 0.5, 2, rng), kExact) << specimen;
  }
}

TEST(ForceKernel, RejectsWrongShapes) {
  const Case c(build_problem(sample::finger_inputs("an_chao_middle", {"H01"})));
  const auto recorded = c.kernel.record(Eigen::VectorXd::Zero(c.kernel.coordinates()));
  EXPECT_THROW((void)c.kernel.forces(Eigen::VectorXd::Zero(3)), InputError);
  EXPECT_THROW((void)c.kernel.pull_back(recorded, Eigen::VectorXd::Zero(3)), InputError);
}

}  // namespace
}  // namespace thenar
