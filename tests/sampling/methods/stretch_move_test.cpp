// Tests for sampling/methods/stretch_move.cpp. The environment's THENAR_SAMPLES runs the long one.

#include <gtest/gtest.h>

#include "tests/sampling/expect_posterior.h"

namespace thenar {
namespace {

using sample::Collected;
using sample::Plan;

constexpr SamplingMethod kStretch = SamplingMethod::kStretchMove;

TEST(StretchMove, DrawsFromANormalOfAnyCondition) {
  const auto known = sample::gaussian(4, 1e8);
  Plan plan;
  plan.each = 10;
  plan.thin = 10;
  const Collected drawn = sample::draw(kStretch, known.target, plan);
  sample::expect_posterior(drawn.x, known);
}

// An affine map of starts and target maps every draw: the same steps are accepted.
TEST(StretchMove, IsAffineInvariant) {
  const Eigen::Vector2d scale(1e4, 1e-3), shift(5, -7);
  const sample::FunctionTarget plain(
      2, [](const Eigen::VectorXd& x, Eigen::VectorXd&) { return -0.5 * x.squaredNorm(); });
  const sample::FunctionTarget mapped(2, [&](const Eigen::VectorXd& x, Eigen::VectorXd&) {
    return -0.5 * (x - shift).cwiseQuotient(scale).squaredNorm();
  });
  const Eigen::MatrixXd starts = sample::normal_starts(2, 6, 1);
  const auto a = build_sampler(kStretch, starts, {});
  const auto b = build_sampler(kStretch, (scale.asDiagonal() * starts).colwise() + shift, {});
  advance({a.get()}, plain, 30);
  advance({b.get()}, mapped, 30);
  const Eigen::MatrixXd back =
      scale.cwiseInverse().asDiagonal() * (b->positions().colwise() - shift);
  EXPECT_LT((back - a->positions()).cwiseAbs().maxCoeff(), 1e-9);  // rounding, over 30 steps
}

TEST(StretchMove, AsksForHalfOfTheEnsembleAtOnce) {
  const auto sampler = build_sampler(kStretch, sample::normal_starts(3, 12, 1), {});
  EXPECT_EQ(sampler->asks().cols(), 12);  // the starts
  const auto known = sample::gaussian(3, 4);
  advance({sampler.get()}, known.target, 1);
  EXPECT_EQ(sampler->asks().cols(), 6);
}

// Mass 1/3 at -5, 2/3 at 5 on each of four axes. The walkers of one ensemble sit on their modes as
// they began, half and half: none moves over, so that each half of the draws looks like the other,
// and any one quantity of the ensemble is as steady as can be, and wrong.
TEST(StretchMove, WeighsModesWronglyAndOnlyOtherEnsemblesTell) {
  const auto known = sample::two_modes(4);
  Plan plan;
  plan.each = 16;
  plan.groups = 2;
  plan.warm_up = 1000;
  plan.thin = 50;
  Eigen::MatrixXd starts = sample::normal_starts(4, 32, 1);
  for (int k = 0; k < 32; ++k) starts.col(k).array() += k % 16 < (k < 16 ? 8 : 4) ? -5 : 5;
  const Collected drawn = sample::draw(kStretch, known.target, plan, starts);

  // The mean of each ensemble, as a chain of its own.
  Eigen::MatrixXd means(plan.draws, 2);
  for (int e = 0; e < 2; ++e) means.col(e) = drawn.x[0].middleCols(16 * e, 16).rowwise().mean();
  for (int e = 0; e < 2; ++e) {
    const Eigen::MatrixXd alone = means.col(e);
    EXPECT_LT(rank_r_hat(alone), 1.01);  // looks converged,
    const double wrong = std::abs(alone.mean() - known.mean[0]);
    EXPECT_GT(wrong, 10 * mean_mcse(alone));  // and is not
  }
  EXPECT_GT(rank_r_hat(means), 1.5);  // both together say so
}

TEST(StretchMove, DrawsFromTwentyDimensionsOfCondition1e8) {
  if (sample::long_runs() == 0) GTEST_SKIP() << "set THENAR_SAMPLES=1";
  Plan plan;
  plan.each = 40;
  plan.warm_up = 20000;
  plan.thin = 50 * sample::long_runs();
  sample::expect_at_cost(kStretch, sample::gaussian(20, 1e8), plan);
}

}  // namespace
}  // namespace thenar
