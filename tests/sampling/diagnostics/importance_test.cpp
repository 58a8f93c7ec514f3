// Tests for sampling/diagnostics/importance.cpp, against Gaussians in closed form.

#include "sampling/diagnostics/importance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/leave_one_out.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

/// N(0, 1) twice over, independent (2, N).
Eigen::MatrixXd normal_draws(int count) {
  Eigen::MatrixXd x(2, count);
  for (int i = 0; i < count; ++i) {
    RandomStream random(1, static_cast<std::uint32_t>(i), 0);
    x(0, i) = random.normal();
    x(1, i) = random.normal();
  }
  return x;
}

/// Log likelihood of the first entry read as y with the sd s.
Eigen::VectorXd reading(const Eigen::MatrixXd& x, double y, double s) {
  return -(x.row(0).array() - y).square().matrix().transpose() / (2 * s * s);
}

// A prior N(0, 1) read as y = 1 with sd 1 is N(y / 2, 1/2): the mean and the sd of weighted draws.
// The other entry, which was not read, stays as it was.
TEST(Importance, WeighsAPriorToItsPosterior) {
  const Eigen::MatrixXd x = normal_draws(20000);
  const WeightedSpread spread = weighted_spread(x, importance_weights(reading(x, 1, 1)).weight);
  EXPECT_NEAR(spread.mean[0], 0.5, 0.03);
  EXPECT_NEAR(spread.sd[0], std::sqrt(0.5), 0.02);
  EXPECT_NEAR(spread.mean_shift[0], 0.5, 0.03);
  EXPECT_NEAR(spread.sd_ratio[0], std::sqrt(0.5), 4 * spread.sd_ratio_error[0]);
  EXPECT_NEAR(spread.sd_ratio[1], 1, 4 * spread.sd_ratio_error[1]);
}

// With likelihood exp(-x^2 / 2 s^2) of x ~ N(0, 1) and a = 1 / s^2, (E w)^2 / E w^2 =
// sqrt(1 + 2 a) / (1 + a): 0.866 for s = 1.
TEST(Importance, EffectiveSizeIsThatOfTwoGaussians) {
  const int count = 40000;
  const Eigen::MatrixXd x = normal_draws(count);
  for (const double s : {0.5, 1.0, 2.0}) {
    const double a = 1 / (s * s);
    EXPECT_NEAR(importance_weights(reading(x, 0, s)).effective_size / count,
                std::sqrt(1 + 2 * a) / (1 + a), 0.015)
        << s;
  }
}

// The stated error is the scatter of the ratio over repetitions.
TEST(Importance, ErrorOfARatioIsItsScatter) {
  const int repetitions = 200, count = 500;
  const Eigen::MatrixXd all = normal_draws(repetitions * count);
  Eigen::ArrayXXd ratio(2, repetitions), error(2, repetitions);
  for (int r = 0; r < repetitions; ++r) {
    const Eigen::MatrixXd x = all.middleCols(r * count, count);
    const WeightedSpread spread = weighted_spread(x, importance_weights(reading(x, 0.5, 1)).weight);
    ratio.col(r) = spread.sd_ratio;
    error.col(r) = spread.sd_ratio_error;
  }
  for (int i = 0; i < 2; ++i) {
    const double scatter =
        std::sqrt((ratio.row(i) - ratio.row(i).mean()).square().sum() / (repetitions - 1));
    EXPECT_NEAR(error.row(i).mean() / scatter, 1, 4 / std::sqrt(2.0 * repetitions)) << i;
  }
}

TEST(Importance, EqualRatiosTeachNothing) {
  const Eigen::MatrixXd x = normal_draws(100);
  const ImportanceWeights weights = importance_weights(Eigen::VectorXd::Constant(100, -3));
  EXPECT_NEAR(weights.effective_size, 100, 1e-9);
  EXPECT_TRUE(weights.reliable());
  const WeightedSpread spread = weighted_spread(x, weights.weight);
  EXPECT_TRUE(matrix_near(spread.sd_ratio, Eigen::Vector2d::Ones(), 1e-12));
  EXPECT_TRUE(matrix_near(spread.sd_ratio_error, Eigen::Vector2d::Zero(), 1e-12));
}

// Where the other distribution has no mass, a draw has no weight, and is not counted.
TEST(Importance, DrawsOutsideHaveNoWeight) {
  const Eigen::MatrixXd x = normal_draws(1000);
  Eigen::VectorXd log_ratio = reading(x, 0, 1);
  for (Eigen::Index i = 0; i < log_ratio.size(); ++i)
    if (x(0, i) < 0) log_ratio[i] = -kInfinity;
  const ImportanceWeights weights = importance_weights(log_ratio);
  for (Eigen::Index i = 0; i < log_ratio.size(); ++i)
    EXPECT_EQ(weights.weight[i] > 0, x(0, i) >= 0);
  EXPECT_NEAR(weights.weight.sum(), 1, 1e-12);
  EXPECT_LE(weights.effective_size, 550);
}

// Of a narrow distribution taken for a wide one, ratios exp(x^2 (1 - 1/9) / 2) have a tail of shape
// 1 - 1/9, as P(ratio > r) falls as r^(-9/8): averages over them are not to be relied on.
TEST(Importance, HeavyTailsAreNotReliable) {
  const Eigen::MatrixXd x = normal_draws(20000);
  const ImportanceWeights weights =
      importance_weights(x.row(0).array().square().matrix().transpose() * (4.0 / 9));
  EXPECT_GT(weights.k, weights.good_k);
  EXPECT_FALSE(weights.reliable());
  EXPECT_DOUBLE_EQ(weights.good_k, 0.7);
  EXPECT_DOUBLE_EQ(good_pareto_shape(100), 0.5);
}

TEST(Importance, RefusesWhatCannotBeWeighed) {
  EXPECT_THROW((void)importance_weights(Eigen::Vector2d(0, kInfinity)), InputError);
  EXPECT_THROW((void)importance_weights(Eigen::Vector2d(0, std::nan(""))), InputError);
  EXPECT_THROW((void)importance_weights(Eigen::Vector2d(-kInfinity, -kInfinity)), InputError);
  EXPECT_THROW((void)weighted_spread(normal_draws(3), Eigen::Vector2d(0.5, 0.5)), InputError);
  EXPECT_THROW((void)weighted_spread(Eigen::MatrixXd::Ones(1, 2), Eigen::Vector2d(0.5, 0.5)),
               InputError);
}

// Two chains that stay four steps at each draw know no more than those draws, so that the error of
// a ratio is theirs; their tail is longer by the same efficiency.
TEST(Importance, ChainsThatRepeatDrawsKnowNoMore) {
  const int count = 4000, times = 4, chains = 2;
  const Eigen::MatrixXd x = normal_draws(count);
  Eigen::MatrixXd repeated(2, count * times);
  for (int i = 0; i < count * times; ++i) repeated.col(i) = x.col(i / times);
  const Eigen::VectorXd log_ratio = reading(x, 1, 1), of_repeated = reading(repeated, 1, 1);
  const WeightedSpread once = weighted_spread(x, importance_weights(log_ratio).weight);
  const ImportanceWeights weights = importance_weights(of_repeated, chains);
  const WeightedSpread spread = weighted_spread(repeated, weights.weight, chains);
  for (int i = 0; i < 2; ++i)  // an effective size is known to some 5 %
    EXPECT_NEAR(spread.sd_ratio_error[i] / once.sd_ratio_error[i], 1, 0.1) << i;
  const Eigen::VectorXd ratio = of_repeated.array().exp();
  const double efficiency = mean_efficiency(ratio.reshaped(count * times / chains, chains));
  EXPECT_NEAR(efficiency, 1.0 / times, 0.1 / times);
  EXPECT_NEAR(weights.k, smooth_weights(of_repeated, efficiency).k, 1e-12);
  EXPECT_THROW((void)importance_weights(of_repeated, 3), InputError);
}

}  // namespace
}  // namespace thenar
