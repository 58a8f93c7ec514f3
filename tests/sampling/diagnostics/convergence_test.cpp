// Tests for sampling/diagnostics/convergence.cpp: R-hat, effective sample sizes, Monte Carlo
// errors.

#include "sampling/diagnostics/convergence.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/special_functions.h"
#include "sampling/diagnostics/effective_sample_size.h"
#include "sampling/diagnostics/order_statistics.h"
#include "tests/matrix_near.h"
#include "tests/sampling/diagnostics/reference_chains.h"

namespace thenar {
namespace {

using sample::autoregressive;
using sample::reference_chains;

/// Computed with ArviZ 0.17.1 from the chains of reference_chains(); variance with ddof 1.
struct Reference {
  double phi, shift;
  double mean, variance, rank_r_hat, split_r_hat, bulk_ess, tail_ess, median_ess, mean_mcse;
};
constexpr Reference kReferences[] = {
    {0, 0, 0.012093268499, 3.270032576547, 1.0017828013, 1.0013644166, 1919.339951, 1851.271029,
     1836.610998, 0.0412277446},
    {0.6, 0, 0.027798516325, 5.176140950852, 1.0129706396, 1.0121791768, 490.199225, 908.838525,
     596.054791, 0.1017772128},
    {0.6, 1.5, 0.402798516325, 5.688390389856, 1.0715818322, 1.0676968853, 63.042399, 256.463233,
     63.797010, 0.2838858809}};

TEST(Convergence, ReferenceChainsAreTheirs) {
  const Eigen::MatrixXd x = reference_chains(0, 0);
  EXPECT_NEAR(x(0, 0), -10.70295387, 5e-9);
  EXPECT_NEAR(x(1, 0), -2.37585566, 5e-9);
  EXPECT_NEAR(x(2, 0), 0.41110416, 5e-9);
}

TEST(Convergence, EqualsArviZToAllPrintedDigits) {
  for (const Reference& expected : kReferences) {
    const Eigen::MatrixXd x = reference_chains(expected.phi, expected.shift);
    const Estimate of = estimate("x", x, {0, 1, 2, 3});
    // Half a unit of the last printed digit, and rounding.
    const double digits12 = 5.1e-13, digits10 = 5.1e-11, digits6 = 5.1e-7;
    EXPECT_NEAR(of.mean, expected.mean, digits12);
    EXPECT_NEAR(of.sd * of.sd, expected.variance, digits12);
    EXPECT_NEAR(of.r_hat, expected.rank_r_hat, digits10);
    EXPECT_NEAR(split_r_hat(x), expected.split_r_hat, digits10);
    EXPECT_NEAR(of.bulk_ess, expected.bulk_ess, digits6);
    EXPECT_NEAR(of.tail_ess, expected.tail_ess, digits6);
    EXPECT_NEAR(quantile_ess(x, 0.5), expected.median_ess, digits6);
    EXPECT_NEAR(of.mcse_mean, expected.mean_mcse, digits10);
  }
}

// Halves (1, 3), (2, 4), (5, 5), (6, 8): means 2, 3, 5, 7 and variances 2, 2, 0, 2.
TEST(Convergence, SplitRHatByHand) {
  Eigen::MatrixXd x(4, 2);
  x << 1, 5, 3, 5, 2, 6, 4, 8;
  // About their mean, the means have the sum of squares 4 + 9 + 25 + 49 - 17^2 / 4 = 14.75.
  const double between = 2 * 14.75 / 3, within = 1.5;
  EXPECT_NEAR(split_r_hat(x), std::sqrt((between / within + 1) / 2), 1e-15);
}

// Independent normal draws: sd / sqrt(2 N) for the sd, sqrt(pi / 2 / N) for the median. The latter
// is read from the width of sqrt(N) = 200 spacings of draws, itself uncertain by 7 %: 3 sds.
TEST(Convergence, ErrorsOfIndependentNormalDraws) {
  const Eigen::MatrixXd x = autoregressive(0, 10000, 4);
  const double n = 40000;
  EXPECT_NEAR(mean_mcse(x) * std::sqrt(n), 1, 0.05);
  EXPECT_NEAR(sd_mcse(x) * std::sqrt(2 * n), 1, 0.05);
  EXPECT_NEAR(quantile_mcse(x, 0.5) * std::sqrt(n * 2 / M_PI), 1, 0.21);
}

// Beta(a, 1) has the distribution function x^a, Beta(1, b) has 1 - (1 - x)^b.
TEST(Convergence, BetaQuantilesByHand) {
  for (const double p : {0.1586553, 0.5, 0.999}) {
    EXPECT_NEAR(beta_quantile(p, 250, 1), std::pow(p, 1.0 / 250), 1e-13);
    EXPECT_NEAR(beta_quantile(p, 1, 40), 1 - std::pow(1 - p, 1.0 / 40), 1e-13);
  }
}

// Uniform draws: m2 = 1/12, m4 = 1/80, so the sd's error is sqrt(1/180 / N) / (2 sqrt(1/12)), a
// third less than the normal formula would say.
TEST(Convergence, SdErrorNeedsNoNormality) {
  RandomStream random(1, 0, 0);
  const Eigen::MatrixXd x =
      Eigen::MatrixXd::NullaryExpr(10000, 4, [&] { return random.uniform(); });
  const double expected = std::sqrt(1.0 / 180 / 40000) / (2 * std::sqrt(1.0 / 12));
  EXPECT_NEAR(sd_mcse(x) / expected, 1, 0.03);
}

// The spread of many runs' estimates is what the errors promise.
TEST(Convergence, ErrorsPredictTheSpreadOfRuns) {
  const int runs = 400;
  Eigen::ArrayXd means(runs), medians(runs), errors(runs), median_errors(runs);
  for (int run = 0; run < runs; ++run) {
    const Eigen::MatrixXd x = autoregressive(0.5, 250, 4, 100 + run);
    means[run] = x.mean();
    medians[run] = quantile(sorted(x), 0.5);
    errors[run] = mean_mcse(x);
    median_errors[run] = quantile_mcse(x, 0.5);
  }
  const double share = 0.15;  // 4 sds of a standard deviation estimated from 400: 4 / sqrt(800)
  EXPECT_NEAR(std::sqrt(means.square().mean()) / errors.mean(), 1, share);
  EXPECT_NEAR(std::sqrt(medians.square().mean()) / median_errors.mean(), 1, share);
}

// Folding sees chains that agree in place and not in spread.
TEST(Convergence, FoldedRHatSeesUnequalSpread) {
  Eigen::MatrixXd x = autoregressive(0, 1000, 4);
  x.col(3) *= 3;
  EXPECT_LT(split_r_hat(x), 1.01);
  EXPECT_GT(rank_r_hat(x), 1.05);
}

// Ranks do not care about infinite variance; a monotone map changes nothing.
TEST(Convergence, RankRHatIsInvariantUnderMonotoneMaps) {
  const Eigen::MatrixXd x = reference_chains(0.6, 1.5);
  EXPECT_DOUBLE_EQ(bulk_ess(x), bulk_ess(x.array().exp().matrix()));
}

TEST(Convergence, StuckApartIsInfinite) {
  Eigen::MatrixXd x(10, 2);
  x << Eigen::VectorXd::Zero(10), Eigen::VectorXd::Ones(10);
  EXPECT_TRUE(std::isinf(rank_r_hat(x)));
  EXPECT_TRUE(std::isinf(split_r_hat(x)));
  EXPECT_LE(bulk_ess(x), 5);
}

TEST(Convergence, ConstantOrBrokenDrawsCannotBeJudged) {
  Eigen::MatrixXd x = Eigen::MatrixXd::Constant(10, 2, 3);
  for (const double last :
       {3.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    x(9, 1) = last;
    for (const double figure :
         {split_r_hat(x), rank_r_hat(x), bulk_ess(x), tail_ess(x), mean_ess(x), sd_ess(x),
          quantile_ess(x, 0.5), mean_mcse(x), sd_mcse(x), quantile_mcse(x, 0.5)})
      EXPECT_TRUE(std::isnan(figure)) << last;
  }
}

TEST(Convergence, TooFewDrawsAreRefused) {
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(3, 4);
  EXPECT_THROW((void)rank_r_hat(x), InputError);
  EXPECT_THROW((void)tail_ess(x), InputError);
  EXPECT_THROW((void)mean_ess(Eigen::MatrixXd(10, 0)), InputError);
}

/// Walkers 0 .. 9 are group 0, and so on.
std::vector<int> tens(int chains) {
  std::vector<int> group(chains);
  for (int chain = 0; chain < chains; ++chain) group[chain] = chain / 10;
  return group;
}

// Walkers of an ensemble mix, ensembles do not: only R-hat over groups can see it clearly.
TEST(Convergence, RHatOverGroupsSeesEnsemblesApart) {
  Eigen::MatrixXd x = autoregressive(0, 500, 40);
  for (int chain = 0; chain < 40; ++chain) x.col(chain).array() += chain < 10 ? 0.5 : 0.0;
  std::vector<int> alone(40);
  for (int chain = 0; chain < 40; ++chain) alone[chain] = chain;
  const double apart = estimate("x", x, tens(40)).r_hat;
  EXPECT_GE(apart, estimate("x", x, alone).r_hat);
  EXPECT_GT(apart, 1.02);
}

// Walkers that do all the same are worth one chain, whatever each alone looks like.
TEST(Convergence, WalkersInStepAreWorthOneChain) {
  const Eigen::MatrixXd leaders = autoregressive(0, 2000, 4);
  Eigen::MatrixXd x(2000, 40);
  for (int chain = 0; chain < 40; ++chain) x.col(chain) = leaders.col(chain / 10);
  const Estimate of = estimate("x", x, tens(40));
  EXPECT_GT(bulk_ess(x), 60000);  // chains alone are deceived
  EXPECT_NEAR(of.bulk_ess / bulk_ess(leaders), 1, 0.02);
  EXPECT_NEAR(of.tail_ess / tail_ess(leaders), 1, 0.02);
  EXPECT_NEAR(of.mcse_mean / mean_mcse(leaders), 1, 0.02);
}

}  // namespace
}  // namespace thenar
