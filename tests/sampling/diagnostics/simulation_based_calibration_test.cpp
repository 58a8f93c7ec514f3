// Tests for sampling/diagnostics/: rank bands and simulation-based calibration.

#include "sampling/diagnostics/simulation_based_calibration.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"

namespace thenar {
namespace {

Eigen::VectorXi uniform_ranks(int ranks, int draws, unsigned seed) {
  RandomStream random(seed, 0, 0);
  return Eigen::VectorXi::NullaryExpr(ranks, [&] { return random.index(draws + 1); });
}

// Four ranks of 0 or 1, all 0: as rare as all 1, and nothing is rarer: 2 / 16.
TEST(UniformRanks, FourCoinsByHand) {
  EXPECT_NEAR(uniform_rank_p(Eigen::Vector4i(0, 0, 0, 0), 1, 1), 0.125, 1e-12);
  EXPECT_NEAR(uniform_rank_p(Eigen::Vector4i(0, 1, 0, 1), 1, 1), 1, 1e-12);
}

// Two ranks of 0, 1, 2, both 0: its tail of 1/9 is shared with both 2 alone.
TEST(UniformRanks, TwoOfThreeByHand) {
  EXPECT_NEAR(uniform_rank_p(Eigen::Vector2i(0, 0), 2, 2), 2.0 / 9, 1e-12);
  EXPECT_NEAR(uniform_rank_p(Eigen::Vector2i(2, 2), 2, 2), 2.0 / 9, 1e-12);
}

TEST(UniformRanks, HoldsUniformRanksAsOftenAsPromised) {
  const int ranks = 200, draws = 63, trials = 2000;
  const RankBand band = uniform_rank_band(ranks, draws, 50, 0.9);
  int inside = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::VectorXi count = count_below(uniform_ranks(ranks, draws, trial), band.below);
    inside += (count.array() >= band.low.array() && count.array() <= band.high.array()).all();
  }
  const double share = double(inside) / trials, error = std::sqrt(0.09 / trials);
  EXPECT_GT(share, 0.9 - 4 * error);
  EXPECT_LT(share, 0.92 + 4 * error);  // counts are whole: the level is met with some to spare
  EXPECT_GT(band.pointwise, 0.98);
}

// p-values of uniform ranks are uniform: 10 % of them below 0.1, and none of them zero.
TEST(UniformRanks, PValuesAreUniform) {
  const int trials = 1000;
  Eigen::ArrayXd p(trials);
  for (int trial = 0; trial < trials; ++trial)
    p[trial] = uniform_rank_p(uniform_ranks(100, 31, trial), 31, 20);
  EXPECT_NEAR((p < 0.1).cast<double>().mean(), 0.1, 4 * std::sqrt(0.09 / trials) + 0.01);
  EXPECT_NEAR((p < 0.5).cast<double>().mean(), 0.5, 4 * std::sqrt(0.25 / trials) + 0.02);
}

TEST(RankOfTruth, CountsDrawsBelow) {
  const Eigen::Vector4d draws(1, 2, 2, 3);
  EXPECT_EQ(rank_of_truth(0, draws), 0);
  EXPECT_EQ(rank_of_truth(2.5, draws), 3);
  EXPECT_EQ(rank_of_truth(2, draws), 2);
  EXPECT_THROW((void)rank_of_truth(std::nan(""), draws), InputError);
}

// Of 0 .. 99 in two chains, ten draws from the middles of tenths: 5, 15, .. 95.
TEST(RankOfTruth, ThinsEvenlyOverAllChains) {
  const Eigen::MatrixXd x = Eigen::VectorXd::LinSpaced(100, 0, 99).reshaped(50, 2);
  EXPECT_EQ(rank_of_truth(0, x, 10), 0);
  EXPECT_EQ(rank_of_truth(14.5, x, 10), 1);
  EXPECT_EQ(rank_of_truth(94.5, x, 10), 9);
  EXPECT_EQ(rank_of_truth(98, x, 10), 10);
  EXPECT_THROW((void)rank_of_truth(0, x, 101), InputError);
}

/// mu ~ N(0, 1), five y ~ N(mu, 1): ranks of mu among 63 draws of a posterior that believes in
/// mu ~ N(prior_mean, prior_sd^2), and whose sd is stretched.
Eigen::MatrixXi conjugate_ranks(double prior_mean, double prior_sd, double stretch) {
  const int runs = 500, draws = 63;
  Eigen::MatrixXi rank(1, runs);
  for (int run = 0; run < runs; ++run) {
    RandomStream random(1, run, 0);
    const double mu = random.normal();
    double sum = prior_mean / (prior_sd * prior_sd);
    for (int i = 0; i < 5; ++i) sum += mu + random.normal();
    const double precision = 1 / (prior_sd * prior_sd) + 5;
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(
        draws, [&] { return sum / precision + stretch * random.normal() / std::sqrt(precision); });
    rank(0, run) = rank_of_truth(mu, x);
  }
  return rank;
}

TEST(Calibration, PassesAnExactPosterior) {
  const RankCalibration of = judge_calibration({"mu"}, conjugate_ranks(0, 1, 1), 63);
  EXPECT_THAT(of.warnings, testing::IsEmpty());
  EXPECT_GT(of.parameters[0].band_p, 0.005);
  EXPECT_GT(of.parameters[0].chi_square_p, 0.005);
}

TEST(Calibration, FailsAWrongPriorSd) {
  const RankCalibration of = judge_calibration({"mu"}, conjugate_ranks(0, 0.3, 1), 63);
  ASSERT_EQ(of.warnings.size(), 1U);
  EXPECT_THAT(of.warnings[0], testing::StartsWith("ranks of mu are not uniform (p = "));
  EXPECT_THAT(of.warnings[0], testing::EndsWith("below 0.005): its posterior is too narrow"));
}

TEST(Calibration, TellsWhatIsWrong) {
  const auto shape = [](const Eigen::MatrixXi& rank) {
    return judge_calibration({"mu"}, rank, 63).parameters[0].shape;
  };
  EXPECT_EQ(shape(conjugate_ranks(0, 1, 1.5)), "too wide");
  EXPECT_EQ(shape(conjugate_ranks(0, 1, 0.7)), "too narrow");
  EXPECT_EQ(shape(conjugate_ranks(2, 1, 1)), "too high");
  EXPECT_EQ(shape(conjugate_ranks(-2, 1, 1)), "too low");
}

TEST(Calibration, RefusesRanksOutOfRange) {
  EXPECT_THROW((void)judge_calibration({"mu"}, Eigen::MatrixXi::Constant(1, 10, 64), 63),
               InputError);
  EXPECT_THROW((void)judge_calibration({}, Eigen::MatrixXi::Zero(1, 10), 63), InputError);
}

}  // namespace
}  // namespace thenar
