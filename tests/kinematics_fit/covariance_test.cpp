// Tests for kinematics_fit/covariance.cpp: how well each coordinate is known, and which never can
// be.

#include "kinematics_fit/covariance.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::between_sds;
using sample::fit_precisely;
using sample::FitSetup;
using sample::kAxes;
using sample::kAxesAndPaths;
using sample::middle_finger;
using sample::population_sds;

TEST(PosteriorCovariance, NamesWhatNoForceCanTell) {
  const FitProblem problem =
      middle_finger("[[parameter]]\nmatch='axis/MCP3_FE/*'\nstate='free'\n").problem();
  const Covariance covariance = posterior_covariance(problem, VectorXd::Zero(problem.size()));
  ASSERT_EQ(covariance.null_directions.size(), 1U);
  EXPECT_EQ(covariance.null_directions[0].text, "axis/MCP3_FE/point/along: not identifiable");
  for (const CoordinateEstimate& learnt : covariance.learnt) {
    const bool along = learnt.name == "axis/MCP3_FE/point/along";
    EXPECT_NEAR(learnt.null_share, along ? 1 : 0, 1e-9) << learnt.name;
    EXPECT_EQ(learnt.sd > 1 - 1e-9, along) << learnt.name;
  }
}

TEST(PosteriorCovariance, IsTheInverseOfTheCurvature) {
  const FitProblem problem = middle_finger(kAxesAndPaths).problem();
  const VectorXd z = VectorXd::Constant(problem.size(), 0.1);
  const Covariance covariance = posterior_covariance(problem, z);
  const Eigen::MatrixXd J = fit_residuals(problem, z, WithJacobian::kYes).J;
  EXPECT_TRUE(matrix_near(covariance.C.shared * (J.transpose() * J),
                          Eigen::MatrixXd::Identity(z.size(), z.size()), 1e-8));
  // Each parameter is learnt by 1 - C_ii; their sum is the trace of data curvature times C.
  EXPECT_NEAR(covariance.effective_parameters,
              static_cast<double>(z.size()) - covariance.C.diagonal().sum(), 1e-9);
}

// (z - truth)' C^-1 (z - truth) is chi squared: truth drawn from the prior, noise as stated.
TEST(PosteriorCovariance, EstimatesScatterAsTheirCovarianceSays) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().sd_floor = 0.02;  // [N]; small, so that the model is nearly linear
  std::mt19937 rng(11);
  constexpr int kDraws = 40;
  double chi_squared = 0, count = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const VectorXd sd = sample::person_sds(setup.parameters);
    const VectorXd z_true = sample::normal(sd.size(), rng);
    sample::simulate(setup, sd.cwiseProduct(z_true), 0.02, rng, setup.experiments.front());
    const FitProblem problem = setup.problem();
    const Solution found = fit_precisely(problem);
    const VectorXd error = found.z - z_true;
    chi_squared += error.dot(posterior_covariance(problem, found.z).C.shared.llt().solve(error));
    count += static_cast<double>(error.size());
  }
  // Four standard deviations of a chi squared of `count` degrees of freedom.
  EXPECT_NEAR(chi_squared / count, 1, 4 * std::sqrt(2 / count));
}

// What no force can tell does not hang on how exactly forces were measured.
TEST(PosteriorCovariance, FindsTheSameNullsWhateverTheNoise) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='axis/*'\nstate='free'\n[[parameter]]\n"
      "match='path/*'\nstate='free'\n");
  std::vector<std::size_t> null_directions;
  for (const double sd : {0.15, 1e-4}) {
    setup.experiments.front().sd_floor = sd;
    setup.experiments.front().sd_relative = 0;
    const FitProblem problem = setup.problem();
    const VectorXd z = VectorXd::Zero(problem.size());
    null_directions.push_back(posterior_covariance(problem, z).null_directions.size());
    const Eigen::MatrixXd J =
        fit_residuals(problem, z, WithJacobian::kYes).J.topRows(data_rows(problem));
    const VectorXd sigma = J.bdcSvd().singularValues();
    EXPECT_EQ(null_directions.back(), z.size() - (sigma.array() > 3.2e-5).count());
  }
  EXPECT_GT(null_directions[0], 0U);
}

// Directions of single specimens and of all together, no two alike. Both kinds are orthonormal with
// |J v| below the limit, so along them all |J v| < sqrt(2) limit, and no more than so many singular
// values can be (Courant and Fischer). Those far below the limit must all be found.
TEST(PosteriorCovariance, NullsOfSpecimensSpanThoseOfTheDenseJacobian) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='axis/*'\nstate='free'\n[[parameter]]\n"
      "match='path/*'\nstate='free'\n");
  setup.experiments.push_back(sample::experiment("H02"));
  setup.experiments.push_back(sample::experiment("B01"));
  const FitProblem problem = setup.problem();
  const VectorXd z = VectorXd::Zero(problem.size());
  const Eigen::MatrixXd J =
      fit_residuals(problem, z, WithJacobian::kYes).J.topRows(data_rows(problem));
  const Covariance covariance = posterior_covariance(problem, z);
  const auto count = static_cast<Eigen::Index>(covariance.null_directions.size());
  const VectorXd sigma = J.bdcSvd().singularValues();
  const double limit = std::sqrt(1e-9);
  EXPECT_LE(count, z.size() - (sigma.array() > std::sqrt(2) * limit).count());
  EXPECT_GE(count, z.size() - (sigma.array() > 0.5 * limit).count());
  Eigen::MatrixXd N(z.size(), count);
  for (Eigen::Index k = 0; k < count; ++k)
    N.col(k) = covariance.null_directions[static_cast<std::size_t>(k)].direction;
  EXPECT_TRUE(matrix_near(N.colwise().norm().transpose(), VectorXd::Ones(count), 1e-12));
  EXPECT_LT((J * N).colwise().norm().maxCoeff(), 1e-3);
  EXPECT_GT(N.bdcSvd().singularValues().minCoeff(), 1e-6);
  double shares = 0;
  for (const CoordinateEstimate& learnt : covariance.learnt) shares += learnt.null_share;
  EXPECT_NEAR(shares, static_cast<double>(count), 1e-9);  // the trace of a projection
}

TEST(PosteriorCovariance, MarksWhatSitsOnItsBound) {
  const FitProblem problem =
      middle_finger("[[parameter]]\nmatch='gain/FD?'\nstate='free'\nrange=0.01\n").problem();
  const VectorXd z = problem.coordinates().upper().cwiseProduct(Eigen::Vector2d(1, 0.5));
  const Covariance covariance = posterior_covariance(problem, z);
  EXPECT_TRUE(covariance.learnt[0].at_bound);
  EXPECT_FALSE(covariance.learnt[1].at_bound);
}

}  // namespace
}  // namespace thenar
