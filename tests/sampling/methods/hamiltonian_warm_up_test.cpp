// Tests for sampling/methods/hamiltonian_warm_up.cpp.

#include "sampling/methods/hamiltonian_warm_up.h"

#include <gtest/gtest.h>

#include "base/random_stream.h"
#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

// 20 steps, then 40, 80 and 160; 320 more would leave 330 of 650, too few for another 640.
TEST(MetricWindows, DoubleAndLeaveNoStump) {
  const MetricWindows windows = metric_windows(1000, 40);
  EXPECT_EQ(windows.first, 20);
  EXPECT_EQ(windows.ends, (std::vector<long>{60, 140, 300, 950}));
}

TEST(MetricWindows, ShrinkWithAShortWarmUp) {
  const MetricWindows windows = metric_windows(100, 40);
  EXPECT_EQ(windows.first, 15);
  EXPECT_EQ(windows.ends, (std::vector<long>{65}));
  EXPECT_TRUE(metric_windows(19, 40).ends.empty());
}

SamplerOptions warm_up_options(long warm_up, Metric metric = Metric::kDense) {
  SamplerOptions options;
  options.warm_up = warm_up;
  options.metric = metric;
  return options;
}

// Two places alternate: in a window of N draws, N even, C = N / (N - 1) d d', d half their
// distance. Diagonal, so that gradients have no say.
TEST(WarmUp, LearnsTheMetricOfItsWindowOnly) {
  WarmUp warm_up(Eigen::Vector2d(0, 0), 0.8, warm_up_options(100, Metric::kDiagonal));
  const Eigen::Vector2d d(3, -1), gradient(1, 1);
  for (long step = 1; step <= 65; ++step) {
    const Eigen::Vector2d far(1e6, 1e6);  // steps up to 15 must not count
    warm_up.learn(step, step <= 15 ? far : step % 2 == 0 ? d : Eigen::Vector2d(-d), gradient, 0.8);
    EXPECT_EQ(warm_up.metric_settled(step), step == 65);
  }
  const Eigen::Vector2d C = 50.0 / 49 * d.cwiseAbs2();
  const Eigen::Vector2d wanted = 50.0 / 55 * C + 5.0 / 55 * 1e-3 * Eigen::Vector2d::Ones();
  EXPECT_TRUE(matrix_near(warm_up.whitening().covariance(), wanted, 1e-12));
}

TEST(WarmUp, LooksForAStepAtFirstAndForEachMetric) {
  WarmUp warm_up(Eigen::Vector2d(0, 0), 0.8, warm_up_options(100));
  EXPECT_TRUE(warm_up.searching());
  warm_up.learn_trial(10);
  warm_up.learn_trial(0);  // passed 0.8: half a unit it is
  EXPECT_FALSE(warm_up.searching());
  EXPECT_EQ(warm_up.step(), 0.5);
  for (long step = 1; step <= 65; ++step) {
    EXPECT_FALSE(warm_up.searching());
    const Eigen::Vector2d x(step % 2, step % 3);
    EXPECT_EQ(warm_up.learn(step, x, -x, 0.8), step == 65);
  }
  EXPECT_TRUE(warm_up.searching());
}

// A standard normal: along its orbits every step is accepted, but none shall pass 0.4 pi.
TEST(WarmUp, StepsLessThanAQuarterTurnAlongOrbits) {
  WarmUp warm_up(Eigen::Vector2d(0, 0), 0.8, warm_up_options(100));
  warm_up.learn_trial(10);
  warm_up.learn_trial(0);
  for (long step = 1; step <= 65; ++step) {
    RandomStream random(1, 0, static_cast<std::uint32_t>(step));
    const Eigen::Vector2d x(random.normal(), random.normal());
    warm_up.learn(step, x, -x, 1);
  }
  ASSERT_TRUE(warm_up.whitening().follows_orbits());
  for (int trial = 0; trial < 10 && warm_up.searching(); ++trial) {
    EXPECT_LE(warm_up.step(), 0.4 * kPi);
    warm_up.learn_trial(0);
  }
  EXPECT_FALSE(warm_up.searching());
  for (long step = 66; step <= 100; ++step) {
    warm_up.learn(step, Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0), 1);
    warm_up.freeze_after_warm_up(step);
    EXPECT_LE(warm_up.step(), 0.4 * kPi);
  }
  EXPECT_NEAR(warm_up.step(), 0.4 * kPi, 1e-12);
}

TEST(WarmUp, LearnsNothingAfterwards) {
  WarmUp warm_up(Eigen::VectorXd::Zero(1), 0.8, warm_up_options(10));
  warm_up.learn_trial(10);
  warm_up.learn_trial(0);
  const auto learn = [&warm_up](long step, double acceptance) {
    warm_up.learn(step, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1), acceptance);
    warm_up.freeze_after_warm_up(step);
  };
  for (long step = 1; step <= 10; ++step) learn(step, 0.5);
  const double step_size = warm_up.step();
  EXPECT_LT(step_size, 0.25);  // half of 0.5 at first, and less since 0.5 is below 0.8
  for (long step = 11; step <= 20; ++step) learn(step, 0);
  EXPECT_EQ(warm_up.step(), step_size);
}

TEST(WarmUp, EndsItsSearchWithTheLastStep) {
  WarmUp warm_up(Eigen::VectorXd::Zero(1), 0.8, warm_up_options(30));
  warm_up.learn_trial(0);  // accepted: twice as much would be next
  for (long step = 1; step <= 30; ++step) {
    EXPECT_TRUE(warm_up.searching());
    warm_up.freeze_after_warm_up(step);
  }
  EXPECT_FALSE(warm_up.searching());
  EXPECT_EQ(warm_up.step(), 2);
}

}  // namespace
}  // namespace thenar::internal
