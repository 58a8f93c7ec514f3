// Tests for sampling/diagnostics/uniform_ranks.cpp: bands and p-values of uniform ranks.

#include "sampling/diagnostics/uniform_ranks.h"

#include <cmath>

#include <gtest/gtest.h>

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
    if ((count.array() >= band.low.array() && count.array() <= band.high.array()).all()) ++inside;
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

}  // namespace
}  // namespace thenar
