// Tests for posterior/find_modes.cpp.

#include "posterior/find_modes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

LeastSquares problem_of(int n, std::function<VectorXd(const VectorXd&)> r,
                        std::function<MatrixXd(const VectorXd&)> J) {
  LeastSquares problem;
  problem.lower = VectorXd::Constant(n, -kInfinity);
  problem.upper = VectorXd::Constant(n, kInfinity);
  problem.residuals = [r, J](const VectorXd& z, WithJacobian want) {
    return Residuals{r(z), want == WithJacobian::kYes ? J(z) : MatrixXd()};
  };
  return problem;
}

/// r = (2 (z_0^2 - 4), (z_0 - 2) / 10, z_1 - 1/2): no residual at (2, 1/2). Near (-2, 1/2), to
/// first order in d = z_0 + 2:  64 d = 0.04, so d = 0.000625, and the cost is 0.08 - 0.0000125.
LeastSquares two_wells() {
  return problem_of(
      2,
      [](const VectorXd& z) {
        return Vector3d(2 * (z[0] * z[0] - 4), (z[0] - 2) / 10, z[1] - 0.5);
      },
      [](const VectorXd& z) { return (MatrixXd(3, 2) << 4 * z[0], 0, 0.1, 0, 0, 1).finished(); });
}

/// Only the sum of both coordinates acts; a prior of the given weight on each.
LeastSquares ridge(double weight) {
  MatrixXd J(3, 2);
  J << 100, 100, weight, 0, 0, weight;
  return problem_of(
      2, [J](const VectorXd& z) { return VectorXd(J * z - Vector3d(100, 0, 0)); },
      [J](const VectorXd&) { return J; });
}

TEST(FindModes, FindsBothWellsAndWeighsThem) {
  const FoundModes found = find_modes(two_wells());
  ASSERT_EQ(found.modes.size(), 2);
  EXPECT_TRUE(matrix_near(found.modes[0].z, Vector2d(2, 0.5), 1e-5));
  EXPECT_TRUE(matrix_near(found.modes[1].z, Vector2d(-2 + 0.000625, 0.5), 1e-5));
  EXPECT_NEAR(found.modes[0].cost, 0, 1e-9);
  EXPECT_NEAR(found.modes[1].cost, 0.08 - 1.25e-5, 1e-7);
  const Vector2d variance(1 / 64.01, 1);
  EXPECT_TRUE(
      matrix_near(found.modes[0].curvature->covariance(), MatrixXd(variance.asDiagonal()), 1e-5));
  // exp(-cost) times the root of the covariance: 8.0006 against 4 (2 - 0.000625) wide.
  const double other = std::exp(-0.0799875) * std::sqrt(64.01 / (std::pow(7.9975, 2) + 0.01));
  EXPECT_NEAR(found.modes[0].laplace_mass, 1 / (1 + other), 1e-5);
  EXPECT_NEAR(found.modes[1].laplace_mass, other / (1 + other), 1e-5);
}

TEST(FindModes, KeepsEverySearchAndItsStatus) {
  ModeSearchOptions search;
  search.starts = 6;
  search.extra_starts = Vector2d(-3, 0);
  const FoundModes found = find_modes(two_wells(), search);
  ASSERT_EQ(found.searches.size(), 8);  // one given, six drawn, one global
  int hits = 0;
  for (const Mode& mode : found.modes) {
    hits += mode.hits;
    EXPECT_EQ(mode.status, Status::kSolved);
  }
  EXPECT_EQ(hits, 8);
  EXPECT_EQ(found.mode_of_search[0], 1);  // down the nearer well
  // The global search, without slopes, looks at far more points than a descent.
  EXPECT_GT(found.searches[7].evaluations, 10 * found.searches[0].evaluations);
}

TEST(FindModes, EndsAlongARidgeAreOneMode) {
  for (const double weight : {1.0, 1e-3, 0.0}) {
    const FoundModes found = find_modes(ridge(weight));
    ASSERT_EQ(found.modes.size(), 1) << weight;
    EXPECT_TRUE(found.modes[0].curvature->covariance().allFinite()) << weight;
  }
}

// 1 / weight^2 across, 1 / (20000 + weight^2) along the sum.
TEST(FindModes, CovarianceIsThatOfTheNormalAtTheMode) {
  const MatrixXd C = find_modes(ridge(0.1)).modes[0].curvature->covariance();
  const double across = 1 / 0.01, along = 1 / (20000 + 0.01);
  const MatrixXd expected =
      (MatrixXd(2, 2) << across + along, along - across, along - across, across + along)
          .finished() /
      2;
  EXPECT_TRUE(matrix_near(C, expected, 1e-6));
}

TEST(FindModes, SurvivesRegionsWhereTheModelBreaks) {
  LeastSquares problem = two_wells();
  const auto whole = problem.residuals;
  problem.residuals = [whole](const VectorXd& z, WithJacobian want) {
    Residuals out = whole(z, want);
    if (z[0] < 0) out.r.setConstant(std::numeric_limits<double>::quiet_NaN());
    return out;
  };
  const FoundModes found = find_modes(problem);
  ASSERT_EQ(found.modes.size(), 1);
  EXPECT_NEAR(found.modes[0].z[0], 2, 1e-5);
  int failed = 0;
  for (std::size_t i = 0; i < found.searches.size(); ++i) {
    if (found.mode_of_search[i] >= 0) continue;
    ++failed;
    EXPECT_EQ(found.searches[i].message, "residuals at the start are not finite");
  }
  EXPECT_GT(failed, 2);  // of 16 draws, half are below zero
}

TEST(FindModes, HoldsWhatBoundsHold) {
  LeastSquares problem = two_wells();
  problem.lower[1] = problem.upper[1] = 3;
  const FoundModes found = find_modes(problem);
  ASSERT_EQ(found.modes.size(), 2);
  EXPECT_EQ(found.modes[0].z[1], 3);
  EXPECT_EQ(found.modes[0].curvature->covariance()(1, 1), 0);
  EXPECT_EQ(dispersed_starts(problem, found.modes, 5).row(1).maxCoeff(), 3);
}

TEST(FindModes, SameSeedSameSearches) {
  ModeSearchOptions search;
  search.global_searches = 0;
  const FoundModes a = find_modes(two_wells(), search), b = find_modes(two_wells(), search);
  search.seed = 2;
  const FoundModes c = find_modes(two_wells(), search);
  EXPECT_EQ(a.mode_of_search, b.mode_of_search);
  EXPECT_EQ(a.modes[0].z, b.modes[0].z);
  EXPECT_NE(a.mode_of_search, c.mode_of_search);
}

TEST(FindModes, StopsWhenAsked) {
  int asked = 0;
  ModeSearchOptions search;
  search.progress.stop_requested = [&] { return ++asked > 3; };
  const FoundModes found = find_modes(two_wells(), search);
  EXPECT_EQ(found.status, Status::kStopped);
  EXPECT_EQ(found.searches.size(), 3);
  EXPECT_FALSE(found.modes.empty());
}

TEST(FindModes, RefusesNonsense) {
  ModeSearchOptions search;
  search.extra_starts = Vector3d::Zero();
  EXPECT_THROW((void)find_modes(two_wells(), search), InputError);
  EXPECT_THROW((void)dispersed_starts(two_wells(), {}, 4), InputError);
}

TEST(DispersedStarts, HaveTheInflatedCovariance) {
  const LeastSquares problem = ridge(0.1);
  const FoundModes found = find_modes(problem);
  constexpr int kStarts = 4000;
  const MatrixXd starts = dispersed_starts(problem, found.modes, kStarts, 3);
  const MatrixXd off = starts.colwise() - found.modes[0].z;
  // In units of what is wanted the covariance is I; its entries have sds of at most sqrt(2 / N).
  const MatrixXd wanted = 9 * found.modes[0].curvature->covariance();
  const MatrixXd L = wanted.llt().matrixL();
  const MatrixXd white = L.triangularView<Eigen::Lower>().solve(off);
  EXPECT_TRUE(matrix_near(white * white.transpose() / kStarts, MatrixXd::Identity(2, 2),
                          5 * std::sqrt(2.0 / kStarts)));
}

// Masses of about 0.52 and 0.48: any four columns in a row have both modes.
TEST(DispersedStarts, VisitEveryMode) {
  const LeastSquares problem = two_wells();
  const MatrixXd starts = dispersed_starts(problem, find_modes(problem).modes, 40);
  for (int k = 0; k + 4 <= 40; ++k) {
    EXPECT_GT(starts.row(0).segment(k, 4).maxCoeff(), 0) << k;
    EXPECT_LT(starts.row(0).segment(k, 4).minCoeff(), 0) << k;
  }
  EXPECT_NEAR((starts.row(0).array() > 0).cast<double>().mean(), 0.51, 0.03);
}

// At (-2, 1/2) the residual of (z_0 - 2) / 0.1 is 40: the well has e^-800 of the other's mass.
TEST(DispersedStarts, LeaveOutModesThatNoRunWouldVisit) {
  const LeastSquares problem = problem_of(
      1, [](const VectorXd& z) { return Vector2d(200 * (z[0] * z[0] - 4), 10 * (z[0] - 2)); },
      [](const VectorXd& z) { return Vector2d(400 * z[0], 10); });
  const FoundModes found = find_modes(problem);
  ASSERT_EQ(found.modes.size(), 2);
  EXPECT_GT(dispersed_starts(problem, found.modes, 50).minCoeff(), 1.9);
}

TEST(DispersedStarts, StayOffBounds) {
  LeastSquares problem = two_wells();
  problem.lower = Vector2d(-2.1, 0.4);
  problem.upper = Vector2d(2.1, kInfinity);
  const MatrixXd starts = dispersed_starts(problem, find_modes(problem).modes, 200, 5);
  EXPECT_GE(starts.row(0).minCoeff(), -2.1 + 0.042 - 1e-12);
  EXPECT_LE(starts.row(0).maxCoeff(), 2.1 - 0.042 + 1e-12);
  EXPECT_GE(starts.row(1).minCoeff(), 0.41 - 1e-12);
}

}  // namespace
}  // namespace thenar
