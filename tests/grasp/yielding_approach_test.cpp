// Tests for grasp/yielding_approach.cpp: a ball before jaws 100 mm apart, 10 mm thick.

#include "grasp/yielding_approach.h"

#include <gmock/gmock.h>

#include "grasp/closing_drives.h"
#include "grasp/robot_hand.h"
#include "tests/grasp/jaws.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kRadius = 0.015;

Approached go(double x, double most) {
  const RobotHand hand(sample::jaws());
  const ShapeSpec ball = sample::shape(ShapeKind::kSphere, {kRadius, 0, 0});
  return yielding_approach(touching_hand(hand), {}, open_posture(hand.layout()),
                           sample::scene({sample::placed("ball", ball, {x, 0.2, 0})}), 0.5, most);
}

// Its side, at 55 mm, meets the jaw, which begins at 50 mm; the palm's face is at y = -25 mm.
TEST(YieldingApproach, GivesWayToABallBesideTheMiddle) {
  const Approached met = go(0.04, kRadius);
  EXPECT_TRUE(met.touches);
  EXPECT_EQ(met.surface, "base");
  EXPECT_GE(met.X_WH.p.x(), 0.04 + kRadius - 0.05 - 1e-4);
  EXPECT_LE(met.X_WH.p.x(), 0.04 + kRadius - 0.05 + 1e-3);  // a step and the accuracy
  EXPECT_NEAR(met.X_WH.p.y(), 0.2 - kRadius + 0.025, 2e-4);
}

TEST(YieldingApproach, StaysWhereItMetTheBallIfItMayNotGiveWay) {
  const Approached met = go(0.04, 0);
  EXPECT_EQ(met.X_WH.p.x(), 0);
  EXPECT_NE(met.surface, "base");
}

TEST(YieldingApproach, EndsBeforeAnObjectHeadOn) {
  const Approached met = go(0.055, kRadius);
  EXPECT_EQ(met.X_WH.p.x(), 0);
  EXPECT_NEAR(met.X_WH.p.y(), 0.2 - kRadius - 0.02, 2e-4);
}

TEST(YieldingApproach, RefusesToGiveWayByLessThanNothing) {
  EXPECT_THAT(message_of([] { (void)go(0.04, -1); }), testing::HasSubstr("got -1"));
}

}  // namespace
}  // namespace thenar
