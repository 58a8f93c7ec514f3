// Tests for grasp/approach.cpp.

#include "grasp/approach.h"

#include <gmock/gmock.h>

#include "grasp/robot_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

constexpr double kAccuracy = 1e-4;  // default of CloseOptions [m]

Approached go(const Scene& scene, double way) {
  const RobotHand hand(sample::pincer(0.06));
  return approach(touching_hand(hand), {}, Eigen::VectorXd::Zero(2), scene, way);
}

const ShapeSpec kBlock = sample::shape(ShapeKind::kBox, {0.2, 0.02, 0.2});

// The tips stand at L + r; the block's near face at 0.2 - 0.01.
TEST(Approach, StopsBeforeWhatItMeets) {
  const Approached met = go(sample::scene({sample::placed("block", kBlock, {0, 0.2, 0})}), 0.5);
  const double way = 0.19 - sample::kLength - sample::kRadius;
  EXPECT_TRUE(met.touches);
  EXPECT_EQ(met.body, "block");
  EXPECT_LT(met.X_WH.p.y(), way);
  EXPECT_GT(met.X_WH.p.y(), way - 1.01 * kAccuracy);
}

TEST(Approach, GoesAllTheWayPastWhatItMisses) {
  const Approached missed = go(sample::scene({sample::placed("block", kBlock, {0, 0.2, 1})}), 0.5);
  EXPECT_FALSE(missed.touches);
  EXPECT_DOUBLE_EQ(missed.X_WH.p.y(), 0.5);
}

TEST(Approach, StopsAtObstaclesToo) {
  const Approached met = go(sample::scene({sample::placed("block", kBlock, {0, 0.2, 1}),
                                           sample::placed("wall", kBlock, {0, 0.3, 0}, false)}),
                            0.5);
  EXPECT_EQ(met.body, "wall");
}

TEST(Approach, DoesNotStartFromWithin) {
  const Approached stuck = go(sample::scene({sample::placed("block", kBlock, {0, 0.03, 0})}), 0.5);
  EXPECT_EQ(stuck.overlaps.size(), 2u);
  EXPECT_EQ(stuck.X_WH.p.y(), 0);
}

}  // namespace
}  // namespace thenar
