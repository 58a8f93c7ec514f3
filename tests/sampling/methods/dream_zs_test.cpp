// Tests for sampling/methods/dream_zs.cpp. The environment's THENAR_SAMPLES runs the long ones.

#include <gtest/gtest.h>

#include "tests/sampling/expect_posterior.h"

namespace thenar {
namespace {

using sample::Collected;
using sample::Plan;

constexpr SamplingMethod kDream = SamplingMethod::kDreamZs;

TEST(DreamZs, DrawsFromEightSchools) {
  const auto known = sample::eight_schools();
  Plan plan;
  plan.each = 3;
  plan.thin = 5;
  sample::expect_posterior(sample::draw(kDream, known.target, plan).x, known);
}

// Differences of the archive carry the shape of the posterior: no covariance is learnt.
TEST(DreamZs, DrawsFromANormalOfCondition1e8) {
  const auto known = sample::gaussian(6, 1e8);
  Plan plan;
  plan.each = 4;
  plan.thin = 8;
  plan.warm_up = 10000;
  sample::expect_posterior(sample::draw(kDream, known.target, plan).x, known);
}

// Whole differences of the archive jump from mode to mode, if both are in it from the start.
TEST(DreamZs, WeighsTwoModesThatItsStartsFound) {
  const auto known = sample::two_modes(4);
  Plan plan;
  plan.each = 4;
  plan.thin = 4;
  Eigen::MatrixXd starts = sample::normal_starts(4, 16, 2);
  for (int k = 0; k < 16; ++k) starts.col(k).array() += k % 2 == 0 ? -5 : 5;
  sample::expect_posterior(sample::draw(kDream, known.target, plan, starts).x, known);
}

// Chains that began in one mode alone cannot know of another; groups that began apart tell.
TEST(DreamZs, RHatOfGroupsThatBeganApartIsLarge) {
  const auto known = sample::two_modes(4);
  Plan plan;
  plan.each = 4;
  plan.groups = 2;
  Eigen::MatrixXd starts = sample::normal_starts(4, 8, 1);
  starts.leftCols(4).array() -= 5;
  starts.rightCols(4).array() += 5;
  EXPECT_GT(sample::draw(kDream, known.target, plan, starts).worst_r_hat(), 1.5);
}

// What it has learnt stands last: the archive, 10 n states and 4 every 10 steps, and three
// vectors of the three crossovers.
TEST(DreamZs, ArchiveAndCrossoversAreFrozenAfterWarmUp) {
  sample::expect_nothing_learnt_after_warm_up(kDream, 4, 2 + 3 * (30 + 4 * 20) + 3 * (2 + 3));
}

TEST(DreamZs, DrawsFromTwentyDimensionsOfCondition1e8) {
  if (sample::long_runs() == 0) GTEST_SKIP() << "set THENAR_SAMPLES=1";
  Plan plan;
  plan.each = 4;
  plan.warm_up = 20000;
  plan.thin = 40 * sample::long_runs();
  sample::expect_at_cost(kDream, sample::gaussian(20, 1e8), plan);
}

TEST(DreamZs, DrawsFromTheBanana) {
  if (sample::long_runs() == 0) GTEST_SKIP() << "set THENAR_SAMPLES=1";
  Plan plan;
  plan.each = 5;
  plan.warm_up = 20000;
  plan.thin = 200 * sample::long_runs();
  sample::expect_at_cost(kDream, sample::banana(), plan);
}

}  // namespace
}  // namespace thenar
