// Tests for kinematics_fit/fit_residuals.cpp: what a fit minimises, and what it recovers.

#include "kinematics_fit/fit_residuals.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::between_sds;
using sample::draw_person;
using sample::fit_precisely;
using sample::FitSetup;
using sample::kAxes;
using sample::kAxesAndPaths;
using sample::kFriction;
using sample::middle_finger;
using sample::population_sds;

TEST(FitResiduals, RecoversPredictionsAndIdentifiableParametersWithoutNoise) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  Experiment& experiment = setup.experiments.front();
  experiment.sd_floor = 1e-6;  // [N]: the data outweigh the prior a million times
  experiment.sd_relative = 0;
  std::mt19937 rng(5);
  const VectorXd truth =
      draw_person(setup.parameters, VectorXd::Zero(setup.parameters.coordinates()), rng);
  sample::simulate(setup, truth, 0, rng, experiment);
  const FitProblem problem = setup.problem();
  const Solution found = fit_precisely(problem);
  ASSERT_EQ(found.status, Status::kSolved) << found.message;

  const Eigen::Matrix3Xd force = predict_trials(problem, found.z, 0);
  EXPECT_LT((force - problem.plans()[0].force).cwiseAbs().maxCoeff(), 1e-8);  // [N]

  const VectorXd total = sample::person_sds(setup.parameters);
  const VectorXd z_true = truth.cwiseQuotient(total);
  int identifiable = 0;
  const Covariance covariance = posterior_covariance(problem, found.z);
  for (Eigen::Index i = 0; i < z_true.size(); ++i) {
    if (covariance.learnt[i].sd > 1e-3) continue;
    EXPECT_NEAR(found.z[i], z_true[i], 1e-4) << covariance.learnt[i].name;
    ++identifiable;
  }
  EXPECT_GE(identifiable, 8);  // at least the axes
}

// One specimen, written with population and deviation apart, has the same most probable
// population: p = sd^2 / (sd^2 + between^2) u.
TEST(FitResiduals, OneSpecimenIsTheTwoLevelProblemSummedUp) {
  const FitSetup setup = middle_finger(kAxes);
  const FitProblem alone = setup.problem();
  const VectorXd sd = population_sds(setup.parameters), between = between_sds(setup.parameters);
  const VectorXd total = (sd.cwiseAbs2() + between.cwiseAbs2()).cwiseSqrt();
  const Eigen::Index n = sd.size();

  LeastSquares apart;
  apart.lower = VectorXd::Constant(2 * n, -100);
  apart.upper = VectorXd::Constant(2 * n, 100);
  apart.residuals = [&](const VectorXd& z, WithJacobian) {
    const VectorXd u = sd.cwiseProduct(z.head(n)) + between.cwiseProduct(z.tail(n));
    const Residuals data = fit_residuals(alone, u.cwiseQuotient(total), WithJacobian::kYes);
    const int rows = data_rows(alone);
    Residuals out{VectorXd(rows + 2 * n), Eigen::MatrixXd(rows + 2 * n, 2 * n)};
    out.r << data.r.head(rows), z;
    const Eigen::MatrixXd by_u = data.J.topRows(rows) * total.cwiseInverse().asDiagonal();
    out.J.topLeftCorner(rows, n) = by_u * sd.asDiagonal();
    out.J.topRightCorner(rows, n) = by_u * between.asDiagonal();
    out.J.bottomRows(2 * n).setIdentity();
    return out;
  };
  SolveOptions options;
  options.tolerance = 1e-15;
  const Solution two_level = solve(apart, VectorXd::Zero(2 * n), options);
  const Solution one = fit_precisely(alone);
  EXPECT_NEAR(two_level.cost, one.cost, 1e-9 * one.cost);
  EXPECT_TRUE(matrix_near(displacements(alone.coordinates(), one.z, -1),
                          sd.cwiseProduct(two_level.z.head(n)),
                          1e-5));  // [rad]
  const VectorXd person =
      sd.cwiseProduct(two_level.z.head(n)) + between.cwiseProduct(two_level.z.tail(n));
  EXPECT_TRUE(matrix_near(displacements(alone.coordinates(), one.z, 0), person, 1e-5));
}

TEST(FitResiduals, SlopesOfSpecimensNearBoundsAreThoseOfDifferences) {
  FitSetup setup = middle_finger(kFriction + kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  std::mt19937 rng(8);
  VectorXd z = sample::normal(problem.size(), rng);
  const Residuals at = fit_residuals(problem, z, WithJacobian::kYes);
  constexpr double kStep = 1e-5;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const VectorXd step = kStep * VectorXd::Unit(z.size(), i);
    const VectorXd slope = (fit_residuals(problem, z + step, WithJacobian::kNo).r -
                            fit_residuals(problem, z - step, WithJacobian::kNo).r) /
                           (2 * kStep);
    EXPECT_TRUE(matrix_near(at.J.col(i), slope, 1e-7 * std::max(1.0, slope.cwiseAbs().maxCoeff())));
  }
}

// Blocks of specimens are another order of the same sums.
TEST(FitResiduals, BlocksHaveTheDenseAnswer) {
  FitSetup setup = middle_finger(kAxesAndPaths + kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  setup.experiments.push_back(sample::experiment("B01"));
  const FitProblem problem = setup.problem();
  LeastSquares blocks = least_squares(problem), dense = blocks;
  ASSERT_FALSE(blocks.parts.empty());
  dense.parts.clear();
  SolveOptions options;
  options.tolerance = 1e-15;
  const VectorXd start = VectorXd::Zero(problem.size());
  const Solution a = solve(blocks, start, options), b = solve(dense, start, options);
  EXPECT_EQ(a.status, Status::kSolved) << a.message;
  EXPECT_NEAR(a.cost, b.cost, 1e-10 * b.cost);
  EXPECT_TRUE(matrix_near(a.z, b.z, 1e-4));
  EXPECT_LT(a.newton_step, 0.01);
  const CostDerivatives one = cost_derivatives(blocks, a.z), other = cost_derivatives(dense, a.z);
  EXPECT_NEAR(one.cost, other.cost, 1e-11 * other.cost);
  EXPECT_TRUE(matrix_near(one.gradient, other.gradient, 1e-8));
  const Eigen::MatrixXd J = fit_residuals(problem, a.z, WithJacobian::kYes).J;
  const Covariance covariance = posterior_covariance(problem, a.z);
  const Eigen::MatrixXd C = (J.transpose() * J).inverse();
  for (int specimen = 0; specimen < 3; ++specimen) {
    const std::vector<int> on = problem.coordinates().entries_of_specimen(specimen);
    EXPECT_TRUE(matrix_near(covariance.C.block_entries(specimen), C(on, on), 1e-7));
  }
}

TEST(RobustLoss, JacobianIsExactForSmallAndLargeResiduals) {
  for (const double offset : {1e-7, 1e-3, 1.0, 1e4}) {  // [N] of the measured forces
    FitSetup setup = middle_finger(kAxes);
    std::mt19937 rng(2);
    sample::simulate(setup, VectorXd::Zero(8), 0, rng, setup.experiments.front());
    for (Trial& trial : setup.experiments.front().trials) trial.force.array() += offset;
    const FitProblem problem = setup.problem(2.0);
    const VectorXd z = VectorXd::Zero(problem.size());
    const Eigen::MatrixXd J = fit_residuals(problem, z, WithJacobian::kYes).J;
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      const VectorXd step = 1e-6 * VectorXd::Unit(z.size(), i);
      const VectorXd difference = (fit_residuals(problem, z + step, WithJacobian::kNo).r -
                                   fit_residuals(problem, z - step, WithJacobian::kNo).r) /
                                  2e-6;
      EXPECT_TRUE(matrix_near(J.col(i), difference, 1e-6)) << "offset " << offset;
    }
  }
}

TEST(RobustLoss, IsCauchys) {
  FitSetup setup = middle_finger(kAxes);
  const VectorXd z = VectorXd::Zero(setup.parameters.coordinates());
  const VectorXd plain = fit_residuals(setup.problem(), z, WithJacobian::kNo).r;
  const VectorXd robust = fit_residuals(setup.problem(2.0), z, WithJacobian::kNo).r;
  for (Eigen::Index i = 0; i < 24; ++i)
    EXPECT_NEAR(robust.segment<3>(3 * i).squaredNorm(),
                4 * std::log1p(plain.segment<3>(3 * i).squaredNorm() / 4), 1e-10);
  const VectorXd wide = fit_residuals(setup.problem(1e6), z, WithJacobian::kNo).r;
  EXPECT_TRUE(matrix_near(wide, plain, 1e-8));  // the limit of no robustness
}

TEST(RobustLoss, OneGrossOutlierHardlyMovesTheFit) {
  FitSetup setup = middle_finger(kAxes);
  std::mt19937 rng(4);
  sample::simulate(setup, VectorXd::Zero(8), 0.05, rng, setup.experiments.front());
  FitSetup spoilt = setup;
  spoilt.experiments.front().trials[3].force += Eigen::Vector3d(5, -5, 5);  // [N]
  const double plain =
      (fit_precisely(spoilt.problem()).z - fit_precisely(setup.problem()).z).norm();
  const double robust =
      (fit_precisely(spoilt.problem(2.0)).z - fit_precisely(setup.problem(2.0)).z).norm();
  EXPECT_LT(robust, 0.1 * plain);
}

}  // namespace
}  // namespace thenar
