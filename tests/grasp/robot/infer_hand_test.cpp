// Tests for grasp/robot/infer_hand.cpp and grasp/infer_digits.cpp.

#include "grasp/robot/infer_hand.h"

#include <gmock/gmock.h>

#include "tests/grasp/four_bars.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Jaws that go at things along y, as formats without hands in mind have them: closed at 0, opening
/// upwards.
RobotSpec bare_jaws() {
  RobotSpec robot = sample::jaws();
  robot.approach = {};
  robot.closing_stated = robot.approach_stated = false;
  for (RobotLink& link : robot.links) link.digit = link.material = "";
  for (RobotJoint& joint : robot.joints) {
    joint.axis *= -1;
    joint.X_PJ.p.x() /= 10;
  }
  return robot;
}

TEST(GuessHand, NamesBranchesDigitsAndTakesPlastic) {
  const RobotSpec robot = graspable(bare_jaws());
  EXPECT_EQ(robot.links[0].digit, "");
  EXPECT_EQ(robot.links[1].digit, "finger 1");
  EXPECT_EQ(robot.links[2].digit, "finger 2");
  for (const RobotLink& link : robot.links) EXPECT_EQ(link.material, kDefaultMaterial);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("plastic is assumed for base, left, right")));
}

TEST(GuessHand, TakesPadsNamedAfterSoftMaterialsForRubber) {
  RobotSpec robot = bare_jaws();
  robot.links[2].name = robot.joints[1].child = "Right_Silicone_pad";
  const RobotSpec found = graspable(robot);
  EXPECT_EQ(found.links[1].material, kDefaultMaterial);
  EXPECT_EQ(found.links[2].material, "rubber");
  EXPECT_THAT(found.warnings, Contains(HasSubstr("rubber is assumed for Right_Silicone_pad")));
}

TEST(GuessHand, ClosesTheWayInWhichTipsMeet) { EXPECT_LT(graspable(bare_jaws()).dofs[0].speed, 0); }

// The palm's box ends 5 mm behind its middle at y = -30 mm; the jaws lie ahead of it along y.
TEST(GuessHand, GoesFromThePalmToTheTips) {
  const RobotApproach approach = graspable(bare_jaws()).approach;
  EXPECT_NEAR(approach.direction.y(), 1, 1e-12);
  EXPECT_NEAR(approach.point.y(), -0.025, 1e-12);
}

// A format without closing says how fast (2 mm/s here), not which way; digits may be stated by
// hand.
TEST(GuessHand, GuessesTheClosingThatNoFileStates) {
  RobotSpec robot = bare_jaws();
  robot.closing_stated = false;
  robot.dofs[0].speed = 0.002;
  robot.links[1].digit = "a";
  robot.links[2].digit = "b";
  EXPECT_EQ(graspable(robot).dofs[0].speed, -0.002);
  EXPECT_TRUE(graspable(robot).closing_stated);
  robot.closing_stated = true;
  EXPECT_EQ(graspable(robot).dofs[0].speed, 0.002);
  robot.dofs[0].speed = 0;
  EXPECT_EQ(graspable(robot).dofs[0].speed, -1);
}

// These jaws close downwards. A motor that only pulls upwards has nothing to close them with.
TEST(GuessHand, TakesTheEffortOfTheDirectionThatCloses) {
  RobotSpec robot = bare_jaws();
  robot.dofs[0].max_effort = robot.dofs[0].effort_up = 20;
  robot.dofs[0].effort_down = 60;
  const RobotSpec found = graspable(robot);
  EXPECT_EQ(found.dofs[0].max_effort, 60);
  EXPECT_THAT(found.warnings,
              Contains("efforts are those of the direction that closes: 60 for 'motor'"));
  robot.dofs[0].effort_down = 0;
  const RobotSpec opening = graspable(robot);
  EXPECT_EQ(opening.dofs[0].max_effort, 0);
  EXPECT_THAT(opening.warnings,
              Contains("no effort in the direction that closes: 'motor'; it is unknown"));
}

TEST(GuessHand, SaysWhichEffortsAreNominal) {
  RobotSpec robot = sample::jaws();
  robot.dofs[0].nominal_effort = true;
  EXPECT_THAT(graspable(robot).warnings,
              Contains(HasSubstr("effort limits of motor look like placeholders")));
}

TEST(GuessHand, LeavesAloneWhatIsStated) {
  const RobotSpec stated = sample::jaws(), robot = graspable(stated);
  EXPECT_EQ(robot.links[1].digit, "left");
  EXPECT_EQ(robot.approach.direction, stated.approach.direction);
  EXPECT_EQ(robot.dofs[0].speed, stated.dofs[0].speed);
  EXPECT_TRUE(robot.warnings.empty());
}

// The bar's outer hinge would be in the finger.
TEST(InferDigits, TakesTheBarsOfALinkageForTheFingersThatTheyMove) {
  const RobotSpec robot = graspable(sample::four_bars(0));
  EXPECT_EQ(digits_in(robot).size(), 2U);
  for (const RobotLink& link : robot.links) {
    if (link.name == "base") continue;
    EXPECT_EQ(link.digit, link.name.rfind("left", 0) == 0 ? "finger 1" : "finger 2") << link.name;
  }
  EXPECT_GT(robot.dofs[0].speed, 0);
  EXPECT_NEAR(robot.approach.direction.z(), 1, 1e-9);
}

// A finger of its own beside the others moves as they do, but an axis in both is in neither.
TEST(InferDigits, KeepsFingersThatStandBesideALinkage) {
  EXPECT_EQ(digits_in(graspable(sample::four_bars(0.08))).size(), 4U);
}

}  // namespace
}  // namespace thenar
