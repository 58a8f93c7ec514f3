// Tests for grasp/compare/grasp_loads.cpp: what jaws hold, and why they do not.

#include "grasp/compare/grasp_loads.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "grasp/compare/pregrasp.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

using testing::HasSubstr;

constexpr double kWeight = 0.05 * 9.81;  // [N]
const std::vector<GraspTask> kTasks{GraspTask::kForceClosure, GraspTask::kHoldWeight,
                                    GraspTask::kPull};

/// Jaws on a cube of 30 mm: what they hold in the grasp they come to.
struct SqueezedBall {
  explicit SqueezedBall(const RobotSpec& robot)
      : hand(robot), setup(sample::setup({sample::placed("cube", sample::jaw_cube(), {0, 0, 0})})) {
    GraspOptions options;
    options.approach_distance = 0;
    grasp = centred_grasp(collision_hand(hand), {}, open_posture(hand.layout()), setup, options);
  }
  [[nodiscard]] HeldObject held() const {
    return {hand, grasp.closed.q, grasp.contacts,
            grasp.approached.X_WH.inverse() * setup.object.X_WB};
  }
  [[nodiscard]] GraspLoads loads() const { return grasp_loads(held(), setup.object, 0.05, kTasks); }
  RobotHand hand;
  GraspSetup setup;
  Grasp grasp;
};

// Friction is 1, and the motor's 2 N are the sum of what both jaws press with: along every axis the
// weight takes w, the motor holds 2 N.
TEST(GraspLoads, OfACubeBetweenJawsAreThoseOfFrictionAndMotor) {
  const GraspLoads loads = SqueezedBall(sample::jaws()).loads();
  EXPECT_NEAR(loads.min_grasp_force, kWeight, 1e-6);
  EXPECT_NEAR(loads.standing_grasp_force, kWeight, 1e-6);
  EXPECT_NEAR(loads.margin.at("hold-weight"), 2 / kWeight, 1e-6);
  EXPECT_NEAR(loads.margin.at("pull"), 2, 1e-6);
  EXPECT_TRUE(loads.reasons.empty());
  EXPECT_EQ(loads.margin.count("force-closure"), 0U);  // no load
}

TEST(GraspLoads, AreNotKnownWhereAnEffortIsNot) {
  RobotSpec robot = sample::jaws();
  robot.dofs[0].nominal_effort = true;
  const SqueezedBall squeeze(robot);
  const GraspLoads loads = squeeze.loads();
  EXPECT_TRUE(std::isnan(loads.margin.at("pull")));
  EXPECT_EQ(loads.reasons.at("pull"), "the effort of 'motor' is unknown");
  const ExplainedLoad epsilon = hand_epsilon(squeeze.held(), squeeze.setup.object);
  EXPECT_TRUE(std::isnan(epsilon.value));
  EXPECT_EQ(epsilon.message, "the effort of 'motor' is unknown");
}

// A jaw that nothing drives gives way: the other one presses on nothing.
TEST(GraspLoads, NameTheJointThatGivesWay) {
  SqueezedBall squeeze(sample::jaws());
  RobotSpec loose = sample::jaws();
  loose.joints[1].dof.clear();
  const RobotHand hand(loose);
  const Eigen::Vector2d q = squeeze.grasp.closed.q(0) * Eigen::Vector2d::Ones();
  const HeldObject held{hand, q, squeeze.grasp.contacts, squeeze.held().X_HO};
  const GraspLoads loads = grasp_loads(held, squeeze.setup.object, 0.05, kTasks);
  EXPECT_EQ(loads.margin.at("pull"), 0);
  EXPECT_EQ(loads.reasons.at("pull"), "needs more motor torque at 'right'");
  const ExplainedLoad epsilon = hand_epsilon(held, squeeze.setup.object);
  EXPECT_EQ(epsilon.value, 0);
  EXPECT_EQ(epsilon.message, "needs more motor torque at 'right'");
}

TEST(GraspLoads, NameFrictionWhereThereIsNone) {
  SqueezedBall squeeze(sample::jaws());
  for (HandContact& contact : squeeze.grasp.contacts) contact.contact.friction = 0;
  EXPECT_THAT(squeeze.loads().reasons.at("pull"), HasSubstr("friction"));
  EXPECT_EQ(squeeze.loads().margin.at("pull"), 0);
}

// A cube on one smooth point below its centre: nothing holds it on its side or upside down.
TEST(GraspLoads, OfTheStandingObjectAskForItsSupportOnly) {
  SqueezedBall squeeze(sample::jaws());
  const Eigen::Vector3d up = squeeze.setup.object.X_WB.R.transpose().col(2);
  squeeze.grasp.contacts = {{{squeeze.setup.object.com - 0.015 * up, up, 0, 0}, 0, 0}};
  const GraspLoads loads = squeeze.loads();
  EXPECT_NEAR(loads.standing_grasp_force, kWeight, 1e-6);
  EXPECT_EQ(loads.min_grasp_force, std::numeric_limits<double>::infinity());
}

// Loads that a worm bears along the jaws do not count for more than friction across them: 2 N.
TEST(GraspLoads, OfWormsAreThoseOfFrictionAcross) {
  RobotSpec robot = sample::jaws();
  robot.dofs[0].backdrivable = false;
  EXPECT_NEAR(SqueezedBall(robot).loads().margin.at("pull"), 2, 1e-6);
}

// The palm above and below bears whatever pulls along it. By efforts it pushes back no more than
// the 2 N that the motor presses with, and friction of 1 bears as much again.
TEST(GraspLoads, TellWhatEffortsBearApartFromStructure) {
  SqueezedBall squeeze(sample::jaws());
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d n(0, 0, -side);
    squeeze.grasp.contacts.push_back({{squeeze.setup.object.com - 0.015 * n, n, 0, 0}, 0, 0});
  }
  const GraspLoads loads = squeeze.loads();
  EXPECT_NEAR(loads.margin.at("pull"), 4, 1e-6);
  EXPECT_EQ(loads.with_structure.at("pull"), std::numeric_limits<double>::infinity());
  EXPECT_THAT(loads.reasons.at("pull"), HasSubstr("rigid structure"));
}

// The palm alone, on all sides of the cube, two contacts a face: no motor is asked, nor a number.
TEST(GraspLoads, SayWhyTheyHaveNoLimit) {
  SqueezedBall squeeze(sample::jaws());
  const Eigen::Vector3d centre = squeeze.setup.object.com;
  squeeze.grasp.contacts.clear();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const double beside : {-0.01, 0.01}) {
        const Eigen::Vector3d n = -side * Eigen::Vector3d::Unit(axis);
        squeeze.grasp.contacts.push_back(
            {{centre - 0.015 * n + beside * Eigen::Vector3d::Unit((axis + 1) % 3), n, 0, 0}, 0, 0});
      }
  const GraspLoads loads = squeeze.loads();
  EXPECT_EQ(loads.margin.at("pull"), 0);
  EXPECT_EQ(loads.with_structure.at("pull"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(loads.reasons.at("pull"), "supported by rigid structure (strength unknown)");
  const ExplainedLoad epsilon = hand_epsilon(squeeze.held(), squeeze.setup.object);
  EXPECT_EQ(epsilon.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(epsilon.message, "supported by rigid structure (strength unknown)");
}

// Along x a jaw at most lets go of 2 N, across it friction bears no more; turned about an axis the
// corners do so: no wrench of 2 N or less needs more than the motor has, some of 2 N do.
TEST(HandEpsilon, OfJawsIsAtMostWhatTheyHoldAcross) {
  const SqueezedBall squeeze(sample::jaws());
  const ExplainedLoad epsilon = hand_epsilon(squeeze.held(), squeeze.setup.object);
  EXPECT_GT(epsilon.value, 0);
  EXPECT_LE(epsilon.value, 2 + 1e-6);
}

// Forces grow with the motor, and so does the ball.
TEST(HandEpsilon, GrowsWithTheMotor) {
  RobotSpec strong = sample::jaws();
  strong.dofs[0].max_effort *= 10;
  const SqueezedBall weak(sample::jaws()), ten(strong);
  const double one = hand_epsilon(weak.held(), weak.setup.object).value;
  EXPECT_NEAR(hand_epsilon(ten.held(), ten.setup.object).value / one, 10, 0.5);  // 5 % each
}

TEST(HandOnObject, TakesTheLargestLoadAndCountsThoseThatAreKnown) {
  HandOnObject cell;
  EXPECT_EQ(cell.load(GraspTask::kPull).total, 0);
  cell.best.resize(4);
  cell.best[0].margin["pull"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(cell.load(GraspTask::kPull).max));
  EXPECT_EQ(cell.load(GraspTask::kPull).total, 1);
  cell.best[1].margin["pull"] = 3;
  cell.best[2].margin["pull"] = 2;
  EXPECT_EQ(cell.load(GraspTask::kPull).max, 3);
  EXPECT_EQ(cell.load(GraspTask::kPull).known, 2);
  EXPECT_EQ(cell.load(GraspTask::kPull).total, 3);  // nobody asked the fourth
}

TEST(HandOnObject, TakesTheLargestEpsilonOfTheHandAndTheLeastSqueeze) {
  HandOnObject cell;
  EXPECT_TRUE(std::isnan(cell.min_grasp_force()));
  cell.closures = 3;
  cell.hand_epsilon = Eigen::Vector2d(1, 4);
  EXPECT_EQ(cell.best_hand_epsilon().max, 4);
  EXPECT_EQ(cell.best_hand_epsilon().known, 2);
  EXPECT_EQ(cell.best_hand_epsilon().total, 3);
  cell.best.resize(2);
  cell.best[0].min_grasp_force = 7;
  cell.best[1].min_grasp_force = 5;
  EXPECT_EQ(cell.min_grasp_force(), 5);
}

}  // namespace
}  // namespace thenar
