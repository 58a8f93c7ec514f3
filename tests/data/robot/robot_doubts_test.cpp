// Tests for data/io/robot/robot_doubts.cpp: what a person would doubt is told, and nothing else.

#include "data/io/robot/robot_doubts.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data/io/robot/import_robot.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A palm with two fingers, as a common exporter writes it.
class RobotDoubts : public TemporaryFolder {
 protected:
  [[nodiscard]] RobotSpec robot(const std::string& kind, const std::string& upper,
                                const std::string& efforts,
                                const std::string& mass = "0.05") const {
    const auto link = [](const std::string& name, const std::string& of) {
      return "<link name='" + name + "'><inertial><mass value='" + of +
             "'/><inertia ixx='1e-5' iyy='1e-5' izz='1e-5' ixy='0' ixz='0' iyz='0'/></inertial>"
             "<collision><geometry><box size='.02 .01 .06'/></geometry></collision></link>\n";
    };
    std::string text = "<robot name='two'>\n" + link("palm", "0.3");
    const std::string second = efforts.substr(efforts.find(' ') + 1);
    for (const auto& [name, effort] :
         {std::pair<std::string, std::string>("left", efforts.substr(0, efforts.find(' '))),
          std::pair<std::string, std::string>("right", second)})
      text += link(name, mass) +
              fmt::format(
                  "<joint name='{}_j' type='{}'><parent link='palm'/><child link='{}'/>"
                  "<axis xyz='0 1 0'/><limit lower='0' upper='{}' effort='{}' "
                  "velocity='1'/></joint>\n",
                  name, kind, name, upper, effort);
    std::ofstream(path("two.urdf")) << text << "</robot>\n";
    return import_robot(path("two.urdf"));
  }
};

TEST_F(RobotDoubts, AreNoneOfAnOrdinaryHand) {
  const RobotSpec hand = robot("revolute", "1.5", "3 5");
  EXPECT_THAT(hand.warnings, IsEmpty());
  EXPECT_FALSE(hand.dofs[0].nominal_effort);
}

TEST_F(RobotDoubts, AreOfLimitsInDegrees) {
  const RobotSpec hand = robot("revolute", "90", "3 5");
  EXPECT_THAT(
      hand.warnings,
      ElementsAre("hinge 'left_j' turns by 5157 degrees: are its limits degrees? Angles are "
                  "read as radians",
                  "hinge 'right_j' turns by 5157 degrees: are its limits degrees? Angles "
                  "are read as radians"));
  EXPECT_TRUE(is_serious(hand.warnings[0]));
  EXPECT_THAT(robot("prismatic", "90", "3 5").warnings, Not(Contains(HasSubstr("degrees"))));
}

TEST_F(RobotDoubts, AreOfTravelInMillimetres) {
  const RobotSpec hand = robot("prismatic", "30", "30 50");
  EXPECT_THAT(hand.warnings,
              ElementsAre("joints 'left_j', 'right_j' slide by up to 30 m: are their limits "
                          "millimetres? Lengths are read as metres"));
  EXPECT_TRUE(is_serious(hand.warnings[0]));
  EXPECT_THAT(robot("prismatic", "0.9", "30 50").warnings, IsEmpty());
}

TEST_F(RobotDoubts, AreOfJointsThatCannotMove) {
  const RobotSpec hand = robot("prismatic", "0", "3 5");
  EXPECT_THAT(hand.warnings, ElementsAre("joints 'left_j', 'right_j' cannot move: the upper limit "
                                         "is the lower one"));
  EXPECT_TRUE(is_serious(hand.warnings[0]));
}

TEST_F(RobotDoubts, AreOfLinksWithoutMass) {
  EXPECT_THAT(robot("revolute", "1.5", "3 5", "0").warnings,
              ElementsAre("links 'left', 'right' have shapes and no mass"));
}

TEST_F(RobotDoubts, AreOfRobotsThatWeighNothing) {
  RobotSpec hand = robot("revolute", "1.5", "3 5");
  for (RobotLink& link : hand.links) link.mass = 0;
  EXPECT_THAT(mass_doubts(hand), ElementsAre("no link has a mass: nothing tells how the robot "
                                             "moves, or how heavy it is"));
}

TEST_F(RobotDoubts, AreOfAnEffortThatOneJointLacks) {
  EXPECT_THAT(robot("revolute", "1.5", "0 5").warnings,
              ElementsAre("joint 'left_j' has no effort, unlike others: it is unknown"));
}

// Efforts of 1000 at every joint, or round ones of 100 and more, are no motor's.
TEST_F(RobotDoubts, AreOfEffortsThatStandForUnknownOnes) {
  for (const char* placeholders : {"1000 1000", "100 100", "100 250"}) {
    const RobotSpec hand = robot("revolute", "1.5", placeholders);
    EXPECT_THAT(hand.warnings, Contains(HasSubstr("treated as placeholders"))) << placeholders;
    EXPECT_TRUE(hand.dofs[0].nominal_effort && hand.dofs[1].nominal_effort) << placeholders;
  }
  for (const char* stated : {"1000 2.5", "103 117", "99 99"}) {
    const RobotSpec hand = robot("revolute", "1.5", stated);
    EXPECT_THAT(hand.warnings, IsEmpty()) << stated;
    EXPECT_FALSE(hand.dofs[0].nominal_effort) << stated;
  }
  // A parallel jaw may well close with 160 N.
  EXPECT_THAT(robot("prismatic", "0.04", "160 160").warnings, IsEmpty());
  EXPECT_TRUE(robot("prismatic", "0.04", "1000 1000").dofs[0].nominal_effort);
  const RobotSpec none = robot("revolute", "1.5", "0 0");
  EXPECT_THAT(none.warnings, ElementsAre("no joint has an effort: all are of unknown effort"));
}

// 1000 at every second joint of a hand of 2.5 and 3 N m; an arm's shoulder may well have 330 N m
// beside 56.
TEST_F(RobotDoubts, AreOfPlaceholdersBesideTrueEfforts) {
  RobotSpec hand = robot("revolute", "1.5", "1000 2.5");
  hand.dofs.insert(hand.dofs.end(), {hand.dofs[0], hand.dofs[1]});
  hand.dofs[3].max_effort = 3;
  doubt_efforts(hand);
  EXPECT_THAT(hand.warnings, Contains(HasSubstr("efforts of 1000 at joints 'left_j', 'left_j', far "
                                                "above all others, are treated as placeholders")));
  EXPECT_TRUE(hand.dofs[0].nominal_effort && hand.dofs[2].nominal_effort);
  EXPECT_FALSE(hand.dofs[1].nominal_effort || hand.dofs[3].nominal_effort);
  RobotSpec arm = robot("revolute", "1.5", "330 56");
  arm.dofs.insert(arm.dofs.end(), {arm.dofs[0], arm.dofs[1]});
  doubt_efforts(arm);
  EXPECT_THAT(arm.warnings, IsEmpty());
}

// Robots that come with thenar have none, but for masses that nobody has published: of the first
// link of a Puma, which turns about an upright axis, and of all of the Rutgers hand.
TEST(RobotDoubtsShipped, AreNone) {
  for (const auto& file : std::filesystem::directory_iterator(std::string(kData) + "/robots")) {
    if (file.path().extension() != ".toml") continue;
    const RobotSpec robot = read_robot(file.path().string());
    EXPECT_THAT(robot_doubts(robot), IsEmpty()) << file.path();
    if (file.path().stem() == "puma560") {
      EXPECT_THAT(mass_doubts(robot), ElementsAre("link 'link 1' has shapes and no mass"));
    } else if (file.path().stem() == "rutgers") {
      EXPECT_THAT(mass_doubts(robot), ElementsAre(HasSubstr("no link has a mass")));
    } else {
      EXPECT_THAT(mass_doubts(robot), IsEmpty()) << file.path();
    }
  }
}

}  // namespace
}  // namespace thenar
