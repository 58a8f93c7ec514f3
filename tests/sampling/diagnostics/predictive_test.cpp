// Tests for sampling/diagnostics/predictive.cpp.

#include "sampling/diagnostics/predictive.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"
#include "base/special_functions.h"

namespace thenar {
namespace {

constexpr int kNumbers = 300, kDraws = 2000;

/// Everything is N(0, 1), and the model knows it exactly.
Replicates sure_replicates(double sd = 1) {
  RandomStream random(1, 0, 0);
  return {Eigen::MatrixXd::Zero(kNumbers, kDraws),
          Eigen::MatrixXd::NullaryExpr(kNumbers, kDraws, [&] { return sd * random.normal(); }),
          Eigen::MatrixXd::Constant(kNumbers, 1, sd)};
}

Eigen::VectorXd measured() {
  RandomStream random(2, 0, 0);
  return Eigen::VectorXd::NullaryExpr(kNumbers, [&] { return random.normal(); });
}

TEST(Predictive, KnowsTheTailOfChiSquare) {
  const Eigen::VectorXd y = measured();
  const PredictiveCheck of = check_predictive(y, sure_replicates());
  // With nothing to learn, p is the tail of chi-square; 2000 draws know it to 0.011.
  EXPECT_NEAR(of.mean_chi_square, y.squaredNorm(), 1e-9);
  EXPECT_NEAR(of.p, chi_square_tail(y.squaredNorm(), kNumbers), 4 * 0.011);
  ASSERT_EQ(of.trial_p.size(), kNumbers / 3);
  for (int t = 0; t < kNumbers / 3; ++t)
    EXPECT_NEAR(of.trial_p[t], chi_square_tail(y.segment(3 * t, 3).squaredNorm(), 3), 4 * 0.011);
  for (const Coverage& interval : of.coverage)
    EXPECT_NEAR(interval.share, interval.level, 3 * interval.error);
  EXPECT_THAT(of.warnings, testing::IsEmpty());
}

// e^-x/2 is the tail of chi-square with two degrees of freedom.
TEST(Predictive, ChiSquareTailByHand) {
  EXPECT_NEAR(chi_square_tail(3, 2), std::exp(-1.5), 1e-15);
  EXPECT_EQ(chi_square_tail(0, 5), 1);
}

// P(|Z| < 0.6745 / 2) = 0.2641 of the numbers lie in intervals half as wide.
TEST(Predictive, TooSureAModelIsFound) {
  const PredictiveCheck of = check_predictive(measured(), sure_replicates(0.5));
  EXPECT_EQ(of.p, 0);
  EXPECT_NEAR(of.coverage[0].share, 0.2641, 4 * std::sqrt(0.2641 * 0.7359 / kNumbers));
  ASSERT_FALSE(of.warnings.empty());
  EXPECT_EQ(of.warnings[0],
            "0 % of replicated measurements are further from the model than the measured ones: the "
            "model is too sure");
}

TEST(Predictive, TooUnsureAModelIsFound) {
  const PredictiveCheck of = check_predictive(measured(), sure_replicates(2));
  EXPECT_EQ(of.p, 1);
  ASSERT_FALSE(of.warnings.empty());
  EXPECT_EQ(of.warnings[0],
            "100 % of replicated measurements are further from the model than the measured ones: "
            "the model is too unsure");
}

// Chi-square 4 of the measured numbers; of 1000 replicates 4 have 9, all others 0.
TEST(Predictive, SaysSmallSharesInPerCent) {
  Replicates of{Eigen::MatrixXd::Zero(3, 1000), Eigen::MatrixXd::Zero(3, 1000),
                Eigen::MatrixXd::Ones(3, 1)};
  of.replicated.row(0).head(4).setConstant(3);
  const PredictiveCheck check = check_predictive(Eigen::Vector3d(2, 0, 0), of);
  EXPECT_EQ(check.p, 0.004);
  ASSERT_FALSE(check.warnings.empty());
  EXPECT_EQ(check.warnings[0],
            "0.4 % of replicated measurements are further from the model than the measured ones: "
            "the model is too sure");
}

TEST(Predictive, NamesAGrossOutlier) {
  Eigen::VectorXd y = measured();
  y[3 * 41 + 1] = 10;
  const PredictiveCheck of = check_predictive(y, sure_replicates());
  EXPECT_EQ(of.trial_p[41], 0);
  EXPECT_EQ(of.rank_share[3 * 41 + 1], 1);
  EXPECT_THAT(of.warnings,
              testing::Contains("trial 42 is further off than 100 % of its replicates"));
}

// Conjugate model y_i ~ N(mu, 1), mu ~ N(0, 10^4): the posterior knows mu from the same data, which
// takes one of the chi-square's degrees of freedom.
TEST(Predictive, DrawsThatKnowTheDataFitThem) {
  const int n = 30;
  const Eigen::VectorXd y = measured().head(n).array() + 5;
  RandomStream random(3, 0, 0);
  Replicates of{Eigen::MatrixXd(n, kDraws), Eigen::MatrixXd(n, kDraws),
                Eigen::MatrixXd::Ones(n, kDraws)};
  for (int s = 0; s < kDraws; ++s) {
    of.expected.col(s).setConstant(y.mean() + random.normal() / std::sqrt(n));
    for (int i = 0; i < n; ++i) of.replicated(i, s) = of.expected(i, s) + random.normal();
  }
  // Mean over draws: sum (y - mean)^2 + n / n.
  const double expected = (y.array() - y.mean()).square().sum() + 1;
  EXPECT_NEAR(check_predictive(y, of).mean_chi_square, expected, 4 * std::sqrt(2.0 / kDraws));
}

TEST(Predictive, RefusesWhatDoesNotFit) {
  Replicates of = sure_replicates();
  EXPECT_THROW((void)check_predictive(measured().head(299), of), InputError);
  EXPECT_THROW((void)check_predictive(measured(), of, 7), InputError);
  of.sd(4, 0) = 0;
  EXPECT_THROW((void)check_predictive(measured(), of), InputError);
}

}  // namespace
}  // namespace thenar
