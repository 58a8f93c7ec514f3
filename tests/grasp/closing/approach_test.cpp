// Tests for grasp/closing/approach.cpp.

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "grasp/closing/approach.h"
#include "grasp/closing/clearance.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/grasp/jaws.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kAccuracy = 1e-4;  // default of CloseOptions [m]

ApproachResult go(const GraspSetup& setup, double way) {
  const RobotHand hand(sample::pincer(0.06));
  return approach(collision_hand(hand), {}, Eigen::VectorXd::Zero(2), setup, way);
}

const ShapeSpec kBlock = sample::shape(ShapeKind::kBox, {0.2, 0.02, 0.2});

// The tips stand at L + r; the block's near face at 0.2 - 0.01.
TEST(Approach, StopsBeforeWhatItMeets) {
  const ApproachResult met = go(sample::setup({sample::placed("block", kBlock, {0, 0.2, 0})}), 0.5);
  const double way = 0.19 - sample::kLength - sample::kRadius;
  EXPECT_TRUE(met.touches);
  EXPECT_EQ(met.body, "block");
  EXPECT_LT(met.X_WH.p.y(), way);
  EXPECT_GT(met.X_WH.p.y(), way - 1.01 * kAccuracy);
}

TEST(Approach, GoesAllTheWayPastWhatItMisses) {
  const ApproachResult missed =
      go(sample::setup({sample::placed("block", kBlock, {0, 0.2, 1})}), 0.5);
  EXPECT_FALSE(missed.touches);
  EXPECT_DOUBLE_EQ(missed.X_WH.p.y(), 0.5);
}

TEST(Approach, StopsAtObstaclesToo) {
  const ApproachResult met = go(sample::setup({sample::placed("block", kBlock, {0, 0.2, 1}),
                                               sample::placed("wall", kBlock, {0, 0.3, 0}, false)}),
                                0.5);
  EXPECT_EQ(met.body, "wall");
}

TEST(Approach, DoesNotStartFromWithin) {
  const ApproachResult stuck =
      go(sample::setup({sample::placed("block", kBlock, {0, 0.03, 0})}), 0.5);
  EXPECT_EQ(stuck.overlaps.size(), 2u);
  EXPECT_EQ(stuck.X_WH.p.y(), 0);
}

constexpr double kFacets = 2e-5;  // that stand for a round surface [m]

/// From a cylinder about z, of radius and half length 9 and 22.5 mm, to a ball at c [m].
double cylinder_to_ball(const Eigen::Vector3d& c, double radius) {
  return std::hypot(std::max(0.0, std::hypot(c.x(), c.y()) - 0.009),
                    std::max(0.0, std::abs(c.z()) - 0.0225)) -
         radius;
}

// A clearance is crossed without another look: what is roughly measured may not be farther than it
// is.
TEST(Gaps, AreBoundedFromBelowWhateverTheCutoff) {
  RobotSpec robot = sample::pincer(0.06);
  robot.links[1].shapes = {sample::shape(ShapeKind::kCylinder, {0.009, 0.045, 0})};
  const RobotHand hand(robot);
  const CollisionHand touching = collision_hand(hand);
  const std::vector<Pose<double>> links = hand.pose(Eigen::VectorXd::Zero(2));
  const GraspSetup setup = sample::setup(
      {sample::placed("ball", sample::shape(ShapeKind::kSphere, {0.035, 0, 0}), {0, 0, 0})});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-0.1, 0.1), cutoff(1e-4, 0.1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d c(u(random), u(random), u(random));
    const double exact = cylinder_to_ball(-c - Eigen::Vector3d(-0.03, 0, 0), 0.035);
    if (exact < 0) continue;
    const PosedCollisionHand posed{touching, {Eigen::Matrix3d::Identity(), c}, links};
    Clearance clearance{0, -1, &setup.object};
    (void)measure_clearance(clearance, posed, 2.5e-5, cutoff(random));
    EXPECT_LE(clearance.bound, exact + kFacets);
  }
}

}  // namespace
namespace {

constexpr double kBallRadius = 0.015;

ApproachResult go(double x, double most) {
  const RobotHand hand(sample::jaws());
  const ShapeSpec ball = sample::shape(ShapeKind::kSphere, {kBallRadius, 0, 0});
  return yielding_approach(collision_hand(hand), {}, open_posture(hand.layout()),
                           sample::setup({sample::placed("ball", ball, {x, 0.2, 0})}), {0.5, most});
}

// Its side, at 55 mm, meets the jaw, which begins at 50 mm; the palm's face is at y = -25 mm.
TEST(YieldingApproach, GivesWayToABallBesideTheMiddle) {
  const ApproachResult met = go(0.04, kBallRadius);
  EXPECT_TRUE(met.touches);
  EXPECT_EQ(met.surface, "base");
  EXPECT_GE(met.X_WH.p.x(), 0.04 + kBallRadius - 0.05 - 1e-4);
  EXPECT_LE(met.X_WH.p.x(), 0.04 + kBallRadius - 0.05 + 1e-3);  // a step and the accuracy
  EXPECT_NEAR(met.X_WH.p.y(), 0.2 - kBallRadius + 0.025, 2e-4);
}

TEST(YieldingApproach, StaysWhereItMetTheBallIfItMayNotGiveWay) {
  const ApproachResult met = go(0.04, 0);
  EXPECT_EQ(met.X_WH.p.x(), 0);
  EXPECT_NE(met.surface, "base");
}

// Beside the outer edge of the jaw, at 60 mm: 3 mm aside the hand would slide past, and the palm,
// of 50 mm, would not meet it.
TEST(YieldingApproach, StopsWhereItWouldSlidePast) {
  const ApproachResult met = go(0.072, kBallRadius);
  EXPECT_TRUE(met.touches);
  EXPECT_NE(met.surface, "base");
}

TEST(YieldingApproach, EndsBeforeAnObjectHeadOn) {
  const ApproachResult met = go(0.055, kBallRadius);
  EXPECT_EQ(met.X_WH.p.x(), 0);
  EXPECT_NEAR(met.X_WH.p.y(), 0.2 - kBallRadius - 0.02, 2e-4);
}

TEST(YieldingApproach, RefusesToGiveWayByLessThanNothing) {
  EXPECT_THAT(message_of([] { (void)go(0.04, -1); }), testing::HasSubstr("got -1"));
}

}  // namespace
}  // namespace thenar
