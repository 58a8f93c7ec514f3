// Tests for sampling/methods/adaptive_metropolis.cpp. The environment's THENAR_SAMPLES runs the
// long ones.

#include <gtest/gtest.h>

#include "tests/sampling/expect_posterior.h"

namespace thenar {
namespace {

using sample::Collected;
using sample::Plan;

constexpr SamplingMethod kMetropolis = SamplingMethod::kAdaptiveMetropolis;

TEST(AdaptiveMetropolis, LearnsANormalOfCondition1e8) {
  const auto known = sample::gaussian(4, 1e8);
  Plan plan;
  plan.warm_up = 10000;
  const Collected drawn = sample::draw(kMetropolis, known.target, plan);
  sample::expect_posterior(drawn.x, known);
  EXPECT_NEAR(drawn.acceptance, 0.234, 0.04);  // what the scale was learnt for
}

TEST(AdaptiveMetropolis, DrawsFromEightSchools) {
  const auto known = sample::eight_schools();
  sample::expect_posterior(sample::draw(kMetropolis, known.target, {}).x, known);
}

// A wrong guess of the covariance costs warm-up, no more; a right one saves it.
TEST(AdaptiveMetropolis, TakesAGuessOfTheCovariance) {
  const auto known = sample::gaussian(20, 1e8);
  // The covariance of the sample: Q diag(variance) Q with the same reflection.
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(20, 1, 2).normalized();
  const Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(20, 20) - 2 * u * u.transpose();
  Eigen::VectorXd variance(20);
  for (int i = 0; i < 20; ++i) variance[i] = std::pow(1e8, i / 19.0);
  SamplerOptions options;
  options.warm_up = 1000;
  options.covariance = Q * variance.asDiagonal() * Q;
  const auto groups =
      sample::build_groups(kMetropolis, sample::normal_starts(20, 4, 1), 1, options);
  (void)sample::collect(groups, known.target, 1, 2000);
  sample::expect_posterior(sample::collect(groups, known.target, 1000, 50).x, known);
}

// What it has learnt stands last: shapes of a mean and of a matrix, their entries, a scale.
TEST(AdaptiveMetropolis, LearnsNothingAfterWarmUp) {
  sample::expect_nothing_learnt_after_warm_up(kMetropolis, 1, 2 + 3 + 2 + 9 + 1);
}

TEST(AdaptiveMetropolis, LearnsTwentyDimensionsOfCondition1e8FromNothing) {
  if (sample::long_runs() == 0) GTEST_SKIP() << "set THENAR_SAMPLES=1";
  Plan plan;
  plan.warm_up = 60000;
  plan.thin = 50 * sample::long_runs();
  sample::expect_at_cost(kMetropolis, sample::gaussian(20, 1e8), plan);
}

// A global covariance fits no part of the bend: 5e-5 independent draws an evaluation.
TEST(AdaptiveMetropolis, DrawsFromTheBananaWithPatience) {
  if (sample::long_runs() == 0) GTEST_SKIP() << "set THENAR_SAMPLES=1";
  Plan plan;
  plan.groups = 8;
  plan.warm_up = 20000;
  plan.thin = 5000 * sample::long_runs();
  sample::expect_at_cost(kMetropolis, sample::banana(), plan);
}

}  // namespace
}  // namespace thenar
