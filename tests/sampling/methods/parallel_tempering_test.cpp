// Tests for sampling/methods/parallel_tempering.cpp.

#include "sampling/methods/parallel_tempering.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "sampling/run/run_chains.h"
#include "tests/matrix_near.h"
#include "tests/sampling/expect_posterior.h"

namespace thenar {
namespace {

TEST(TemperatureLadder, FallsGeometricallyOrToThePrior) {
  EXPECT_TRUE(matrix_near(temperature_ladder(3, 0.01), Eigen::Vector3d(1, 0.1, 0.01), 1e-15));
  EXPECT_TRUE(matrix_near(temperature_ladder(3, 0), Eigen::Vector3d(1, 1.0 / 32, 0), 1e-15));
  EXPECT_EQ(temperature_ladder(1, 0), Eigen::VectorXd::Ones(1));
  EXPECT_THROW((void)temperature_ladder(0, 0), InputError);
  EXPECT_THROW((void)temperature_ladder(2, 1), InputError);
}

TEST(DecideSwaps, AlternatesEvenAndOddPairs) {
  const Eigen::VectorXd beta = temperature_ladder(5, 0.1);
  const Eigen::MatrixXd alike = Eigen::MatrixXd::Constant(2, 5, -3);
  const Swaps even = decide_swaps(beta, alike, 1, 0, 4), odd = decide_swaps(beta, alike, 1, 0, 5);
  for (int i = 0; i < 4; ++i)
    for (int w = 0; w < 2; ++w) {
      EXPECT_EQ(even.tried(w, i), i % 2 == 0);
      EXPECT_EQ(odd.tried(w, i), i % 2 == 1);
      EXPECT_EQ(even.exchange(w, i), i % 2 == 0);  // places of equal likelihood always change
    }
}

// By hand: (1 - 0.25) (-4 - -2) = -1.5.
TEST(DecideSwaps, ExchangesAsOftenAsTheRatioOfDensitiesSays) {
  const Eigen::Vector2d beta(1, 0.25);
  const Eigen::RowVector2d log_likelihood(-2, -4);
  constexpr int kRounds = 20000;
  SwapCounts swap_counts(2);
  for (int round = 0; round < kRounds; ++round)
    swap_counts.add(decide_swaps(beta, log_likelihood, 3, 7, 2 * round));
  const double p = std::exp(-1.5);
  EXPECT_NEAR(swap_counts.rejection_rate()[0], 1 - p, 1e-12);
  EXPECT_NEAR(swap_counts.swap_rate()[0], p, 4 * std::sqrt(p * (1 - p) / kRounds));
  EXPECT_EQ(decide_swaps(beta, Eigen::RowVector2d(-4, -2), 3, 7, 0).probability(0, 0), 1);
}

TEST(DecideSwaps, BrokenPlacesAreNeverHandedDown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd log_likelihood(5, 2);
  log_likelihood << -1, nan, -1, -kInfinity, -1, kInfinity, nan, -1e9, -kInfinity, -kInfinity;
  const Swaps swaps = decide_swaps(Eigen::Vector2d(1, 0), log_likelihood, 1, 0, 0);
  for (const int stays : {0, 1, 2, 4}) EXPECT_FALSE(swaps.exchange(stays, 0)) << stays;
  EXPECT_TRUE(swaps.exchange(3, 0));
}

TEST(DecideSwaps, DependsOnSeedGroupAndRoundAlone) {
  const Eigen::Vector2d beta(1, 0.5);
  const Eigen::MatrixXd log_likelihood =
      Eigen::Vector2d(-1, -1 - 2 * std::log(2.0)).transpose().replicate(64, 1);  // P = 1/2
  const auto mask = [&](int seed, int group, int round) {
    return decide_swaps(beta, log_likelihood, seed, group, round).exchange.eval();
  };
  EXPECT_TRUE((mask(1, 2, 4) == mask(1, 2, 4)).all());
  EXPECT_FALSE((mask(1, 2, 4) == mask(2, 2, 4)).all());
  EXPECT_FALSE((mask(1, 2, 4) == mask(1, 3, 4)).all());
  EXPECT_FALSE((mask(1, 2, 4) == mask(1, 2, 6)).all());
}

TEST(SwapCounts, ComesBackExactly) {
  SwapCounts swap_counts(3), again(3);
  swap_counts.add(
      decide_swaps(temperature_ladder(3, 0), Eigen::RowVector3d(-1, -1.3, -9), 1, 0, 0));
  StateWriter writer;
  swap_counts.save(writer);
  StateReader reader(writer.bytes());
  again.restore(reader);
  EXPECT_EQ(again.tried, swap_counts.tried);
  EXPECT_EQ(again.accepted, swap_counts.accepted);
  EXPECT_EQ(again.probability, swap_counts.probability);
  EXPECT_TRUE(std::isnan(again.swap_rate()[1]));  // an odd pair
}

// Refusals for which the answer is plain: an even barrier needs no change; if all of it lies
// between the first two, the third rung moves to the middle of them, in beta^(1/5).
TEST(AdaptedLadder, SharesTheBarrierOut) {
  const Eigen::Vector4d even(1, 0.5, 0.2, 0);
  EXPECT_TRUE(matrix_near(adapted_ladder(even, Eigen::Vector3d(0.4, 0.4, 0.4)), even, 1e-12));
  const Eigen::Vector3d steep(1, std::pow(0.5, 5), 0);
  const Eigen::VectorXd moved = adapted_ladder(steep, Eigen::Vector2d(0.999, 0));
  EXPECT_NEAR(std::pow(moved[1], 0.2), 1 - 0.5 * 0.5 * (1 + 1e-3 / 0.999), 1e-12);
  EXPECT_EQ(moved[0], 1);
  EXPECT_EQ(moved[2], 0);
}

// A normal likelihood and a flat prior: the refusal between tempers a > b depends on a / b alone,
// about  Lambda = c log(a / b), so that the best ladder is geometric.
TEST(AdaptedLadder, FindsTheGeometricLadderOfANormal) {
  Eigen::VectorXd beta(6);
  beta << 1, 0.9, 0.7, 0.4, 0.1, 0.01;
  for (int round = 0; round < 60; ++round) {
    const Eigen::ArrayXd ratio = beta.head(5).array() / beta.tail(5).array();
    beta = adapted_ladder(beta, (0.1 * ratio.log()).matrix());
  }
  EXPECT_TRUE(matrix_near(beta, temperature_ladder(6, 0.01), 1e-6));
}

/// Mean refusals between neighbours of a ladder from a normal likelihood of condition 1e8 to its
/// standard normal prior, in 20 dimensions, from exact draws of every rung.
Eigen::VectorXd refusals(const Eigen::VectorXd& beta, unsigned seed) {
  constexpr int kDraws = 500, kSize = 20;
  Eigen::MatrixXd log_likelihood = Eigen::MatrixXd::Zero(kDraws, beta.size());
  RandomStream random(seed, 0, 0);
  for (Eigen::Index i = 0; i < beta.size(); ++i)
    for (int k = 0; k < kDraws; ++k)
      for (int j = 0; j < kSize; ++j) {
        const double precision = std::pow(1e8, j / (kSize - 1.0)), w = random.normal();
        log_likelihood(k, i) -= 0.5 * w * w * precision / (1 + beta[i] * precision);
      }
  SwapCounts swap_counts(static_cast<int>(beta.size()));
  for (const int round : {0, 1})
    swap_counts.add(decide_swaps(beta, log_likelihood, seed, 0, round));
  return swap_counts.rejection_rate();
}

// Hardly one swap in fifty passes the worst place of the ladder, until the rungs are moved there.
// As many refusals everywhere is the best there is.
TEST(AdaptedLadder, OpensTheWayFromThePriorToAPosteriorOfCondition1e8) {
  Eigen::VectorXd beta = temperature_ladder(32, 0);
  EXPECT_GT(refusals(beta, 1).maxCoeff(), 0.95);
  for (unsigned round = 2; round < 7; ++round) beta = adapted_ladder(beta, refusals(beta, round));
  const Eigen::VectorXd after = refusals(beta, 99);
  EXPECT_LT(after.maxCoeff(), 0.7);
  EXPECT_GT(after.minCoeff(), 0.5);
}

std::vector<Eigen::MatrixXd> coordinates(const Draws& draws) {
  std::vector<Eigen::MatrixXd> x;
  for (int i = 0; i < draws.size(); ++i) x.push_back(draws.coordinate(i));
  return x;
}

/// Four chains that all begin in the smaller of two modes.
Draws temper_two_modes(SamplingMethod method, int temperatures, long draws, int thin) {
  RunOptions options;
  options.method = method;
  options.sampler.warm_up = 1000;
  options.temperatures = temperatures;
  options.draws = draws;
  options.thin = thin;
  options.threads = 1;
  return run_chains(sample::two_modes(4).target, sample::normal_starts(4, 4, 1, 3, -5), options);
}

TEST(Tempering, WeighsModesThatNoChainBeganIn) {
  for (const auto method : {SamplingMethod::kAdaptiveMetropolis, SamplingMethod::kNuts}) {
    const bool nuts = method == SamplingMethod::kNuts;
    const Draws draws = temper_two_modes(method, 7, 1000, nuts ? 5 : 40);
    sample::expect_posterior(coordinates(draws), sample::two_modes(4));
    EXPECT_GT(draws.swap_rate.minCoeff(), 0.2) << name_of(method);
    // The share of draws in the larger mode is 2/3.
    const Eigen::MatrixXd larger = (coordinates(draws)[0].array() > 0).cast<double>();
    EXPECT_NEAR(larger.mean(), 2.0 / 3, 4 * mean_mcse(larger)) << name_of(method);
  }
}

TEST(Tempering, IsWhatFindsThem) {
  const Draws draws = temper_two_modes(SamplingMethod::kNuts, 1, 500, 1);
  EXPECT_LT(draws.coordinate(0).maxCoeff(), 0);
}

}  // namespace
}  // namespace thenar
