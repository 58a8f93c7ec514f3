// Tests for data/io/robot/close_loops.cpp and mjcf_loops.cpp: linkages against their closed forms.

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/file_io.h"
#include "base/lists.h"
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
using testing::SizeIs;

constexpr double kParallel = 0.1 * kDegree;
constexpr double kGape = 5e-5;  // [m]

/// Four bars in the plane of y and z: hinges A and B on the palm, P and Q on what they carry [m].
struct FourBar {
  Eigen::Vector2d A{0.03, 0.055}, B{0.012, 0.06}, P{0.06, 0.1}, Q{0.042, 0.105};  // a parallelogram
  Eigen::Vector2d C{0.02, 0.01};  // of an adaptive one: from A to the coupler's hinge [m]

  /// Turn of B's crank and of the carried link PQ where A's crank has turned by u, from the
  /// crossing of two circles: P on A's circle, Q at |BQ| from B and |PQ| from P.
  [[nodiscard]] Eigen::Vector2d turns(double u) const {
    const Eigen::Vector2d p = A + Eigen::Rotation2Dd(u) * (P - A);
    const Eigen::Vector2d way = p - B;
    const double d = way.norm(), b = (Q - B).norm(), c = (Q - P).norm();
    const double along = (d * d + b * b - c * c) / (2 * d), off = std::sqrt(b * b - along * along);
    const Eigen::Vector2d across(-way.y(), way.x());
    const auto crossing = [&](double side) -> Eigen::Vector2d {
      return B + (along * way + side * off * across) / d;
    };
    const auto angle = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    };
    // Of both crossings the one on the side of Q now.
    const Eigen::Vector2d now = P - B, q0 = Q - B;
    const double side = now.x() * q0.y() - now.y() * q0.x() > 0 ? 1 : -1;
    const Eigen::Vector2d q = crossing(side);
    return {angle(Q - B, q - B), angle(Q - P, q - p)};
  }
};

/// As the grippers whose finger hinges on the driven crank: driver, finger, inner knuckle.
std::string on_the_driver(const std::string& name, const FourBar& bar, int side) {
  const auto y = [&](double value) { return side * value; };
  return fmt::format(
      "<body name='{0} outer' pos='0 {1} {2}'><joint name='{0} driver' axis='{11} 0 0' range='0 "
      "0.7'/>"
      "<geom type='sphere' size='0.004'/>"
      "<body name='{0} finger' pos='0 {3} {4}'><joint name='{0} finger' axis='{11} 0 0' range='-2 "
      "2'/>"
      "<geom type='box' size='0.01 0.004 0.02' pos='0 {5} 0.02'/></body></body>"
      "<body name='{0} inner' pos='0 {6} {7}'><joint name='{0} inner' axis='{11} 0 0' range='-2 "
      "2'/>"
      "<site name='{0} end' pos='0 {8} {9}'/><geom type='sphere' size='0.003'/></body>{10}",
      name, y(bar.A.x()), bar.A.y(), y(bar.P.x() - bar.A.x()), bar.P.y() - bar.A.y(), y(-0.02),
      y(bar.B.x()), bar.B.y(), y(bar.Q.x() - bar.B.x()), bar.Q.y() - bar.B.y(), "", side);
}

std::string connect(const std::string& name, const FourBar& bar, int side) {
  return fmt::format("<connect body1='{0} inner' body2='{0} finger' anchor='0 {1} {2}'/>", name,
                     side * (bar.Q.x() - bar.B.x()), bar.Q.y() - bar.B.y());
}

/// As the adaptive grippers: the pad hangs on the other crank, the driven one carries a link that a
/// spring of that crank holds at its stop.
std::string adaptive(const std::string& name, const FourBar& bar, int side) {
  return fmt::format(
      "<body name='{0} outer' pos='0 {1} {2}'><joint name='{0} driver' axis='{10} 0 0' range='0 "
      "0.7'/>"
      "<geom type='sphere' size='0.004'/>"
      "<body name='{0} coupler' pos='0 {3} {4}'><joint name='{0} coupler' axis='{10} 0 0' "
      "range='{11}'/><geom type='sphere' size='0.003'/></body></body>"
      "<body name='{0} spring' pos='0 {5} {6}'><joint name='{0} spring' axis='{10} 0 0' range='-2 "
      "2' "
      "stiffness='0.05' springref='{12}'/><geom type='sphere' size='0.003'/>"
      "<body name='{0} finger' pos='0 {7} {8}'><joint name='{0} finger' axis='{10} 0 0' range='-2 "
      "2'/>"
      "<geom type='box' size='0.01 0.004 0.02' pos='0 {9} 0.02'/></body></body>",
      name, side * bar.A.x(), bar.A.y(), side * bar.C.x(), bar.C.y(), side * bar.B.x(), bar.B.y(),
      side * (bar.Q.x() - bar.B.x()), bar.Q.y() - bar.B.y(), -side * 0.02, side, "-1.57 0", 2.6);
}

/// Where the coupler of the adaptive one holds the finger: at P.
std::string connect_adaptive(const std::string& name, const FourBar& bar, int side) {
  return fmt::format("<connect body1='{0} coupler' body2='{0} finger' anchor='0 {1} {2}'/>", name,
                     side * (bar.P - bar.A - bar.C).x(), (bar.P - bar.A - bar.C).y());
}

class Loops : public TemporaryFolder {
 protected:
  RobotSpec gripper(const std::string& fingers, const std::string& closures,
                    const std::string& motors =
                        "<actuator><position joint='left driver' forcerange='-5 5'/></actuator>") {
    write_file(path("gripper.xml"),
               "<mujoco model='gripper'><compiler angle='radian'/><worldbody><body name='palm'>"
               "<geom type='box' size='0.03 0.06 0.02'/>" +
                   fingers + "</body></worldbody><equality>" + closures +
                   "<joint joint1='right driver' joint2='left driver'/></equality>" + motors +
                   "</mujoco>");
    return import_robot(path("gripper.xml"));
  }
  RobotSpec on_driver(const FourBar& bar) {
    return gripper(on_the_driver("left", bar, 1) + on_the_driver("right", bar, -1),
                   connect("left", bar, 1) + connect("right", bar, -1));
  }
  static Pose<double> link(const RobotSpec& robot, const std::string& name, double u) {
    const std::vector<Pose<double>> links = link_poses(robot, {{"left driver", u}});
    for (std::size_t i = 0; i < links.size(); ++i)
      if (robot.links[i].name == name) return links[i];
    ADD_FAILURE() << "no link " << name;
    return {};
  }
  /// Turn of a link about x since u = 0.
  static double turn(const RobotSpec& robot, const std::string& name, double u) {
    const Eigen::Matrix3d R = link(robot, name, u).R * link(robot, name, 0).R.transpose();
    return std::atan2(R(2, 1), R(1, 1));
  }
};

// A parallelogram: what it carries never turns, and goes along the circle of the cranks.
TEST_F(Loops, OfParallelCranksKeepPadsParallel) {
  const FourBar bar;
  const RobotSpec robot = on_driver(bar);
  EXPECT_THAT(robot.open_loops, IsEmpty());
  ASSERT_THAT(names(robot.dofs), ElementsAre("left driver"));
  EXPECT_EQ(robot.dofs[0].max_effort, 5);
  for (double u = 0; u <= 0.7; u += 0.05)
    for (const std::string side : {"left", "right"}) {
      EXPECT_NEAR(turn(robot, side + " finger", u), 0, 1e-7) << side << u;
      const double sign = side == "left" ? 1 : -1;
      const Eigen::Vector2d P = bar.A + Eigen::Rotation2Dd(u) * (bar.P - bar.A);
      EXPECT_NEAR(link(robot, side + " finger", u).p.y(), sign * P.x(), 1e-8);
      EXPECT_NEAR(link(robot, side + " finger", u).p.z(), P.y(), 1e-8);
      EXPECT_NEAR(turn(robot, side + " inner", u), sign * u, 1e-7);
    }
}

// Cranks of 54.1 and 50 mm: turns by the crossing of circles.
TEST_F(Loops, OfUnequalCranksFollowTheCircles) {
  FourBar bar;
  bar.B = {0.010, 0.068};
  const RobotSpec robot = on_driver(bar);
  EXPECT_THAT(robot.open_loops, IsEmpty());
  ASSERT_THAT(names(robot.dofs), ElementsAre("left driver"));
  double largest = 0;
  for (double u = 0; u <= robot.dofs[0].upper; u += 0.02) {
    const Eigen::Vector2d wanted = bar.turns(u);
    EXPECT_NEAR(turn(robot, "left inner", u), wanted[0], 1e-5) << u;
    EXPECT_NEAR(turn(robot, "left finger", u), wanted[1], 1e-5) << u;
    largest = std::max(largest, std::abs(wanted[1]));
  }
  EXPECT_GT(largest, 2 * kDegree);  // else nothing was tested
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("solved as a linkage")));
}

// The spring drives its crank up, so that the coupler stays at 0: driver and coupler are one bar.
TEST_F(Loops, OfAnAdaptiveGripperAreDecidedByItsSpring) {
  const FourBar bar;
  const RobotSpec robot =
      gripper(adaptive("left", bar, 1) + adaptive("right", bar, -1),
              connect_adaptive("left", bar, 1) + connect_adaptive("right", bar, -1));
  EXPECT_THAT(robot.open_loops, IsEmpty());
  ASSERT_THAT(names(robot.dofs), ElementsAre("left driver"));
  for (double u = 0; u <= 0.7; u += 0.05)
    for (const std::string side : {"left", "right"}) {
      EXPECT_LT(std::abs(turn(robot, side + " finger", u)), kParallel) << side << u;
      EXPECT_NEAR(turn(robot, side + " coupler", u), (side == "left" ? 1 : -1) * u, 1e-6);
    }
}

// The spring pulls its crank and the finger far beyond their limits, but the coupler meets its stop
// first, and holds them. Bars of about 57 mm that are not quite
// parallel: turns by the crossing of circles.
TEST_F(Loops, OfAnAdaptiveGripperMeetTheStopThatComesFirst) {
  FourBar bar;
  bar.A = {0.0306, 0.0549}, bar.P = {0.0682, 0.0984};
  bar.B = {0.0132, 0.0609}, bar.Q = {0.0502, 0.1049}, bar.C = {0.0315, -0.0041};
  std::string fingers = adaptive("left", bar, 1) + adaptive("right", bar, -1);
  for (std::size_t at; (at = fingers.find("-2 2' stiffness")) != std::string::npos;)
    fingers.replace(at, 4, "-0.3 0.8");
  for (std::size_t at; (at = fingers.find("'-2 2'")) != std::string::npos;)
    fingers.replace(at, 6, "'-0.87 0.87'");
  const RobotSpec robot =
      gripper(fingers, connect_adaptive("left", bar, 1) + connect_adaptive("right", bar, -1));
  EXPECT_THAT(robot.open_loops, IsEmpty());
  ASSERT_THAT(names(robot.dofs), ElementsAre("left driver"));
  for (double u = 0; u <= 0.7; u += 0.05) {
    const Eigen::Vector2d wanted = bar.turns(u);
    EXPECT_NEAR(turn(robot, "left spring", u), wanted[0], 1e-5) << u;
    EXPECT_NEAR(turn(robot, "left finger", u), wanted[1], 1e-5) << u;
    EXPECT_NEAR(turn(robot, "right finger", u), -wanted[1], 1e-5) << u;
  }
}

TEST_F(Loops, ThatNothingDecidesAreOpen) {
  const FourBar bar;
  std::string loose = adaptive("left", bar, 1) + adaptive("right", bar, -1);
  for (std::size_t at; (at = loose.find("stiffness='0.05'")) != std::string::npos;)
    loose.replace(at, 16, "");
  const RobotSpec robot =
      gripper(loose, connect_adaptive("left", bar, 1) + connect_adaptive("right", bar, -1));
  EXPECT_THAT(robot.open_loops, SizeIs(2));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("INCOMPLETE: <connect> of 'left coupler'")));
}

TEST_F(Loops, OfSeveralMotorsAreOpen) {
  const FourBar bar;
  const RobotSpec robot =
      gripper(on_the_driver("left", bar, 1) + on_the_driver("right", bar, -1),
              connect("left", bar, 1) + connect("right", bar, -1),
              "<actuator><motor joint='left driver'/><motor joint='left inner'/></actuator>");
  EXPECT_THAT(robot.open_loops, Contains(HasSubstr("several motors")));
}

// Two sites that the file's own posture holds apart.
TEST_F(Loops, MayBeStatedBySites) {
  const FourBar bar;
  std::string fingers = on_the_driver("left", bar, 1) + on_the_driver("right", bar, -1);
  const std::string body = "<body name='left finger'";
  fingers.replace(fingers.find(body), body.size(), "<site name='unused'/><body name='left finger'");
  const std::string box = "<geom type='box'";
  const std::string site = fmt::format("<site name='left held' pos='0 {} {}'/>",
                                       bar.Q.x() - bar.P.x(), bar.Q.y() - bar.P.y());
  fingers.insert(fingers.find(box), site);
  const RobotSpec robot =
      gripper(fingers, "<connect site1='left end' site2='left held'/>" + connect("right", bar, -1));
  EXPECT_THAT(robot.open_loops, IsEmpty());
  EXPECT_NEAR(turn(robot, "left finger", 0.5), 0, 1e-6);
}

TEST_F(Loops, SurviveAsTomlAndAreNamedInUrdf) {
  FourBar bar;
  bar.B = {0.010, 0.068};
  const RobotSpec robot = on_driver(bar);
  const std::string text = robot_toml(robot);
  EXPECT_THAT(text, HasSubstr("\ncurve = ["));
  const RobotSpec kept = parse_robot(text, "gripper.toml");
  EXPECT_EQ(robot_toml(kept), text);
  for (const double u : {0.1, 0.4})
    EXPECT_EQ(turn(kept, "left inner", u), turn(robot, "left inner", u));
  EXPECT_THAT(robot_urdf(robot, "").warnings,
              Contains(HasSubstr("URDF has no curved couplings: that of joint 'left finger'")));
  RobotSpec open = robot;
  open.open_loops = {"a loop"};
  EXPECT_THAT(parse_robot(robot_toml(open), "").open_loops, ElementsAre("a loop"));
}

// polycoef beyond its linear part, about reference angles: q1 - 0.1 = 0.2 + 0.5 v - 0.3 v^2, where
// v = q2 - 0.05.
TEST_F(Loops, PolynomialEqualitiesOfJointsAreKept) {
  write_file(
      path("finger.xml"),
      "<mujoco><compiler angle='radian'/><worldbody><body name='palm'>"
      "<body name='a'><joint name='2' axis='0 1 0' range='0 1' ref='0.05'/>"
      "<body name='b'><joint name='1' axis='0 1 0' range='0 2' ref='0.1'/></body></body>"
      "</body></worldbody><equality><joint joint1='1' joint2='2' polycoef='0.2 0.5 -0.3 0 0'/>"
      "</equality></mujoco>");
  RobotSpec robot = import_robot(path("finger.xml"));
  ASSERT_THAT(names(robot.dofs), ElementsAre("2"));
  for (const double q2 : {0.0, 0.3, 0.9}) {
    const double v = q2 - 0.05;
    EXPECT_NEAR(joint_value(*find_named(robot.joints, "1"), q2), 0.1 + 0.2 + 0.5 * v - 0.3 * v * v,
                1e-14);
  }
}

}  // namespace
}  // namespace thenar
