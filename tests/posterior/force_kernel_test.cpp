// Tests for posterior/force_kernel.cpp: forces and their adjoint against Ceres' derivatives.

#include "posterior/force_kernel.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"
#include "tests/posterior/thumb_scene.h"

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

TEST(ForceKernel, HasTheDerivativesOfTheThumbScene) {
  std::mt19937 rng(2);
  EXPECT_LT(error_against_ceres(Case(sample::thumb_problem()), 0.2, 5, rng), kExact);
}

// What thumb_scene.h promises to samplers.
TEST(ThumbScene, IsAsIllConditionedAsThumbsAre) {
  const FitProblem problem = sample::thumb_problem();
  ASSERT_EQ(problem.size(), 20);
  ASSERT_EQ(problem.data_rows(), 54);
  const Solution mode = solve(least_squares(problem), Eigen::VectorXd::Zero(20));
  const Eigen::VectorXd sigma =
      problem.evaluate(mode.z, WithJacobian::kYes).J.jacobiSvd().singularValues();
  const double condition = std::pow(sigma[0] / sigma[19], 2);
  EXPECT_GT(condition, 1e7);
  EXPECT_LT(condition, 1e8);
}

TEST(ForceKernel, RejectsWrongShapes) {
  const Case c(build_problem(sample::finger_inputs("an_chao_middle", {"H01"})));
  const auto recorded = c.kernel.record(Eigen::VectorXd::Zero(c.kernel.coordinates()));
  EXPECT_THROW((void)c.kernel.forces(Eigen::VectorXd::Zero(3)), InputError);
  EXPECT_THROW((void)c.kernel.pull_back(recorded, Eigen::VectorXd::Zero(3)), InputError);
}

}  // namespace
}  // namespace thenar
