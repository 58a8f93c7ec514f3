// Tests for data/io/robot/mjcf.cpp, mjcf_drive.cpp, mjcf_geom.cpp and mjcf_source.cpp.

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/mjcf_parts.h"
#include "data/io/robot/urdf.h"
#include "tests/data/robot/named_parts.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kMjcfRounding = 1e-14;  // of a few products of numbers near one

class Mjcf : public TemporaryFolder {
 protected:
  RobotSpec read(const std::string& text) {
    write_file(path("model.xml"), text);
    return read_mjcf(path("model.xml"));
  }
  /// A palm at the origin with this inside, and these sections after the world.
  RobotSpec palm(const std::string& content, const std::string& sections = "") {
    return read("<mujoco model='m'><worldbody><body name='palm'>" + content +
                "</body></worldbody>" + sections + "</mujoco>");
  }
  /// A body whose frame is given by these attributes.
  Eigen::Matrix3d turned(const std::string& attributes, const std::string& compiler = "") {
    const RobotSpec robot =
        read("<mujoco><compiler " + compiler + "/><worldbody><body name='palm'><body name='b' " +
             attributes + "/></body></worldbody></mujoco>");
    return link_poses(robot, {})[1].R;
  }
  std::string refusal(const std::string& text) {
    return message_of<DataError>([&] { (void)read(text); });
  }
};

/// A chain of three bodies with hinges 1, 2, 3 about y, 0 to 90 degrees.
const std::string kFinger =
    "<body name='a'><joint name='1' axis='0 1 0' range='0 90'/>"
    "<body name='b' pos='0 0 0.04'><joint name='2' axis='0 1 0' range='0 90'/>"
    "<body name='c' pos='0 0 0.03'><joint name='3' axis='0 1 0' range='0 "
    "90'/></body></body></body>";

Eigen::Matrix3d about(int axis, double angle) {
  return rotation_about<double>(Eigen::Vector3d::Unit(axis), angle);
}

TEST_F(Mjcf, ReadsEveryOrientation) {
  const Eigen::Matrix3d quarter = about(2, kPi / 2);
  EXPECT_TRUE(matrix_near(turned("quat='1 0 0 1'"), quarter, kMjcfRounding));
  EXPECT_TRUE(matrix_near(turned("axisangle='0 0 2 90'"), quarter, kMjcfRounding));
  EXPECT_TRUE(matrix_near(turned("euler='0 0 90'"), quarter, kMjcfRounding));
  EXPECT_TRUE(matrix_near(turned("xyaxes='0 1 0 -1 0.5 0'"), quarter,
                          kMjcfRounding));  // y is made orthogonal to x
  EXPECT_TRUE(matrix_near(turned("zaxis='1 0 0'"), about(1, kPi / 2), kMjcfRounding));
  EXPECT_TRUE(matrix_near(turned("axisangle='0 0 1 1.5707963267948966'", "angle='radian'"), quarter,
                          kMjcfRounding));
}

TEST_F(Mjcf, HeedsTheSequenceOfEulerAngles) {
  const double a = radians(10), b = radians(20), c = radians(30);
  const std::string angles = "euler='10 20 30'";
  EXPECT_TRUE(matrix_near(turned(angles), about(0, a) * about(1, b) * about(2, c), kMjcfRounding));
  EXPECT_TRUE(matrix_near(turned(angles, "eulerseq='zyx'"), about(2, a) * about(1, b) * about(0, c),
                          kMjcfRounding));
  // Capitals turn about the fixed frame, so later turns stand on the left.
  EXPECT_TRUE(matrix_near(turned(angles, "eulerseq='XYZ'"), about(2, c) * about(1, b) * about(0, a),
                          kMjcfRounding));
}

TEST_F(Mjcf, InheritsDefaultsThroughClassesAndChildclass) {
  const RobotSpec robot = read(
      "<mujoco><compiler angle='radian'/>"
      "<default><joint damping='1' range='0 1'/><geom size='0.1'/>"
      "<default class='finger'><joint axis='1 0 0'/>"
      "<default class='tip'><joint damping='3'/></default></default></default>"
      "<worldbody><body name='palm'><body name='a'><joint name='plain'/>"
      "<body name='b' childclass='finger'><joint name='inherits'/>"
      "<body name='c'><joint name='own' class='tip' frictionloss='5'/>"
      "<body name='d'><joint name='main' class='main'/></body></body></body></body></body>"
      "</worldbody></mujoco>");
  ASSERT_THAT(names(robot.joints), ElementsAre("plain", "inherits", "own", "main"));
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(robot.joints[0].upper, 1);
  EXPECT_EQ(robot.joints[1].axis, Eigen::Vector3d::UnitX());
  EXPECT_EQ(robot.joints[1].damping, 1);
  EXPECT_EQ(robot.joints[2].axis, Eigen::Vector3d::UnitX());
  EXPECT_EQ(robot.joints[2].damping, 3);
  EXPECT_EQ(robot.joints[2].friction, 5);
  EXPECT_EQ(robot.joints[3].axis, Eigen::Vector3d::UnitZ());
}

// Two hinges of one body, the second beside the origin. First a quarter turn about z, which carries
// everything; the second, about x through (0, 0.1, 0), turns the body itself by a quarter.
// The origin, 0.1 before the second axis, goes to (0, 0.1, -0.1) and then by the first turn
// to (-0.1, 0, -0.1).
TEST_F(Mjcf, PutsLinksWithoutMassBetweenTheJointsOfABody) {
  const RobotSpec robot = palm(
      "<body name='b' pos='0 0 1'><joint name='1' axis='0 0 1' range='-90 90'/>"
      "<joint name='2' axis='1 0 0' pos='0 0.1 0' range='-90 90'/><geom size='0.01' "
      "mass='2'/></body>");
  EXPECT_THAT(names(robot.links), ElementsAre("palm", "b", "b after 1"));
  EXPECT_THAT(names(robot.joints), ElementsAre("1", "2"));
  EXPECT_EQ(robot.links[2].mass, 0);
  EXPECT_NO_THROW(check_robot(robot));
  const Pose<double> X = link_poses(robot, {{"1", kPi / 2}, {"2", kPi / 2}})[1];
  EXPECT_TRUE(matrix_near(X.p, Eigen::Vector3d(-0.1, 0, 0.9), kMjcfRounding));
  EXPECT_TRUE(matrix_near(X.R, about(2, kPi / 2) * about(0, kPi / 2), kMjcfRounding));
}

// At qpos = ref the body stands as written.
TEST_F(Mjcf, StandsAsWrittenAtTheReference) {
  const RobotSpec robot =
      palm("<body name='b' pos='0.1 0 0'><joint name='1' ref='30' range='0 60'/></body>");
  EXPECT_TRUE(matrix_near(link_poses(robot, {{"1", radians(30)}})[1].R, Eigen::Matrix3d::Identity(),
                          kMjcfRounding));
  EXPECT_TRUE(matrix_near(link_poses(robot, {})[1].R, about(2, radians(-30)), kMjcfRounding));
}

TEST_F(Mjcf, KeepsAWorldOnlyWhereItPlacesSomething) {
  EXPECT_THAT(names(palm("").links), ElementsAre("palm"));
  const RobotSpec placed =
      read("<mujoco><worldbody><body name='palm' pos='0 0 0.1'/></worldbody></mujoco>");
  EXPECT_THAT(names(placed.links), ElementsAre("world", "palm"));
  EXPECT_EQ(link_poses(placed, {})[1].p, Eigen::Vector3d(0, 0, 0.1));
  const RobotSpec two =
      read("<mujoco><worldbody><body name='a'/><body name='b'/></worldbody></mujoco>");
  EXPECT_THAT(names(two.links), ElementsAre("world", "a", "b"));
}

TEST_F(Mjcf, TakesFullSizesFromHalfOnes) {
  const RobotSpec robot = palm(
      "<geom type='box' size='0.1 0.2 0.3'/><geom type='cylinder' size='0.1 0.2'/>"
      "<geom type='ellipsoid' size='0.1 0.2 0.3'/>"
      "<geom type='capsule' size='0.01' fromto='0 0 0 0.2 0 0'/>"
      "<geom type='sphere' size='0.7' contype='0' conaffinity='0'/>");
  const std::vector<ShapeSpec>& shapes = robot.links[0].shapes;
  ASSERT_EQ(shapes.size(), 4U);  // the last one is only seen
  EXPECT_EQ(shapes[0].size, Eigen::Vector3d(0.2, 0.4, 0.6));
  EXPECT_EQ(shapes[1].size.head<2>(), Eigen::Vector2d(0.1, 0.4));
  EXPECT_EQ(shapes[2].size, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_TRUE(matrix_near(shapes[3].size.head<2>(), Eigen::Vector2d(0.01, 0.2), kMjcfRounding));
  EXPECT_TRUE(matrix_near(shapes[3].X_BS.p, Eigen::Vector3d(0.1, 0, 0), kMjcfRounding));
  EXPECT_TRUE(
      matrix_near(shapes[3].X_BS.R.col(2).cwiseAbs(), Eigen::Vector3d(1, 0, 0), kMjcfRounding));
}

// A box of 0.2 x 0.4 x 0.6 of water weighs 48 kg; a ball of given mass 2 kg stands 0.25 to the
// side. Together: centre at 2 * 0.25 / 50 = 0.01; about it z gains 48 * 0.01^2 + 2 * 0.24^2.
TEST_F(Mjcf, WeighsBodiesByTheirGeoms) {
  const RobotLink palm_link = palm(
                                  "<geom type='box' size='0.1 0.2 0.3'/>"
                                  "<geom size='0.1' pos='0.25 0 0' mass='2'/>")
                                  .links[0];
  EXPECT_NEAR(palm_link.mass, 50, 1e-12);
  EXPECT_TRUE(matrix_near(palm_link.com, Eigen::Vector3d(0.01, 0, 0), kMjcfRounding));
  const double box = 48. / 12 * (0.2 * 0.2 + 0.4 * 0.4), ball = 0.4 * 2 * 0.01;
  EXPECT_NEAR(palm_link.inertia(2, 2), box + ball + 48 * 1e-4 + 2 * 0.24 * 0.24, 1e-12);
}

// Capsule r = 1, length between centres 2: cylinder 2 pi, ball 4/3 pi; along the axis
// 2 pi / 2 + 4/3 pi 2/5; across 2 pi (3 + 4) / 12 + 4/3 pi (2/5 + 1 + 3/4).
TEST_F(Mjcf, WeighsCapsulesAsInClosedForm) {
  const RobotLink link = palm("<geom type='capsule' size='1 1' density='1'/>").links[0];
  EXPECT_NEAR(link.mass, 10 * kPi / 3, 1e-12);
  EXPECT_NEAR(link.inertia(2, 2), kPi * (1 + 8. / 15), 1e-12);
  EXPECT_NEAR(link.inertia(0, 0), kPi * (7. / 6 + 4. / 3 * 2.15), 1e-12);
}

// The corner of a cube of edge 1, cut off: volume 1/6, centroid at 1/4 each; second moments of the
// simplex 1/60 each, products 1/120, less m c c'.
TEST_F(Mjcf, WeighsAndPlacesWrittenMeshes) {
  const RobotSpec robot =
      palm("<geom type='mesh' mesh='corner' density='6'/>",
           "<asset><mesh name='corner' vertex='1 1 1  2 1 1  1 2 1  1 1 2' refpos='1 1 1' "
           "face='0 2 1  0 1 3  0 3 2  1 2 3'/></asset>");
  const RobotLink& link = robot.links[0];
  EXPECT_NEAR(link.mass, 1, kMjcfRounding);
  EXPECT_TRUE(matrix_near(link.com, Eigen::Vector3d::Constant(0.25), kMjcfRounding));
  EXPECT_NEAR(link.inertia(0, 0), 2 * (0.1 - 0.0625), kMjcfRounding);
  EXPECT_NEAR(link.inertia(0, 1), -(0.05 - 0.0625), kMjcfRounding);
}

TEST_F(Mjcf, ReadsInertialsInTheirFrame) {
  const RobotLink link = palm(
                             "<inertial mass='2' pos='0.1 0 0' euler='0 0 90' "
                             "diaginertia='1 2 2.5'/><geom size='1'/>")
                             .links[0];
  EXPECT_EQ(link.mass, 2);
  EXPECT_EQ(link.com, Eigen::Vector3d(0.1, 0, 0));
  EXPECT_TRUE(matrix_near(link.inertia, Eigen::Vector3d(2, 1, 2.5).asDiagonal(), kMjcfRounding));
  const RobotLink full =
      palm("<inertial mass='2' pos='0 0 0' fullinertia='1 2 2.5 0.1 0.2 0.3'/>").links[0];
  EXPECT_EQ(full.inertia(0, 1), 0.1);
  EXPECT_EQ(full.inertia(2, 0), 0.2);
  EXPECT_EQ(full.inertia(1, 2), 0.3);
}

// polycoef of joint 2 after 1, and of 3 after 2: 3 = 0.5 (2 q1 + 0.1) + 0.2.
TEST_F(Mjcf, CouplesJointsByEqualities) {
  const RobotSpec robot =
      palm(kFinger,
           "<equality><joint joint1='2' joint2='1' polycoef='0.1 2 0 0 0'/>"
           "<joint joint1='3' joint2='2' polycoef='0.2 0.5 0 0 0'/></equality>");
  ASSERT_THAT(names(robot.dofs), ElementsAre("1"));
  EXPECT_EQ(robot.dofs[0].kind, DriveCoupling::kRigid);
  EXPECT_EQ(robot.joints[1].ratio, 2);
  EXPECT_EQ(robot.joints[1].offset, 0.1);
  EXPECT_DOUBLE_EQ(robot.joints[2].ratio, 1);
  EXPECT_DOUBLE_EQ(robot.joints[2].offset, 0.25);
  // Joint 2 reaches 90 degrees first.
  EXPECT_NEAR(robot.dofs[0].upper, (kPi / 2 - 0.1) / 2, kMjcfRounding);
}

// L = q2 + q3 pulled by one actuator: each goes half the way, and 180 degrees of L are 90 of each.
TEST_F(Mjcf, SharesATendonAsEqualSpringsWould) {
  const RobotSpec robot = palm(
      kFinger,
      "<tendon><fixed name='t'><joint joint='2' coef='1'/><joint joint='3' "
      "coef='1'/></fixed></tendon>"
      "<actuator><position joint='1' forcerange='-3 3'/><position tendon='t' forcerange='-4 4'/>"
      "</actuator>");
  ASSERT_THAT(names(robot.dofs), ElementsAre("1", "t"));
  EXPECT_EQ(robot.dofs[0].max_effort, 3);
  EXPECT_EQ(robot.dofs[1].kind, DriveCoupling::kCompliant);
  EXPECT_EQ(robot.dofs[1].max_effort, 4);
  EXPECT_NEAR(robot.dofs[1].upper, kPi, kMjcfRounding);
  EXPECT_EQ(robot.joints[1].dof, "t");
  EXPECT_EQ(robot.joints[1].ratio, 0.5);
  EXPECT_EQ(robot.joints[2].ratio, 0.5);
}

// 0.008 q2 - 0.008 q3 held at its length: the joints turn alike.
TEST_F(Mjcf, CouplesJointsByTheEqualityOfATendon) {
  const RobotSpec robot =
      palm(kFinger,
           "<tendon><fixed name='t'><joint joint='2' coef='0.008'/><joint joint='3' coef='-0.008'/>"
           "</fixed></tendon><equality><tendon tendon1='t'/></equality>");
  EXPECT_THAT(names(robot.dofs), ElementsAre("1", "2"));
  EXPECT_EQ(robot.joints[2].dof, "2");
  EXPECT_EQ(robot.joints[2].ratio, 1);
}

// 0.00705 q3 - 0.00805 q2 within +-0.001, a fifth of a degree or so off the coupling that is meant.
TEST_F(Mjcf, CouplesJointsByATendonWithoutMuchRoom) {
  const RobotSpec robot =
      palm(kFinger,
           "<tendon><fixed name='t' limited='true' range='-0.001 0.001'>"
           "<joint joint='3' coef='0.00705'/><joint joint='2' coef='-0.00805'/></fixed></tendon>"
           "<actuator><position joint='1'/><position joint='2'/></actuator>");
  EXPECT_THAT(names(robot.dofs), ElementsAre("1", "2"));
  EXPECT_EQ(robot.joints[2].dof, "2");
  EXPECT_NEAR(robot.joints[2].ratio, 0.00805 / 0.00705, kMjcfRounding);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("limits of tendon 't' couple '3' to '2'")));
}

// Joint 3 follows joint 2 by the first; neither can what says how it follows be kept, nor what says
// nothing of the follower.
TEST_F(Mjcf, NamesLimitedTendonsWhoseJointFollowsAlready) {
  const auto limited = [](const std::string& name, const std::string& leader,
                          const std::string& coefficient) {
    return "<fixed name='" + name + "' limited='true' range='-0.001 0.001'><joint joint='" +
           leader + "' coef='1'/><joint joint='3' coef='" + coefficient + "'/></fixed>";
  };
  const RobotSpec robot =
      palm(kFinger, "<tendon>" + limited("t", "2", "-1") + limited("u", "1", "-1") + "</tendon>");
  EXPECT_EQ(robot.joints[2].dof, "2");
  EXPECT_THAT(robot.warnings,
              Contains(HasSubstr("limits of tendon 'u' (-0.001 to 0.001) are not kept: joint '3' "
                                 "follows another already")));
  const RobotSpec zero = palm(kFinger, "<tendon>" + limited("t", "2", "0") + "</tendon>");
  EXPECT_THAT(zero.warnings, Contains(HasSubstr("limits of tendon 't' (-0.001 to 0.001) are not "
                                                "kept: its coefficient of joint '3' is zero")));
}

// v^4 of v^4 is of degree 16, of that once more of degree 64.
TEST_F(Mjcf, FollowsPolynomialsOfPolynomialsToABound) {
  const auto follows = [](int joint, int master) {
    return "<joint joint1='" + std::to_string(joint) + "' joint2='" + std::to_string(master) +
           "' polycoef='0 0 0 0 1'/>";
  };
  const RobotSpec robot =
      palm(kFinger, "<equality>" + follows(2, 1) + follows(3, 2) + "</equality>");
  ASSERT_EQ(robot.joints[2].curve.size(), 15U);
  EXPECT_EQ(robot.joints[2].curve.back(), 1);
  std::string chain = "<mujoco><worldbody><body name='b0'>", equalities = "<equality>";
  for (int i = 1; i <= 12; ++i) {
    chain += "<body name='b" + std::to_string(i) + "'><joint name='" + std::to_string(i) +
             "' range='-60 60'/>";
    if (i > 1) equalities += follows(i, i - 1);
  }
  for (int i = 0; i <= 12; ++i) chain += "</body>";
  EXPECT_THAT(refusal(chain + "</worldbody>" + equalities + "</equality></mujoco>"),
              HasSubstr("joint '4' follows '1' through '2' along a polynomial of degree 64, more "
                        "than 16: let it follow '1' along one of its own"));
}

TEST_F(Mjcf, NamesLimitsOfTendonsThatItDoesNotKeep) {
  const RobotSpec robot =
      palm(kFinger,
           "<tendon><fixed name='t' range='0 0.01'><joint joint='3' coef='0.007'/>"
           "<joint joint='2' coef='0.008'/></fixed></tendon>");
  EXPECT_THAT(names(robot.dofs), ElementsAre("1", "2", "3"));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("limits of tendon 't' (0 to 0.01) are not kept")));
}

TEST_F(Mjcf, TakesEffortsFromForceRangesOrMotorsGears) {
  const RobotSpec robot =
      palm(kFinger,
           "<default><motor ctrlrange='-0.5 0.5' gear='4'/></default>"
           "<actuator><motor joint='1'/><general joint='2' forcerange='-1 1' gear='3'/>"
           "</actuator>");
  EXPECT_EQ(robot.dofs[0].max_effort, 2);
  EXPECT_EQ(robot.dofs[1].max_effort, 3);
  EXPECT_EQ(robot.dofs[2].max_effort, 0);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("no actuator drives 3")));
}

// Gain 3, control up to 2, gear 5; a servo's gain says nothing of its strength.
TEST_F(Mjcf, TakesEffortsOfGeneralActuatorsThatAreMotors) {
  const RobotSpec robot =
      palm(kFinger,
           "<actuator><general name='A' joint='1' gainprm='3' gear='5' ctrlrange='-2 2'/>"
           "<general name='B' joint='2' gainprm='3' biastype='affine' ctrlrange='0 1'/>"
           "</actuator>");
  EXPECT_EQ(robot.dofs[0].max_effort, 30);
  EXPECT_EQ(robot.dofs[1].max_effort, 0);
}

// Directions are those of the joint: a gear of -2 turns them round.
TEST_F(Mjcf, TakesTheSmallerOfEffortsThatDifferByDirection) {
  const RobotSpec robot =
      palm(kFinger,
           "<actuator><position joint='1' forcerange='-60 20'/>"
           "<motor joint='2' gear='-2' ctrlrange='-3 5'/><motor joint='3' ctrlrange='-60 0'/>"
           "</actuator>");
  EXPECT_EQ(robot.dofs[0].max_effort, 20);
  EXPECT_EQ(robot.dofs[0].effort_down, 60);
  EXPECT_EQ(robot.dofs[1].max_effort, 6);
  EXPECT_EQ(robot.dofs[1].effort_down, 10);
  EXPECT_EQ(robot.dofs[2].max_effort, 60);
  EXPECT_EQ(robot.dofs[2].effort_up, 0);
  EXPECT_THAT(
      robot.warnings,
      Contains("efforts differ by direction, unless closing is inferred and decides: '1' 20 "
               "upwards and 60 downwards, of which 20 is taken, '2' 6 upwards and 10 downwards, of "
               "which 6 is taken, '3' 0 upwards and 60 downwards, of which 60 is taken"));
}

// One motor flexes with 5 N m, another extends with 2: not 7 either way.
TEST_F(Mjcf, AddsEffortsInEachDirection) {
  const RobotSpec robot =
      palm(kFinger,
           "<actuator><motor joint='1' ctrlrange='0 5'/><motor joint='1' ctrlrange='-2 0'/>"
           "</actuator>");
  EXPECT_EQ(robot.dofs[0].effort_up, 5);
  EXPECT_EQ(robot.dofs[0].effort_down, 2);
  EXPECT_EQ(robot.dofs[0].max_effort, 2);
}

TEST_F(Mjcf, NamesJointsWithoutLimitsOnce) {
  const auto body = [](const std::string& name, const std::string& type) {
    return "<body><joint name='" + name + "' type='" + type + "'/><geom size='0.1'/></body>";
  };
  EXPECT_THAT(palm(body("a", "hinge") + body("b", "hinge") + body("c", "slide")).warnings,
              AllOf(Contains("joints 'a', 'b' have no limits; they get -3.14159 to 3.14159 rad"),
                    Contains("joint 'c' has no limits; it gets -1 to 1 m")));
}

TEST_F(Mjcf, NamesTheActuatorsThatShareAJoint) {
  const RobotSpec robot =
      palm(kFinger,
           "<actuator><motor name='A' joint='1' ctrlrange='-2 2'/><position name='B' "
           "joint='1' forcerange='-3 3'/><motor name='C' joint='2' ctrlrange='0 1'/>"
           "</actuator>");
  EXPECT_EQ(robot.dofs[0].max_effort, 5);
  EXPECT_THAT(robot.warnings,
              Contains("'1' is driven by the actuators 'A', 'B': they are taken as one motor with "
                       "the sum of their efforts"));
  EXPECT_THAT(robot.warnings, Not(Contains(HasSubstr("'2' is driven by"))));
}

// A box of 2 x 2 x 2 m without its lid weighs as with it.
TEST_F(Mjcf, WeighsALeakyMeshAsMended) {
  const std::string corners = "-1 -1 -1 1 -1 -1 -1 1 -1 1 1 -1 -1 -1 1 1 -1 1 -1 1 1 1 1 1";
  const std::string faces = "0 2 1 1 2 3 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5";
  const RobotSpec robot =
      read("<mujoco><asset><mesh name='m' vertex='" + corners + "' face='" + faces +
           "'/></asset><worldbody><body><geom type='mesh' mesh='m' density='2'/></body>"
           "</worldbody></mujoco>");
  EXPECT_DOUBLE_EQ(robot.links[0].mass, 16);
}

TEST_F(Mjcf, TellsOfLimitsOfActuatorForcesThatItDoesNotRead) {
  const auto warnings = [&](const std::string& attributes) {
    return palm("<body name='b'><joint name='j' " + attributes + "/><geom size='0.1'/></body>")
        .warnings;
  };
  EXPECT_THAT(warnings("actuatorfrcrange='-0.9 0.9'"),
              Contains(HasSubstr("actuatorfrcrange of joints is not read")));
  EXPECT_THAT(warnings("actuatorfrcrange='-0.9 0.9' actuatorfrclimited='false'"),
              Not(Contains(HasSubstr("actuatorfrcrange"))));
}

// Of vertices alone the hull is meant: the corner of a cube of edge 1, with a point inside that
// does not count, weighs a sixth. Four points of a plane have none.
TEST_F(Mjcf, TakesTheHullOfVerticesWithoutFaces) {
  const auto cloud = [&](const std::string& vertices) {
    return palm("<geom type='mesh' mesh='m' density='6'/>",
                "<asset><mesh name='m' vertex='" + vertices + "'/></asset>");
  };
  const RobotSpec robot = cloud("0 0 0  1 0 0  0 1 0  0 0 1  0.1 0.1 0.1");
  EXPECT_NEAR(robot.links[0].mass, 1, kMjcfRounding);
  EXPECT_TRUE(matrix_near(robot.links[0].com, Eigen::Vector3d::Constant(0.25), kMjcfRounding));
  EXPECT_THAT(cloud("0 0 0  1 0 0  0 1 0  1 1 0").warnings,
              Contains(HasSubstr("LEFT OUT mesh 'm' of link 'palm': the mesh is flat")));
  EXPECT_THAT(cloud("").warnings, Contains(HasSubstr("MISSING MESH 'm', which has neither file")));
}

TEST_F(Mjcf, CarriesFramesOut) {
  const RobotSpec robot = palm(
      "<frame pos='0 0 1' euler='0 0 90'><geom size='0.1' pos='1 0 0'/>"
      "<body name='b' pos='2 0 0'/></frame>");
  EXPECT_TRUE(
      matrix_near(robot.links[0].shapes[0].X_BS.p, Eigen::Vector3d(0, 1, 1), kMjcfRounding));
  EXPECT_TRUE(matrix_near(link_poses(robot, {})[1].p, Eigen::Vector3d(0, 2, 1), kMjcfRounding));
}

// Steps of 120 degrees about z, then 1 up: copy 2 is at Rz(240) (1, 0, 0) + (0, 0, 2).
TEST_F(Mjcf, MakesReplicatesStepByStep) {
  const RobotSpec robot = palm(
      "<replicate count='3' sep='-' offset='0 0 1' euler='0 0 120'><body name='f' pos='1 0 0'>"
      "<joint name='j' axis='0 1 0' range='0 90'/></body></replicate>",
      "<tendon><fixed name='t'><joint joint='j' coef='1'/></fixed></tendon>"
      "<actuator><motor name='m' tendon='t' ctrlrange='0 2'/></actuator>");
  EXPECT_THAT(names(robot.links), ElementsAre("palm", "f-0", "f-1", "f-2"));
  EXPECT_THAT(names(robot.dofs), ElementsAre("j-0", "j-1", "j-2"));
  for (const RobotDof& dof : robot.dofs) EXPECT_EQ(dof.max_effort, 2);
  const double cosine = std::cos(kPi / 6);
  EXPECT_TRUE(matrix_near(link_poses(robot, {})[2].p, Eigen::Vector3d(-0.5, cosine, 1), 1e-14));
  EXPECT_TRUE(matrix_near(link_poses(robot, {})[3].p, Eigen::Vector3d(-0.5, -cosine, 2), 1e-14));
}

// The example of the format's reference: the inner suffix stands first, and both steps add up.
TEST_F(Mjcf, MakesReplicatesOfReplicates) {
  const RobotSpec robot = palm(
      "<replicate count='2' offset='0 1 0' euler='90 0 0'><replicate count='2' sep='-' "
      "offset='1 0 0' euler='0 90 0'><body name='Alice'/></replicate></replicate>");
  EXPECT_THAT(names(robot.links),
              ElementsAre("palm", "Alice-00", "Alice-10", "Alice-01", "Alice-11"));
  const Pose<double> last = link_poses(robot, {})[4];
  EXPECT_TRUE(matrix_near(last.p, Eigen::Vector3d(1, 1, 0), 1e-14));
  EXPECT_TRUE(
      matrix_near(last.R, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5).toRotationMatrix(), 1e-14));
}

TEST_F(Mjcf, RefusesReplicatesWithoutEnd) {
  for (const std::string count : {"0", "1.5", "2000"})
    EXPECT_THAT(refusal("<mujoco><worldbody>\n<replicate count='" + count +
                        "'><body/></replicate></worldbody></mujoco>"),
                AllOf(HasSubstr(":2: "), HasSubstr("in 1..1000")));
  std::string nested = "<body/>";
  for (int i = 0; i < 5; ++i) nested = "<replicate count='100'>" + nested + "</replicate>";
  EXPECT_THAT(refusal("<mujoco><worldbody>" + nested + "</worldbody></mujoco>"),
              HasSubstr("more than 100000"));
}

// What names the joints of bodies that are not read is left out with them.
TEST_F(Mjcf, SaysThatAttachedBodiesAreMissing) {
  const RobotSpec robot = palm("<attach model='m' body='b' prefix='p_'/>" + kFinger,
                               "<actuator><motor joint='p_j'/><motor joint='1' ctrlrange='0 2'/>"
                               "</actuator>");
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("INCOMPLETE: <attach> is not read")));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("joint 'p_j', and there is no such hinge")));
  EXPECT_EQ(robot.dofs[0].max_effort, 2);
}

TEST_F(Mjcf, IncludesFilesWithinFiles) {
  write_file(path("hand.xml"),
             "<mujocoinclude><body name='hand'><include file='tip.xml'/></body></mujocoinclude>");
  write_file(path("tip.xml"), "<mujocoinclude><body name='tip' pos='0 0 0.5'/></mujocoinclude>");
  const RobotSpec robot =
      read("<mujoco><worldbody><include file='hand.xml'/></worldbody></mujoco>");
  EXPECT_THAT(names(robot.links), ElementsAre("hand", "tip"));
  EXPECT_THAT(refusal("<mujoco>\n<include file='model.xml'/></mujoco>"),
              AllOf(HasSubstr(":2: "), HasSubstr("included twice")));
}

// By a path upwards, by a whole path, by a link: of none does a message say a word.
TEST_F(Mjcf, IncludesNothingFromOutsideOfItsFolder) {
  const std::string secret = "<mujocoinclude><body name='secret'/></mujocoinclude>";
  write_file(path("secret.xml"), secret);
  write_file(path("in/sub/part.xml"), "<mujocoinclude><body name='part'/></mujocoinclude>");
  std::filesystem::create_symlink("../secret.xml", path("in/link.xml"));
  std::filesystem::create_symlink("..", path("in/up"));
  const auto refusal_of = [&](const std::string& name) {
    write_file(path("in/model.xml"),
               "<mujoco><worldbody>\n<include file='" + name + "'/></worldbody></mujoco>");
    return message_of<DataError>([&] { (void)read_mjcf(path("in/model.xml")); });
  };
  for (const std::string& name :
       {std::string("../secret.xml"), path("secret.xml"), std::string("link.xml"),
        std::string("up/secret.xml"), std::string("../nothing.xml"), std::string("/etc/passwd")}) {
    const std::string said = refusal_of(name);
    EXPECT_THAT(said, HasSubstr("in/model.xml:2: '" + name + "' is outside of the model's folder"));
  }
  EXPECT_EQ(refusal_of("sub/part.xml"), "nothing was thrown");
}

TEST_F(Mjcf, NamesWhatItDoesNotRead) {
  const RobotSpec robot =
      palm("<site name='s'/><geom name='floor' type='plane' size='1 1 1'/><freejoint/>" + kFinger,
           "<equality><connect body1='a' body2='c' anchor='0 0 0'/></equality>"
           "<tendon><spatial name='band'/></tendon><sensor/><contact/>");
  for (const std::string part :
       {"<site>", "plane", "free joint of body 'palm'", "<connect> of 'a' and 'c' is not kept",
        "<spatial> tendon 'band'", "<sensor>", "<contact>"})
    EXPECT_THAT(robot.warnings, Contains(HasSubstr(part)));
}

// Said once, also of what a default class says.
TEST_F(Mjcf, SaysThatContactSettingsOfGeomsAreNotRead) {
  const RobotSpec robot = palm("<geom size='0.1' friction='1.5 0.01 0.001' condim='4'/>" + kFinger,
                               "<default><geom solref='0.01 1'/></default>");
  for (const std::string part :
       {"friction of a <geom> is not read: that of its link's material",
        "condim of a <geom> is not read", "solref of a <geom> is not read"})
    EXPECT_THAT(robot.warnings, Contains(HasSubstr(part)));
  EXPECT_THAT(robot.warnings, Not(Contains(HasSubstr("margin"))));
}

TEST_F(Mjcf, FindsMeshesInTheirFolder) {
  std::filesystem::create_directories(folder_ / "assets");
  write_file(path("assets/t.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string model =
      "<mujoco><compiler meshdir='assets'/><asset><mesh file='t.off' scale='0.5 0.5 0.5'/>"
      "<mesh name='lost' file='lost.stl'/></asset><worldbody><body name='palm'>"
      "<geom type='mesh' mesh='t'/><geom type='mesh' mesh='lost'/></body></worldbody></mujoco>";
  const RobotSpec robot = read(model);
  ASSERT_EQ(robot.links[0].shapes.size(), 1U);
  EXPECT_EQ(robot.links[0].shapes[0].mesh_scale, 0.5);
  EXPECT_THAT(robot.warnings,
              Contains(AllOf(HasSubstr("MISSING MESH"), HasSubstr("lost.stl"), HasSubstr("palm"))));
}

TEST_F(Mjcf, RefusesWithTheLine) {
  EXPECT_THAT(refusal("<mujoco><worldbody>\n<body name='b'>\n<geom type='blob' size='1'/></body>"
                      "</worldbody></mujoco>"),
              AllOf(HasSubstr("model.xml:3: "), HasSubstr("'blob'")));
  EXPECT_THAT(refusal("<mujoco><worldbody>\n<body pos='0 x 0'/></worldbody></mujoco>"),
              AllOf(HasSubstr(":2: "), HasSubstr("'x'")));
  EXPECT_THAT(refusal("<mujoco><worldbody>\n<body><joint class='c'/></body></worldbody></mujoco>"),
              AllOf(HasSubstr(":2: "), HasSubstr("class 'c'")));
  EXPECT_THAT(
      refusal("<mujoco><worldbody><body name='a'/></worldbody>\n<equality><joint joint1='x' "
              "joint2='y'/></equality></mujoco>"),
      AllOf(HasSubstr(":2: "), HasSubstr("'x'")));
  EXPECT_THAT(refusal("<mujoco>\n<compiler coordinate='global'/><worldbody/></mujoco>"),
              HasSubstr("global"));
}

}  // namespace
}  // namespace thenar
