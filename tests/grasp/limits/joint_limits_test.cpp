// Tests for what worms, clutches and stops add to the forces of a hand: closed forms.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "grasp/limits/drive_torques.h"
#include "grasp/limits/joint_limits.h"
#include "grasp/limits/wrench_support.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSolvedReaction = 1e-7;  // of forces of order 10 N
constexpr double kNoTorqueLimit = std::numeric_limits<double>::infinity();
constexpr double kLimitFriction = 0.5, kEffort = 0.3;  // [1], [N m]

ForceSet forces_of(const Hand& hand, const VectorXd& q, const std::vector<HandContact>& contacts) {
  return hand_forces(wrench_set(contacts_without_hand(contacts), {0, 0.05, 0}, 0.02),
                     torque_map(hand, q, contacts, {}), actuation_with_joint_limits(hand, q));
}

double most(const ForceSet& forces, const Vector3d& along) {
  return wrench_support(forces, {along, {0, 0, 0}}).value;
}

/// Largest force along z that leaves no force across, whatever torque comes with it.
double across(const ForceSet& forces) {
  return support_along(forces, Eigen::MatrixXd::Identity(3, 6), Vector3d::Zero(), Vector3d::UnitZ())
      .value;
}

double load(const ForceSet& forces, const Vector3d& push) {
  return load_margin(forces, {push, {0, 0, 0}}).value;
}

/// Two fingers 80 mm apart that press an object between them 50 mm out: 0.3 N m are 6 N.
class Pincer : public testing::Test {
 protected:
  Pincer() : robot_(sample::pincer(0.08)) {
    for (RobotDof& dof : robot_.dofs) dof.max_effort = kEffort;
  }
  void open_further() {
    for (RobotJoint& joint : robot_.joints) joint.lower = -0.5;
    for (RobotDof& dof : robot_.dofs) dof.lower = -0.5;
  }
  [[nodiscard]] ForceSet forces() const {
    return forces_of(RobotHand(robot_), Vector2d(0, 0),
                     {{{{-0.03, 0.05, 0}, {1, 0, 0}, kLimitFriction, 0}, 0, 0},
                      {{{0.03, 0.05, 0}, {-1, 0, 0}, kLimitFriction, 0}, 1, 0}});
  }
  RobotSpec robot_;
};

TEST_F(Pincer, HoldsWhatItsMotorsHoldAwayFromStops) {
  open_further();
  EXPECT_NEAR(load(forces(), {1, 0, 0}), 6, kSolvedReaction);
  EXPECT_NEAR(load(forces(), {0, 0, 1}), kLimitFriction * 12, kSolvedReaction);
}

// The right finger is all the way open and its motor is dead: its stop bears what the left one
// presses, and whatever pushes the object against it.
TEST_F(Pincer, StopBearsWhatPushesOutwards) {
  open_further();
  robot_.joints[1].lower = robot_.dofs[1].lower = 0;
  robot_.dofs[1].max_effort = 1e-9;
  EXPECT_EQ(load(forces(), {1, 0, 0}), kNoTorqueLimit);
  EXPECT_NEAR(load(forces(), {-1, 0, 0}), 6, kSolvedReaction);
  EXPECT_NEAR(load(forces(), {0, 0, 1}), kLimitFriction * 12, kSolvedReaction);
}

// The same at the other end of its range: the stop pushes the other way, and helps nobody.
TEST_F(Pincer, StopOfAClosedFingerBearsNothing) {
  open_further();
  robot_.joints[1].upper = robot_.dofs[1].upper = 0;
  robot_.dofs[1].max_effort = 1e-9;
  EXPECT_NEAR(load(forces(), {1, 0, 0}), 0, kSolvedReaction);
  EXPECT_NEAR(load(forces(), {0, 0, 1}), 0, kSolvedReaction);
}

// A worm bears whatever pushes a finger open; friction is what the motor's 6 N make it.
TEST_F(Pincer, WormsBearLoadsButDoNotSqueeze) {
  open_further();
  for (RobotDof& dof : robot_.dofs) dof.backdrivable = false;
  EXPECT_EQ(load(forces(), {1, 0, 0}), kNoTorqueLimit);
  EXPECT_NEAR(load(forces(), {0, 0, 1}), kLimitFriction * 12, kSolvedReaction);
}

// A drive that stays where it is, behind a worm, is locked both ways.
TEST_F(Pincer, LockedDriveIsAReactionBothWays) {
  robot_.dofs[0].backdrivable = false;
  robot_.dofs[0].speed = 0;
  const Reactions reactions = RobotHand(robot_).actuation(Vector2d(0.1, 0.1)).reactions;
  ASSERT_EQ(reactions.lower.size(), 1);
  EXPECT_TRUE(matrix_near(reactions.R, Vector2d(1, 0), 0));
  EXPECT_EQ(reactions.lower(0), -kNoTorqueLimit);
  EXPECT_EQ(reactions.upper(0), kNoTorqueLimit);
  EXPECT_TRUE(reactions.non_backdrivable.empty());
}

TEST_F(Pincer, NominalEffortsAreUnknown) {
  robot_.dofs[0].nominal_effort = true;
  const Actuation actuation = RobotHand(robot_).actuation(Vector2d(0, 0));
  EXPECT_EQ(actuation.upper[0], kNoTorqueLimit);
  EXPECT_EQ(actuation.upper[1], kEffort);
}

/// Two phalanges of 50 mm along x and a wall: things are pressed against it 30 mm from each joint.
/// The outer joint moves by half.
class TwoPhalanges : public testing::Test {
 protected:
  [[nodiscard]] static RobotSpec spec(DriveCoupling kind, bool worm) {
    RobotSpec robot = sample::finger(kind);
    robot.links[0].shapes = {sample::shape(ShapeKind::kBox, {0.1, 0.01, 0.1}, {0, 0.1, 0})};
    robot.dofs[0].max_effort = kEffort;
    robot.dofs[0].breakaway = 0.15;
    robot.dofs[0].backdrivable = !worm;
    for (RobotJoint& joint : robot.joints) joint.lower = -0.5;
    robot.dofs[0].lower = -0.5;
    return robot;
  }
  /// A contact at x of a phalanx and one of the wall across from it. @param bend  of the outer one
  static void press(std::vector<HandContact>& contacts, int phalanx, double x, double bend) {
    const Eigen::Matrix3d R = rotation_about<double>(Vector3d::UnitZ(), bend);
    const Vector3d at =
        phalanx == 1 ? Vector3d(x, 0, 0) : Vector3d(Vector3d(0.05, 0, 0) + R * Vector3d(x, 0, 0));
    const Vector3d n = phalanx == 1 ? Vector3d::UnitY() : Vector3d(R.col(1));
    contacts.push_back({{at, n, kLimitFriction, 0}, phalanx, 0});
    contacts.push_back({{at + 0.02 * n, -n, kLimitFriction, 0}, 0, 0});
  }
  [[nodiscard]] static double friction_across(const RobotSpec& robot, double bend, bool both) {
    std::vector<HandContact> contacts;
    press(contacts, 2, 0.03, bend);
    if (both) press(contacts, 1, 0.03, 0);
    return across(forces_of(RobotHand(robot), Vector2d(0, bend), contacts));
  }
};

// The outer joint gets u / r = 0.6 N m: 20 N at 30 mm, which the worm of the inner one bears.
TEST_F(TwoPhalanges, OfABreakawayPressWithTheMotorOnTheOuterJoint) {
  const RobotSpec worm = spec(DriveCoupling::kBreakaway, true);
  EXPECT_NEAR(friction_across(worm, 0, false), kLimitFriction * 2 * 20, kSolvedReaction);
  EXPECT_NEAR(friction_across(worm, 0, true), kLimitFriction * 2 * 20,
              kSolvedReaction);  // the clutch costs the same
}

// Parted, the inner joint keeps 0.15 N m of its clutch, 5 N at 30 mm; the outer one has all of u.
TEST_F(TwoPhalanges, OfABreakawayKeepTheClutchesTorque) {
  EXPECT_NEAR(friction_across(spec(DriveCoupling::kBreakaway, true), 0.2, true),
              kLimitFriction * 2 * 25, kSolvedReaction);
}

// Without the worm the knuckle has 0.15 N m of its clutch for the outer phalanx, 80 mm out.
TEST_F(TwoPhalanges, WithoutAWormNeedTheClutch) {
  const RobotSpec contacts_without_hand = spec(DriveCoupling::kBreakaway, false);
  EXPECT_NEAR(friction_across(contacts_without_hand, 0, false), kLimitFriction * 2 * 0.15 / 0.08,
              kSolvedReaction);
}

// Springs share u by r / (r'r) = (0.8, 0.4): 2 N at 60 mm of the outer phalanx, then
// (0.24 - 2 * 0.11) / 0.03 N are left for the inner one.
TEST_F(TwoPhalanges, OfOneMotorByRatioPressTogether) {
  const RobotHand hand(spec(DriveCoupling::kCompliant, false));
  const std::vector<HandContact> contacts{{{{0.03, 0, 0}, {0, 1, 0}, 0, 0}, 1, 0},
                                          {{{0.11, 0, 0}, {0, 1, 0}, 0, 0}, 2, 0}};
  EXPECT_NEAR(most(forces_of(hand, Vector2d(0, 0), contacts), Vector3d::UnitY()), 2 + 2.0 / 3,
              kSolvedReaction);
}

/// A tendon with arms of 10 and 8 mm at two joints and one of 12 mm at the inner joint, 40 N each,
/// press with a tip 80 and 30 mm from the joints.
WrenchSupport tendon_finger(double inwards, double passive_elsewhere) {
  const WrenchSet set = wrench_set({{{0, 0, 0}, {0, 1, 0}, 0, 0}}, {0, 0, 0}, 1);
  Actuation tendons;
  tendons.B.resize(3, 2);
  tendons.B << 0.010, 0.012, 0.008, 0, 0, 0;
  tendons.tau_0 = Vector3d(0, 0, passive_elsewhere);
  tendons.lower = Vector2d::Zero();
  tendons.upper = Vector2d::Constant(40);
  if (inwards != 0) {
    tendons.reactions.R = inwards * Vector3d::UnitY();
    tendons.reactions.lower = VectorXd::Zero(1);
    tendons.reactions.upper = VectorXd::Constant(1, kNoTorqueLimit);
  }
  return wrench_support(hand_forces(set, Vector3d(0.08, 0.03, 0), tendons), ScaledWrench::unit(1));
}

// 0.03 f = 0.008 t1 limits the tip: f = 10.67 N, t2 = 37.8 N.
TEST(TendonFinger, PressesAsItsOuterJointAllows) {
  EXPECT_NEAR(tendon_finger(0, 0).value, 0.32 / 0.03, kSolvedReaction);
}

// Straight against its stop the outer joint needs no tendon: 0.08 f = 0.01 t1 + 0.012 t2.
TEST(TendonFinger, PressesHarderWhenAStopBearsItsOuterJoint) {
  EXPECT_NEAR(tendon_finger(1, 0).value, 0.88 / 0.08, kSolvedReaction);
  EXPECT_NEAR(tendon_finger(-1, 0).value, 0.32 / 0.03,
              kSolvedReaction);  // bent all the way: no help
}

// A third joint, of a digit that touches nothing, may be out of balance.
TEST(TendonFinger, AsksNothingOfDigitsThatDoNotTouch) {
  EXPECT_NEAR(tendon_finger(0, 0.5).value, 0.32 / 0.03, kSolvedReaction);
}

}  // namespace
}  // namespace thenar
