// Hands of files that say nothing of digits, closing and approach hold a ball with what opposes.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/urdf.h"
#include "grasp/closing/grasp.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/jaws.h"
#include "tests/grasp/made_up_hands.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

constexpr double kBallRadius = 0.035;  // radius [m]

/// Links that touch the ball, each with a normal into it; several contacts are several entries.
using Touches = std::vector<std::pair<std::string, Eigen::Vector3d>>;

/// A ball of 70 mm, grasped along the hand's own approach from 300 mm away.
Touches touches(const RobotSpec& robot) {
  const RobotHand hand(robot);
  const PalmApproach& approach = hand.layout().approach;
  const Eigen::Vector3d at = approach.point + 0.3 * approach.direction;
  GraspOptions options;
  options.approach_distance = 0.6;
  const Grasp done = grasp(
      collision_hand(hand), {}, open_posture(hand.layout()),
      sample::setup(
          {sample::placed("ball", sample::shape(ShapeKind::kSphere, {kBallRadius, 0, 0}), at)}),
      options);
  Touches found;
  for (const HandContact& contact : done.contacts)
    found.emplace_back(hand.surfaces()[static_cast<std::size_t>(contact.surface)].name,
                       contact.contact.n);
  return found;
}

/// The best opposition of links of one set and of another: the least cosine between their normals.
double opposition(const Touches& touches, const std::set<std::string>& one,
                  const std::set<std::string>& others) {
  double least = 1;
  for (const auto& [a, n] : touches)
    for (const auto& [b, m] : touches)
      if (one.count(a) > 0 && others.count(b) > 0) least = std::min(least, n.dot(m));
  return least;
}

class ForeignHands : public TemporaryFolder {
 protected:
  /// The robot of the library as another program would write it: without digits, closing, approach.
  [[nodiscard]] RobotSpec as_urdf(const std::string& name) const {
    const RobotSpec own = import_robot(std::string(THENAR_DATA_DIR) + "/robots/" + name + ".toml");
    (void)write_urdf(path(name + ".urdf"), own);
    return import_robot(path(name + ".urdf"));
  }

  /// Links by digits as the library names them.
  static std::map<std::string, std::set<std::string>> digits(const std::string& name) {
    std::map<std::string, std::set<std::string>> digits;
    const RobotSpec own = import_robot(std::string(THENAR_DATA_DIR) + "/robots/" + name + ".toml");
    for (const RobotLink& link : own.links)
      if (!link.digit.empty()) digits[link.digit].insert(link.name);
    return digits;
  }
};

class LibraryHands : public ForeignHands, public testing::WithParamInterface<const char*> {};

TEST_P(LibraryHands, HoldABallWithThumbAndFingersWhenTheyComeAsUrdf) {
  const std::string name = GetParam();
  std::map<std::string, std::set<std::string>> own = digits(name);
  const RobotSpec robot = graspable(as_urdf(name));
  const Touches found = touches(robot);
  if (own.count("thumb") > 0) {
    std::set<std::string> fingers;
    for (const auto& [digit, links] : own)
      if (digit != "thumb") fingers.insert(links.begin(), links.end());
    EXPECT_LT(opposition(found, own["thumb"], fingers), 0) << name;
    return;
  }
  for (const auto& [digit, links] : own) {
    const auto of_digit = [&links = links](const auto& touch) {
      return links.count(touch.first) > 0;
    };
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), of_digit)) << name << " " << digit;
  }
}

// What is guessed is written, read back, and built.
TEST_P(LibraryHands, AreWrittenAndReadBack) {
  const RobotSpec stated = as_urdf(GetParam());
  RobotSpec robot = graspable(stated);
  write_file(path("robot.toml"), robot_toml(robot, &stated));
  const RobotSpec kept = graspable(import_robot(path("robot.toml")));
  EXPECT_EQ(robot_toml(kept), robot_toml(robot));
  const RobotHand hand(kept);
  EXPECT_EQ(open_posture(hand.layout()), open_posture(RobotHand(robot).layout()));
}

TEST_P(LibraryHands, HoldABallWithThumbAndFingersAsTheyAre) {
  const std::string name = GetParam();
  std::map<std::string, std::set<std::string>> own = digits(name);
  const Touches found =
      touches(graspable(import_robot(std::string(THENAR_DATA_DIR) + "/robots/" + name + ".toml")));
  if (own.count("thumb") == 0) return;
  std::set<std::string> fingers;
  for (const auto& [digit, links] : own)
    if (digit != "thumb") fingers.insert(links.begin(), links.end());
  EXPECT_LT(opposition(found, own["thumb"], fingers), 0) << name;
}

/// Three fingers round a palm, straight up, that may curl either way alike, as some for valves
/// have.
/// @param lengths  of their links [m]
/// @param range    of their outer two joints, either way [rad]
RobotSpec three_fingers(const std::array<double, 3>& lengths = {0.045, 0.045, 0.045},
                        double range = 1.4) {
  RobotSpec robot;
  robot.name = "three";
  robot.closing_stated = robot.approach_stated = false;
  robot.links.resize(1);
  robot.links[0].name = "palm";
  robot.links[0].shapes = {sample::shape(ShapeKind::kCylinder, {0.055, 0.02, 0}, {0, 0, -0.01})};
  for (int f = 0; f < 3; ++f) {
    std::string parent = "palm";
    for (std::size_t j = 0; j < 3; ++j) {
      RobotLink link;
      link.name = fmt::format("f{}{}", f, j);
      link.shapes = {sample::shape(ShapeKind::kBox, {0.012, 0.016, lengths[j] - 0.005},
                                   {0, 0, lengths[j] / 2 - 0.0025})};
      RobotJoint joint;
      joint.name = joint.dof = fmt::format("j{}{}", f, j);
      joint.parent = parent;
      joint.child = link.name;
      joint.X_PJ.p = {0, 0, j == 0 ? 0 : lengths[j - 1]};
      if (j == 0)
        joint.X_PJ = {
            rotation_about<double>(Eigen::Vector3d::UnitZ(), 2 * kPi / 3 * f),
            0.05 * Eigen::Vector3d(std::cos(2 * kPi / 3 * f), std::sin(2 * kPi / 3 * f), 0)};
      joint.axis = j == 0 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
      joint.lower = j == 0 ? -0.5 : -range;
      joint.upper = -joint.lower;
      RobotDof dof;
      dof.name = joint.dof;
      dof.lower = joint.lower;
      dof.upper = joint.upper;
      dof.speed = 1;
      parent = link.name;
      robot.links.push_back(link);
      robot.joints.push_back(joint);
      robot.dofs.push_back(dof);
    }
  }
  return robot;
}

/// Two jaws that slide along y, `aperture` apart where open [m]; value 0 is open or closed, and
/// they close upwards or downwards.
RobotSpec jaws(double aperture, bool begins_open, bool upwards) {
  RobotSpec robot;
  robot.name = "jaws";
  robot.closing_stated = robot.approach_stated = false;
  robot.links.resize(1);
  robot.links[0].name = "palm";
  robot.links[0].shapes = {
      sample::shape(ShapeKind::kBox, {0.06, aperture + 0.04, 0.04}, {0, 0, 0.02})};
  for (const double side : {1.0, -1.0}) {
    RobotLink link;
    link.name = side > 0 ? "left" : "right";
    link.shapes = {sample::shape(ShapeKind::kBox, {0.02, 0.01, 0.06}, {0, side * 0.005, 0.07})};
    RobotJoint joint;
    joint.name = joint.dof = link.name;
    joint.kind = RobotJointKind::kPrismatic;
    joint.parent = "palm";
    joint.child = link.name;
    joint.X_PJ.p = {0, begins_open ? side * aperture / 2 : 0, 0};
    joint.axis = {0, upwards ? -side : side, 0};
    const bool positive = begins_open == upwards;  // values from 0 upwards
    joint.lower = positive ? 0 : -aperture / 2;
    joint.upper = positive ? aperture / 2 : 0;
    RobotDof dof;
    dof.name = joint.dof;
    dof.lower = joint.lower;
    dof.upper = joint.upper;
    dof.speed = 1;
    robot.links.push_back(link);
    robot.joints.push_back(joint);
    robot.dofs.push_back(dof);
  }
  return robot;
}

// Whatever their stroke, where they begin, and which sense of their motors closes them.
TEST(GuessClosing, ClosesJawsOfAnyStroke) {
  for (const double aperture : {0.008, 0.02, 0.05, 0.07, 0.14})
    for (const bool begins_open : {true, false})
      for (const bool upwards : {true, false})
        for (const RobotDof& dof : graspable(jaws(aperture, begins_open, upwards)).dofs)
          EXPECT_EQ(dof.speed, upwards ? 1 : -1) << aperture << begins_open << dof.name;
}

/// The same on hinges: jaws of 90 mm that turn by 0.8 rad.
RobotSpec turning_jaws(bool begins_open, bool upwards) {
  RobotSpec robot = jaws(0.01, begins_open, upwards);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    RobotJoint& joint = robot.joints[i];
    const double side = i == 0 ? 1 : -1;
    joint.kind = RobotJointKind::kRevolute;
    // Turned about +x by -0.8 rad the left one, of y > 0, stands open.
    joint.X_PJ = {rotation_about<double>(Eigen::Vector3d::UnitX(), begins_open ? -0.8 * side : 0),
                  {0, side * 0.004, 0.04}};
    joint.axis = {upwards ? side : -side, 0, 0};
    const bool positive = begins_open == upwards;
    joint.lower = positive ? 0 : -0.8;
    joint.upper = positive ? 0.8 : 0;
    robot.dofs[i].lower = joint.lower;
    robot.dofs[i].upper = joint.upper;
    robot.links[i + 1].shapes = {
        sample::shape(ShapeKind::kBox, {0.02, 0.006, 0.09}, {0, side * 0.003, 0.045})};
  }
  return robot;
}

// Where value 0 is closed their ranges say the wrong, and their tips the right.
TEST(GuessClosing, ClosesJawsThatTurnWhereverTheyBegin) {
  for (const bool begins_open : {true, false})
    for (const bool upwards : {true, false})
      for (const RobotDof& dof : graspable(turning_jaws(begins_open, upwards)).dofs)
        EXPECT_EQ(dof.speed, upwards ? 1 : -1) << begins_open << dof.name;
}

/// Jaws of which one is part of the palm.
RobotSpec one_jaw(RobotSpec jaws) {
  ShapeSpec fixed = jaws.links[2].shapes[0];
  fixed.X_BS.p += jaws.joints[1].X_PJ.p;
  if (jaws.joints[1].kind == RobotJointKind::kPrismatic)
    fixed.X_BS.p.y() = -std::abs(fixed.X_BS.p.y());
  jaws.links[0].shapes.push_back(fixed);
  jaws.links.pop_back();
  jaws.joints.pop_back();
  jaws.dofs.pop_back();
  return jaws;
}

// The jaw that moves comes nearer to the one that does not, wherever it begins.
TEST(GuessClosing, ClosesAJawOnAFixedOne) {
  for (const bool begins_open : {true, false})
    for (const bool upwards : {true, false}) {
      EXPECT_EQ(graspable(one_jaw(jaws(0.05, begins_open, upwards))).dofs[0].speed,
                upwards ? 1 : -1);
      // On hinges the fixed jaw stands as where both are closed.
      RobotSpec turning = turning_jaws(begins_open, upwards);
      turning.joints[1].X_PJ.R.setIdentity();
      EXPECT_EQ(graspable(one_jaw(turning)).dofs[0].speed, upwards ? 1 : -1);
    }
}

// Things come down in the middle of the aperture: the fixed jaw's face is where the other began.
TEST(GuessClosing, GoesBetweenAJawAndAFixedOne) {
  for (const double aperture : {0.05, 0.09, 0.14})
    for (const bool begins_open : {true, false}) {
      const RobotSpec robot = graspable(one_jaw(jaws(aperture, begins_open, true)));
      EXPECT_NEAR(robot.approach.direction.z(), 1, 1e-9) << aperture;
      EXPECT_NEAR(robot.approach.point.y(), begins_open ? 0 : aperture / 4, 1e-3) << aperture;
    }
}

/// The same jaws with value 0 in the middle of their ranges.
RobotSpec from_the_middle(RobotSpec robot) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    RobotJoint& joint = robot.joints[i];
    const double middle = (joint.lower + joint.upper) / 2;
    joint.X_PJ = joint.X_PJ * joint_motion(joint, middle);
    joint.lower = robot.dofs[i].lower -= middle;
    joint.upper = robot.dofs[i].upper -= middle;
  }
  return robot;
}

// Jaws open as far as they go, wherever 0 is: at 0 they may be closed, or half closed.
TEST(GuessClosing, OpensJawsToTheLimitThatTheyLeave) {
  for (const bool begins_open : {true, false})
    for (const bool upwards : {true, false})
      for (const RobotSpec& jaws :
           {jaws(0.05, begins_open, upwards), turning_jaws(begins_open, upwards)})
        for (const RobotSpec& robot : {jaws, from_the_middle(jaws)}) {
          const HandLayout layout = RobotHand(graspable(robot)).layout();
          EXPECT_EQ(open_posture(layout), upwards ? layout.lower : layout.upper)
              << begins_open << upwards;
        }
}

// Closed at 0 they are 80 mm apart: nothing smaller tells which way closes them.
TEST(GuessClosing, ClosesJawsThatStayApart) {
  for (const bool upwards : {true, false}) {
    RobotSpec robot = turning_jaws(false, upwards);
    robot.joints[0].X_PJ.p.y() = 0.04;
    robot.joints[1].X_PJ.p.y() = -0.04;
    for (const RobotDof& dof : graspable(robot).dofs)
      EXPECT_EQ(dof.speed, upwards ? 1 : -1) << dof.name;
  }
}

/// The robot turned in its base link: what the base holds, and the joints that it carries.
RobotSpec turned(RobotSpec robot, const Eigen::Matrix3d& R) {
  for (ShapeSpec& shape : robot.links[0].shapes) shape.X_BS = {R * shape.X_BS.R, R * shape.X_BS.p};
  for (RobotJoint& joint : robot.joints)
    if (joint.parent == robot.links[0].name) joint.X_PJ = {R * joint.X_PJ.R, R * joint.X_PJ.p};
  return robot;
}

/// Grippers that approach along z of their base link: jaws that slide and that turn, and fingers
/// round a palm.
std::vector<RobotSpec> straight_grippers() {
  return {jaws(0.05, true, true), turning_jaws(true, true), turning_jaws(false, false),
          three_fingers()};
}

// Turned by 3 to 14 deg, less than what would be taken for another way up.
TEST(GuessClosing, ApproachesAlongGrippersThatStandObliquelyOnTheirBase) {
  for (const double tilt : {3.0, 6.0, 10.0, 14.0})
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.6, 0.48, 0.64)})
      for (const RobotSpec& straight : straight_grippers()) {
        const Eigen::Matrix3d R = rotation_about<double>(axis, tilt * kPi / 180);
        const Eigen::Vector3d found = graspable(turned(straight, R)).approach.direction;
        EXPECT_LT((found - R.col(2)).norm(), 1e-9) << tilt << " deg about " << axis.transpose();
      }
}

// A plate that stands straight under an oblique gripper, as where a bracket mounts it.
TEST(GuessClosing, ApproachesAlongAGripperOnAStraightPlate) {
  const Eigen::Matrix3d R = rotation_about<double>(Eigen::Vector3d(0.6, 0.8, 0), 8 * kPi / 180);
  for (const RobotSpec& straight : {jaws(0.05, true, true), turning_jaws(true, true)}) {
    RobotSpec robot = turned(straight, R);
    robot.links[0].shapes.push_back(
        sample::shape(ShapeKind::kBox, {0.07, 0.1, 0.01}, {0, 0, -0.03}));
    EXPECT_LT((graspable(robot).approach.direction - R.col(2)).norm(), 1e-9);
  }
}

// A camera on one side moves the middle of the palm's box, not the way in which jaws point.
TEST(GuessClosing, ApproachesStraightWithAPalmThatIsHeavierOnOneSide) {
  for (RobotSpec robot : {jaws(0.05, true, true), turning_jaws(true, true)}) {
    robot.links[0].shapes.push_back(
        sample::shape(ShapeKind::kBox, {0.02, 0.03, 0.03}, {0.04, 0.01, 0.02}));
    EXPECT_EQ(graspable(robot).approach.direction, Eigen::Vector3d::UnitZ());
  }
}

// Turned about +y the tips go outwards: all curl downwards, none the other way.
TEST(GuessClosing, CurlsFingersOfOneKindOneWay) {
  const RobotSpec robot = graspable(three_fingers());
  for (const RobotDof& dof : robot.dofs)
    EXPECT_EQ(dof.speed, dof.name[2] == '0' ? 0 : -1) << dof.name;
  EXPECT_EQ(robot.approach.direction, Eigen::Vector3d::UnitZ());
}

// Turned alike from straight, the tips would meet above the ball before anything holds it.
TEST(GuessClosing, HoldsABallBetweenThreeFingersThatCurlAtEachOther) {
  const RobotSpec found = graspable(three_fingers({0.028, 0.07, 0.055}, 2));
  std::set<char> digits;
  for (const auto& [link, normal] : touches(found))
    if (link[0] == 'f') digits.insert(link[1]);
  EXPECT_EQ(digits.size(), 3u);
}

// As GraspIt! hands have it: motors say how they close, the file has no approach direction.
TEST(GuessClosing, FindsTheApproachOfAStatedClosing) {
  RobotSpec robot = sample::jaws();
  robot.approach = {};
  robot.approach_stated = false;
  const RobotSpec found = graspable(robot);
  EXPECT_EQ(found.approach.direction, Eigen::Vector3d::UnitY());
  EXPECT_EQ(found.dofs[0].speed, robot.dofs[0].speed);
}

TEST(GuessClosing, RefusesRobotsThatComeApart) {
  RobotSpec robot = sample::jaws();
  robot.open_loops = {"<connect> of 'a' and 'b': no motor drives it"};
  EXPECT_EQ(
      message_of<InputError>([&] { (void)graspable(robot); }),
      "robot 'jaws' cannot grasp: its parts form loops that are not solved, so that it would come "
      "apart: <connect> of 'a' and 'b': no motor drives it");
}

class MadeUpHands : public testing::TestWithParam<int> {};

sample::MadeUpHand made_up(int number) {
  sample::MadeUpHand how;
  how.left = number % 2 == 1;
  how.thumb = number % 3;
  how.one_motor_a_finger = number % 4 >= 2;
  how.negative = number % 5 == 4;
  how.meshes = number % 5 == 3;
  how.arched = number % 7 == 5;
  how.scale = number % 8 == 7 ? 1.3 : 1;
  std::mt19937 rng(static_cast<unsigned>(number));
  if (number % 3 == 1)
    for (int k = 0; k < 3; ++k) how.turn[k] = static_cast<double>(rng()) / 4294967296.0 * 4 - 2;
  return how;
}

/// Their palm's normal is z before the base frame is turned.
TEST_P(MadeUpHands, HoldABallWithThumbAndFingersAlongThePalmsNormal) {
  const sample::MadeUpHand how = made_up(GetParam());
  const RobotSpec robot = graspable(sample::HandMaker(how).hand());
  const Touches found = touches(robot);
  std::set<std::string> thumb, fingers;
  for (const RobotLink& link : robot.links)
    (link.name.rfind("opposer", 0) == 0 ? thumb : fingers).insert(link.name);
  fingers.erase("base");
  EXPECT_LT(opposition(found, thumb, fingers), 0);
  const Eigen::Vector3d normal =
      how.turn.norm() > 0
          ? Eigen::Vector3d(Eigen::AngleAxisd(how.turn.norm(), how.turn.normalized()) *
                            Eigen::Vector3d::UnitZ())
          : Eigen::Vector3d::UnitZ();
  EXPECT_GT(robot.approach.direction.dot(normal), std::cos(0.15));
}

/// The hand with its fingers bent by 50 deg in every joint at value 0, and the middle joint of
/// every finger but the first turning the other way round.
RobotSpec curled_at_zero(RobotSpec robot) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    RobotJoint& joint = robot.joints[i];
    if (joint.child.rfind("opposer", 0) == 0) continue;
    const double bent = 50.0 * kPi / 180;
    joint.X_PJ = joint.X_PJ * joint_motion(joint, bent);
    double lower = joint.lower - bent, upper = joint.upper - bent;
    if (joint.child.back() == '2' && joint.child != "second 2") {
      joint.axis *= -1;
      lower = -(joint.upper - bent);
      upper = -(joint.lower - bent);
    }
    joint.lower = robot.dofs[i].lower = lower;
    joint.upper = robot.dofs[i].upper = upper;
  }
  return robot;
}

// Where a digit is straight tells its way of closing, wherever value 0 is.
TEST(GuessClosing, ClosesHandsThatAreCurledAtZero) {
  for (const int thumb : {0, 1, 2}) {
    sample::MadeUpHand how;
    how.thumb = thumb;
    const RobotSpec robot = graspable(curled_at_zero(sample::HandMaker(how).hand()));
    for (const RobotDof& dof : robot.dofs) {
      if (dof.name.rfind("opposer", 0) == 0) continue;
      const bool reversed = dof.name.find('2') != std::string::npos && dof.name != "second 2 joint";
      EXPECT_EQ(dof.speed, reversed ? -1 : 1) << thumb << dof.name;
    }
    EXPECT_GT(robot.approach.direction.z(), std::cos(0.15)) << thumb;
  }
}

INSTANTIATE_TEST_SUITE_P(All, MadeUpHands, testing::Range(0, 24));

INSTANTIATE_TEST_SUITE_P(All, LibraryHands,
                         testing::Values("allegro", "leap", "shadow", "dlr", "robonaut", "rutgers",
                                         "barrett", "barrett_bh8_280", "robotiq_3f", "franka_hand",
                                         "robotiq_2f85", "parallel_jaw"),
                         [](const auto& hand) { return std::string(hand.param); });

}  // namespace
}  // namespace thenar
