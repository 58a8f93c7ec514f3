// Tests for centred_grasp() of grasp/compare/pregrasp.cpp: a jaw brings things to a fixed one.

#include <gtest/gtest.h>

#include "grasp/compare/grasp_loads.h"
#include "grasp/compare/pregrasp.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/jaws.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kRadius = 0.015;
constexpr double kPush = 2;  // of the motor [N]

/// The jaws of which the right one is part of the base, 50 mm off on the x axis.
RobotSpec vise() {
  RobotSpec robot = sample::jaws();
  ShapeSpec fixed = robot.links[2].shapes[0];
  fixed.X_BS.p += robot.joints[1].X_PJ.p;
  robot.links[0].shapes.push_back(fixed);
  robot.links.pop_back();
  robot.joints.pop_back();
  // It may go all the way.
  robot.dofs[0].upper = robot.joints[0].upper = 0.1;
  return robot;
}

struct BallInVise {
  explicit BallInVise(const Eigen::Vector3d& centre)
      : hand(vise()),
        setup(sample::setup(
            {sample::placed("ball", sample::shape(ShapeKind::kSphere, {kRadius, 0, 0}), centre)})) {
    GraspOptions options;
    options.approach_distance = 0;
    grasp = centred_grasp(collision_hand(hand), {}, open_posture(hand.layout()), setup, options);
  }
  RobotHand hand;
  GraspSetup setup;
  Grasp grasp;
};

// The fixed jaw's face is at x = 50 mm: wherever the ball is, it comes to rest on it, and the other
// jaw, of a face at x = q - 50 mm, stops 30 mm before it.
TEST(FixedJaw, HoldsWhatTheOtherBrings) {
  for (const double x : {-0.03, -0.01, 0.0, 0.02, 0.034}) {
    const BallInVise held({x, 0, 0});
    ASSERT_EQ(held.grasp.outcome, GraspOutcome::kGrasped) << x;
    ASSERT_EQ(held.grasp.contacts.size(), 2U) << x;
    EXPECT_NEAR(held.grasp.closed.q[0], 0.1 - 2 * kRadius, 3e-4) << x;
    for (const HandContact& each : held.grasp.contacts) {
      const double side = each.surface == 0 ? 1 : -1;
      EXPECT_TRUE(matrix_near(each.contact.p, Eigen::Vector3d(side * kRadius, 0, 0), 1e-6)) << x;
      EXPECT_TRUE(matrix_near(each.contact.n, Eigen::Vector3d(-side, 0, 0), 1e-4)) << x;
    }
  }
}

// Friction is 1: both jaws rub with what the motor presses, 2 N each. No place of a contact is so
// far beside the middle that the weight would turn the ball about the line through both.
TEST(FixedJaw, BearsByFrictionWhatTheMotorPresses) {
  const BallInVise held({0, 0, 0});
  const HeldObject object{held.hand, held.grasp.closed.q, held.grasp.contacts,
                          held.grasp.approached.X_WH.inverse() * held.setup.object.X_WB};
  const GraspLoads loads = grasp_loads(object, held.setup.object, 0.05, {GraspTask::kPull});
  EXPECT_NEAR(loads.margin.at("pull"), 2 * kPush, 1e-4);
}

// Nothing stands on the other side.
TEST(FixedJaw, IsNotMadeUp) {
  RobotSpec robot = vise();
  robot.links[0].shapes.pop_back();
  const RobotHand hand(robot);
  const GraspSetup setup = sample::setup(
      {sample::placed("ball", sample::shape(ShapeKind::kSphere, {kRadius, 0, 0}), {0, 0, 0})});
  GraspOptions options;
  options.approach_distance = 0;
  const Grasp grasp =
      centred_grasp(collision_hand(hand), {}, open_posture(hand.layout()), setup, options);
  EXPECT_EQ(grasp.contacts.size(), 1U);
  EXPECT_TRUE(grasp.approached.X_WH.p.isZero(0));
}

}  // namespace
}  // namespace thenar
