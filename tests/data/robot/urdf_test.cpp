// Tests for data/io/robot/urdf.cpp.

#include <sys/resource.h>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/urdf.h"
#include "geometry/mass_properties.h"
#include "geometry/solid.h"
#include "tests/data/robot/named_parts.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kExportedPoseTolerance =
    1e-12;  // a dozen products of rotations, lengths below 1 m

Pose<double> near_pose(std::mt19937& rng) {
  Pose<double> X = sample::random_pose(rng);
  X.p = {sample::odd_number(rng, 0.2), sample::odd_number(rng, 0.2), sample::odd_number(rng, 0.2)};
  return X;
}

/// A chain and a branch with frames of all kinds; two motors drive three joints each, with ratios
/// and offsets, none of which leads plainly; a ball on every link.
RobotSpec geared_robot(std::mt19937& rng) {
  RobotSpec robot;
  robot.name = "geared";
  for (const std::string motor : {"m0", "m1"}) {
    RobotDof dof;
    dof.name = motor;
    dof.lower = -1;
    dof.upper = 1;
    dof.speed = 1;
    dof.max_effort = 3;
    robot.dofs.push_back(dof);
  }
  for (int i = 0; i <= 6; ++i) {
    RobotLink link = sample::random_link(rng, "link" + std::to_string(i));
    link.com *= 1e-3;
    link.shapes.resize(1);
    link.shapes[0] = {};
    link.shapes[0].size.x() = 0.01;
    link.shapes[0].X_BS = near_pose(rng);
    robot.links.push_back(link);
    if (i == 0) continue;
    RobotJoint joint;
    joint.name = "joint" + std::to_string(i);
    joint.kind = i == 3 ? RobotJointKind::kPrismatic : RobotJointKind::kRevolute;
    joint.parent = "link" + std::to_string(i == 5 ? 1 : i - 1);
    joint.child = link.name;
    joint.X_PJ = near_pose(rng);
    joint.X_JC = near_pose(rng);
    joint.axis = sample::random_pose(rng).R.col(0);
    joint.dof = i % 2 == 0 ? "m0" : "m1";
    joint.ratio = 1.5 - 0.25 * i;
    joint.offset = 0.1 * i;
    joint.lower = -9;
    joint.upper = 9;
    robot.joints.push_back(joint);
  }
  robot.joints[5].ratio = -2;
  return robot;
}

class UrdfExport : public TemporaryFolder {
 protected:
  RobotSpec there_and_back(const RobotSpec& robot) {
    warnings = write_urdf(path("robot.urdf"), robot);
    return read_urdf(path("robot.urdf"));
  }
  std::vector<std::string> warnings;
};

TEST(RollPitchYaw, RebuildsAnyRotation) {
  std::mt19937 rng(1);
  const auto rebuilt = [](const Eigen::Vector3d& a) {
    return Eigen::Matrix3d(rotation_about<double>(Eigen::Vector3d::UnitZ(), a.z()) *
                           rotation_about<double>(Eigen::Vector3d::UnitY(), a.y()) *
                           rotation_about<double>(Eigen::Vector3d::UnitX(), a.x()));
  };
  for (int i = 0; i < 1000; ++i) {
    Eigen::Vector3d angles(sample::odd_number(rng, 6), sample::odd_number(rng, 3),
                           sample::odd_number(rng, 6));
    // Every other one stands where yaw and roll turn about nearly or just the same line.
    if (i % 2 == 0) angles.y() = kPi / 2 - (i % 4 == 0 ? 0 : sample::odd_number(rng, 1e-9));
    const Eigen::Matrix3d R = rebuilt(angles);
    ASSERT_TRUE(matrix_near(rebuilt(roll_pitch_yaw(R)), R, 1e-15)) << angles;
  }
}

// Balls, centres of mass and inertias must stand where they stood; frames of links may differ.
TEST_F(UrdfExport, KeepsWhatLinksHoldInPlaceAtAnyPosture) {
  std::mt19937 rng(2);
  const RobotSpec robot = geared_robot(rng), back = there_and_back(robot);
  ASSERT_EQ(back.links.size(), robot.links.size());
  ASSERT_EQ(back.dofs.size(), 2U);
  for (int trial = 0; trial < 50; ++trial) {
    DofValues before, after;
    for (const RobotDof& dof : robot.dofs) before[dof.name] = sample::odd_number(rng, 2);
    // A motor of the URDF is named after the joint that leads, and has its value.
    for (const RobotJoint& joint : robot.joints)
      if (std::any_of(back.dofs.begin(), back.dofs.end(),
                      [&](const RobotDof& dof) { return dof.name == joint.name; }))
        after[joint.name] = joint_value(joint, before);
    const std::vector<Pose<double>> X = link_poses(robot, before), Y = link_poses(back, after);
    for (std::size_t i = 0; i < X.size(); ++i) {
      const RobotLink &a = robot.links[i], &b = back.links[i];
      ASSERT_EQ(a.name, b.name);
      const Pose<double> ball_a = X[i] * a.shapes[0].X_BS, ball_b = Y[i] * b.shapes[0].X_BS;
      EXPECT_TRUE(matrix_near(ball_b.p, ball_a.p, kExportedPoseTolerance));
      EXPECT_TRUE(matrix_near(ball_b.R, ball_a.R, kExportedPoseTolerance));
      EXPECT_TRUE(matrix_near(Y[i] * b.com, X[i] * a.com, kExportedPoseTolerance));
      EXPECT_TRUE(matrix_near(Y[i].R * b.inertia * Y[i].R.transpose(),
                              X[i].R * a.inertia * X[i].R.transpose(), kExportedPoseTolerance));
    }
  }
}

// A motor of 3 N m through ratio 1.25 (joint 1, which leads m1) turns with 3 / 1.25.
TEST_F(UrdfExport, KeepsTheEffortOfTheLeadingJoint) {
  std::mt19937 rng(2);
  const RobotSpec back = there_and_back(geared_robot(rng));
  EXPECT_DOUBLE_EQ(back.dofs[0].max_effort, 2.4);
  EXPECT_DOUBLE_EQ(back.dofs[0].speed, 1.25);
}

// A motor that could go further than its joint does not let the joint go further.
TEST_F(UrdfExport, LeavesTheLeadingJointItsOwnLimits) {
  std::mt19937 rng(2);
  RobotSpec robot = geared_robot(rng);
  robot.links.resize(2);
  robot.joints.resize(1);
  robot.dofs = {robot.dofs[1]};
  RobotJoint& joint = robot.joints[0];  // 1.25 q + 0.1 for q in -1 .. 1
  joint.lower = -0.5;
  joint.upper = 2;
  const RobotSpec back = there_and_back(robot);
  EXPECT_DOUBLE_EQ(back.joints[0].lower, -0.5);
  EXPECT_DOUBLE_EQ(back.joints[0].upper, 1.35);
}

/// A robot of one link.
RobotSpec one_link(const std::string& link) {
  RobotSpec robot;
  robot.name = "one";
  robot.links.resize(1);
  robot.links[0].name = link;
  return robot;
}

TEST_F(UrdfExport, WritesMeshesThatNoFileHas) {
  RobotSpec robot = one_link("a/b");
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh.vertices = Eigen::Matrix3d::Identity();
  shape.mesh.triangles.resize(3, 1);
  shape.mesh.triangles << 0, 1, 2;
  robot.links[0].shapes.push_back(shape);
  shape.kind = ShapeKind::kEllipsoid;
  shape.size = {0.1, 0.2, 0.3};
  robot.links[0].shapes.push_back(shape);
  const RobotSpec back = there_and_back(robot);
  ASSERT_EQ(back.links[0].shapes.size(), 2U);
  EXPECT_EQ(back.links[0].shapes[0].mesh.vertices, Eigen::Matrix3d::Identity());
  EXPECT_NEAR(back.links[0].shapes[1].mesh.vertices.row(2).maxCoeff(), 0.3, 0.003);  // tessellated
  EXPECT_THAT(warnings, Contains(HasSubstr("no ellipsoid")));
}

/// Writes a robot over another whose mesh no longer fits on the disk. @return 0: it was refused
[[noreturn]] void exit_refused_on_a_full_disk(const RobotSpec& robot, const std::string& path) {
  const rlimit little{2000, 2000};  // [bytes] of any file
  (void)setrlimit(RLIMIT_FSIZE, &little);
  (void)std::signal(SIGXFSZ, SIG_IGN);
  try {
    (void)write_urdf(path, robot);
  } catch (const InputError&) {
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(UrdfExport, WritesAllOrNothingOnAFullDisk) {
  RobotSpec robot = one_link("a");
  ShapeSpec shape;
  shape.kind = ShapeKind::kBox;
  shape.size = {0.1, 0.1, 0.1};
  robot.links[0].shapes.push_back(shape);
  (void)write_urdf(path("one.urdf"), robot);
  const std::string before = read_file(path("one.urdf"), 10'000);
  shape.kind = ShapeKind::kEllipsoid;  // a mesh of many kilobytes
  robot.links[0].shapes = {shape};
  EXPECT_EXIT(exit_refused_on_a_full_disk(robot, path("one.urdf")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(read_file(path("one.urdf"), 10'000), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(UrdfExport, SaysWhatUrdfCannot) {
  std::mt19937 rng(3);
  RobotSpec robot = geared_robot(rng);
  robot.dofs[0].kind = DriveCoupling::kBreakaway;
  robot.joints[1].stiffness = 2;
  const UrdfText urdf = robot_urdf(robot, "");
  EXPECT_THAT(urdf.warnings, Contains(HasSubstr("no breakaway couplings: 'm0'")));
  EXPECT_THAT(urdf.warnings, Contains(HasSubstr("no springs: that of joint 'joint2'")));
  EXPECT_THAT(urdf.text, HasSubstr("<!-- URDF has no breakaway couplings"));
}

TEST_F(UrdfExport, NamesEverythingThatIsLostOfAHand) {
  std::mt19937 rng(3);
  RobotSpec robot = geared_robot(rng);
  for (RobotLink& link : robot.links) link.material = link.digit = "";
  robot.dofs[1].speed = 0;
  robot.links[2].material = "rubber";
  robot.links[3].digit = "thumb";
  robot.approach.direction = {1, 0, 0};
  robot.dofs[0].nominal_effort = true;
  robot.dofs[1].backdrivable = false;
  EXPECT_THAT(
      robot_urdf(robot, "").warnings,
      testing::IsSupersetOf(
          {"URDF has no materials of contact: left out of link2",
           "URDF has no digits: left out of link3", "URDF has no approach: left out of geared",
           "URDF has no direction of closing: left out of m0",
           "URDF has no nominal efforts, so that they count as known: left out of m0",
           "URDF has no worms and brakes: left out of m1"}));
  EXPECT_THAT(robot_urdf(robot, "").warnings,
              Contains(HasSubstr("URDF has no names of motors: 'm0' is that of joint")));
}

TEST_F(UrdfExport, SaysNothingOfWhatUrdfCanSay) {
  RobotSpec robot;
  robot.name = "one";
  robot.links.resize(2);
  robot.links[0].name = "base";
  robot.links[1].name = "jaw";
  RobotJoint joint;
  joint.name = joint.dof = "slide";
  joint.parent = "base";
  joint.child = "jaw";
  robot.joints = {joint};
  robot.dofs.resize(1);
  robot.dofs[0].name = "slide";
  EXPECT_THAT(robot_urdf(robot, "").warnings, testing::IsEmpty());
}

}  // namespace
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kUrdfRounding = 1e-15;  // of numbers that are read, turned once and compared

/// Base, a finger of two joints, the second of which follows the first, and a slide.
const char* const kGripper = R"(<?xml version="1.0"?>
<robot name="gripper">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="tip">
    <collision><origin xyz="0 0 0.01"/><geometry><sphere radius="0.005"/></geometry></collision>
  </link>
  <link name="base">
    <inertial>
      <origin xyz="0.01 0.02 0.03" rpy="0 0 1.5707963267948966"/>
      <mass value="0.5"/>
      <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.003" iyz="0" izz="0.004"/>
    </inertial>
    <visual><geometry><box size="9 9 9"/></geometry><material name="grey"/></visual>
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
  </link>
  <link name="finger"><visual><geometry><cylinder radius="0.01" length="0.05"/></geometry></visual></link>
  <link name="slider"><collision><geometry><capsule radius="0.01" length="0.04"/></geometry></collision></link>
  <joint name="distal" type="revolute">
    <origin xyz="0 0 0.05"/><parent link="finger"/><child link="tip"/><axis xyz="0 2 0"/>
    <limit lower="0" upper="1.7" effort="1" velocity="1"/>
    <mimic joint="knuckle" multiplier="0.5" offset="0.1"/>
  </joint>
  <joint name="knuckle" type="revolute">
    <origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/><parent link="base"/><child link="finger"/>
    <axis xyz="0 1 0"/><dynamics damping="0.2" friction="0.3"/>
    <limit lower="0" upper="1.6" effort="4" velocity="2"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="base"/><child link="slider"/><axis xyz="1 0 0"/>
    <limit lower="-0.02" upper="0" effort="30" velocity="0.1"/>
  </joint>
  <transmission name="t"><type>x</type></transmission>
</robot>)";

class Urdf : public TemporaryFolder {
 protected:
  RobotSpec read(const std::string& text, const std::string& name = "robot.urdf") {
    write_file(path(name), text);
    return read_urdf(path(name));
  }
  std::string refusal(const std::string& text) {
    return message_of<DataError>([&] { (void)read(text); });
  }
};

/// A base, and a tip on a joint of the given type and content.
std::string two_links(const std::string& joint, const std::string& tip = "") {
  return "<robot name='r'>\n<link name='base'/>\n<link name='tip'>" + tip + "</link>\n" + joint +
         "\n</robot>\n";
}
const char* const kEnds = "<parent link='base'/><child link='tip'/>";

TEST_F(Urdf, PutsBaseFirstAndParentsBeforeChildren) {
  const RobotSpec robot = read(kGripper);
  EXPECT_EQ(robot.name, "gripper");
  EXPECT_THAT(names(robot.links), ElementsAre("base", "tip", "finger", "slider"));
  EXPECT_THAT(names(robot.joints), ElementsAre("knuckle", "distal", "slide"));
  EXPECT_NO_THROW(check_robot(robot));
}

TEST_F(Urdf, TurnsInertiaIntoTheLink) {
  const RobotLink base = read(kGripper).links[0];
  EXPECT_EQ(base.mass, 0.5);
  EXPECT_EQ(base.com, Eigen::Vector3d(0.01, 0.02, 0.03));
  // A quarter turn about z swaps x and y.
  EXPECT_TRUE(matrix_near(base.inertia, Eigen::Vector3d(0.003, 0.002, 0.004).asDiagonal(), 1e-17));
}

TEST_F(Urdf, TakesNegativeEffortsForUnknown) {
  const RobotSpec robot =
      read(two_links("<joint name='j' type='revolute'>" + std::string(kEnds) +
                     "<limit lower='0' upper='1' effort='-1' velocity='1'/></joint>"));
  EXPECT_EQ(robot.dofs[0].max_effort, 0);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("effort of joint 'j' is -1: treated as unknown")));
}

TEST_F(Urdf, TakesCollisionShapesAndVisualOnesWhereThereAreNone) {
  const RobotSpec robot = read(kGripper);
  ASSERT_EQ(robot.links[0].shapes.size(), 1U);
  EXPECT_EQ(robot.links[0].shapes[0].size, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(robot.links[1].shapes[0].X_BS.p, Eigen::Vector3d(0, 0, 0.01));
  EXPECT_EQ(robot.links[2].shapes[0].kind, ShapeKind::kCylinder);
  EXPECT_THAT(robot.warnings, Contains(AllOf(HasSubstr("visual"), HasSubstr("finger"))));
  EXPECT_EQ(robot.links[3].shapes[0].kind, ShapeKind::kCapsule);
  EXPECT_EQ(robot.links[3].shapes[0].size.head<2>(), Eigen::Vector2d(0.01, 0.04));
}

TEST_F(Urdf, DrivesMimicsByTheJointTheyFollow) {
  const RobotSpec robot = read(kGripper);
  ASSERT_THAT(names(robot.dofs), ElementsAre("knuckle", "slide"));
  EXPECT_EQ(robot.dofs[0].max_effort, 4);
  EXPECT_EQ(robot.dofs[0].speed, 2);
  EXPECT_EQ(robot.dofs[0].upper, 1.6);   // the follower reaches 0.9 of its 1.7
  EXPECT_EQ(robot.dofs[1].speed, -0.1);  // closes towards its lower limit
  EXPECT_EQ(robot.joints[1].dof, "knuckle");
  EXPECT_EQ(robot.joints[1].ratio, 0.5);
  EXPECT_EQ(robot.joints[1].offset, 0.1);
  EXPECT_EQ(robot.joints[0].damping, 0.2);
  EXPECT_EQ(robot.joints[0].friction, 0.3);
}

// Knuckle at 1: the finger stands at (0.1, 0, 0), its y along world -x, so its z leans over
// to sin(1) along world y. The tip turns by 0.5 * 1 + 0.1 more about the same line.
TEST_F(Urdf, PlacesLinksAsByHand) {
  const RobotSpec robot = read(kGripper);
  const std::vector<Pose<double>> X = link_poses(robot, {{"knuckle", 1.0}, {"slide", -0.02}});
  EXPECT_TRUE(matrix_near(X[1].p, Eigen::Vector3d(0.1, 0.05 * std::sin(1.0), 0.05 * std::cos(1.0)),
                          kUrdfRounding));
  EXPECT_TRUE(
      matrix_near(X[1].R.col(2), Eigen::Vector3d(0, std::sin(1.6), std::cos(1.6)), kUrdfRounding));
  EXPECT_TRUE(matrix_near(X[3].p, Eigen::Vector3d(-0.02, 0, 0), kUrdfRounding));
}

TEST_F(Urdf, FollowsChainsOfMimics) {
  const std::string limits =
      "<axis xyz='0 0 1'/><limit lower='-9' upper='9' effort='1' velocity='1'/>";
  const RobotSpec robot = read(
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
      "<joint name='3' type='revolute'><parent link='c'/><child link='d'/><mimic joint='2' "
      "multiplier='-2' offset='0.5'/>" +
      limits +
      "</joint>"
      "<joint name='2' type='revolute'><parent link='b'/><child link='c'/><mimic joint='1' "
      "multiplier='3' offset='1'/>" +
      limits +
      "</joint>"
      "<joint name='1' type='revolute'><parent link='a'/><child link='b'/>" +
      limits + "</joint></robot>");
  const RobotJoint& last = robot.joints[2];
  EXPECT_EQ(last.dof, "1");
  EXPECT_EQ(last.ratio, -6);     // -2 * 3
  EXPECT_EQ(last.offset, -1.5);  // -2 * 1 + 0.5
  // Joint 3 within +-9: -6 q - 1.5 in [-9, 9], so q in [-1.75, 1.25]; joint 2: q in [-10/3, 8/3].
  EXPECT_DOUBLE_EQ(robot.dofs[0].lower, -1.75);
  EXPECT_DOUBLE_EQ(robot.dofs[0].upper, 1.25);
}

TEST_F(Urdf, NamesWhatItDoesNotRead) {
  const RobotSpec robot = read(kGripper);
  EXPECT_THAT(robot.warnings,
              Contains(HasSubstr("<transmission> in <robot> is not read (line 32)")));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("<material> in <robot> is not read (line 3)")));
}

TEST_F(Urdf, GivesContinuousJointsOneTurn) {
  const RobotSpec robot =
      read(two_links(std::string("<joint name='j' type='continuous'>") + kEnds + "</joint>"));
  EXPECT_EQ(robot.dofs[0].lower, -kPi);
  EXPECT_EQ(robot.dofs[0].upper, kPi);
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d::UnitX());  // the format's default
}

TEST_F(Urdf, NamesJointsWithoutLimitsOnce) {
  std::string text = "<robot name='r'><link name='base'/>";
  for (int i = 0; i < 6; ++i)
    text += fmt::format(
        "<link name='l{0}'/><joint name='j{0}' type='{1}'><parent link='base'/>"
        "<child link='l{0}'/></joint>",
        i,
        i < 3   ? "continuous"
        : i < 5 ? "revolute"
                : "prismatic");
  const RobotSpec robot = read(text + "</robot>");
  EXPECT_THAT(robot.warnings,
              Contains("continuous joints 'j0', 'j1', 'j2', 'j3' and 1 more get one turn, -pi to "
                       "pi"));
  EXPECT_THAT(robot.warnings,
              Contains(HasSubstr("revolute joints 'j3', 'j4' have no <limit>: taken as "
                                 "continuous")));
  EXPECT_THAT(robot.warnings,
              Contains(HasSubstr("prismatic joint 'j5' has no <limit>: it stays at zero")));
}

TEST_F(Urdf, HoldsFloatingAndPlanarJointsAndSaysSo) {
  for (const std::string type : {"floating", "planar"}) {
    const RobotSpec robot =
        read(two_links("<joint name='j' type='" + type + "'>" + kEnds + "</joint>"));
    EXPECT_EQ(robot.joints[0].kind, RobotJointKind::kFixed);
    EXPECT_THAT(robot.warnings, ElementsAre(HasSubstr(type + " joint 'j' is taken as fixed")));
  }
}

/// Two links, the tip a mesh.
std::string with_mesh(const std::string& file) {
  return two_links(std::string("<joint name='j' type='fixed'>") + kEnds + "</joint>",
                   "<collision><geometry><mesh filename='" + file +
                       "' scale='0.001 0.001 0.001'/></geometry></collision>");
}

// Without the face opposite the corner: closed by a fan that restores it, 1/6 mm^3.
TEST_F(Urdf, MendsALeakyMeshAndNamesItsLink) {
  write_file(path("open.OFF"),
             "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n");
  write_file(path("r.urdf"), with_mesh("open.OFF"));
  const RobotSpec robot = import_robot(path("r.urdf"));
  ASSERT_EQ(robot.links[1].shapes.size(), 1U);
  EXPECT_THAT(robot.warnings, ElementsAre(AllOf(HasSubstr("MENDED mesh 'open.OFF' of link 'tip'"),
                                                HasSubstr("1 hole(s) closed"))));
  EXPECT_NEAR(mass_properties(robot.links[1].shapes[0].mesh, 1).mass, 1e-9 / 6, 1e-15);
  // What it is then needs no file, and is read back as it is.
  EXPECT_EQ(robot.links[1].shapes[0].mesh_file, "");
  const RobotSpec again = parse_robot(robot_toml(robot), path("again.toml"));
  EXPECT_EQ(again.links[1].shapes[0].mesh.vertices, robot.links[1].shapes[0].mesh.vertices);
}

// Two triangles without area beside the four of a wedge, and a scale that makes the shape a surface
// of its own: what is written is read back and built.
TEST_F(Urdf, WritesMeshesWithTrianglesWithoutAreaSoThatTheyAreReadBack) {
  write_file(
      path("thin.off"),
      "OFF\n6 6 0\n0 0 0\n20 0 0\n0 10 0\n0 0 5\n10 0 0\n15 0 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 "
      "3\n3 0 4 1\n3 4 5 1\n");
  std::string text = with_mesh("thin.off");
  text.replace(text.find("0.001 0.001 0.001"), 17, "0.001 0.001 0.002");
  write_file(path("r.urdf"), text);
  const RobotSpec robot = import_robot(path("r.urdf"));
  ASSERT_EQ(robot.links[1].shapes.size(), 1U);
  const RobotSpec again = parse_robot(robot_toml(robot), path("again.toml"));
  ASSERT_EQ(again.links[1].shapes.size(), 1U);
  // 20 x 10 x 10 / 6 mm^3.
  EXPECT_NEAR(mass_properties(again.links[1].shapes[0].mesh, 1).mass, 2e-6 / 6, 1e-18);
  EXPECT_LT(build_solid(again.links[1].shapes).shape->distance({0.002, 0.001, 0.001}), 0);
}

TEST_F(Urdf, LeavesOutAFlatMeshAndSaysSo) {
  write_file(path("flat.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_file(path("r.urdf"), with_mesh("flat.off"));
  const RobotSpec robot = import_robot(path("r.urdf"));
  EXPECT_THAT(robot.links[1].shapes, IsEmpty());
  EXPECT_THAT(robot.warnings, ElementsAre(HasSubstr("LEFT OUT mesh 'flat.off' of link 'tip'")));
}

TEST_F(Urdf, FindsMeshesInPackagesAboveIt) {
  std::filesystem::create_directories(folder_ / "my_robot" / "urdf");
  std::filesystem::create_directories(folder_ / "my_robot" / "meshes");
  write_file(path("my_robot/meshes/t.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto with = [&](const std::string& name) {
    return read(two_links(std::string("<joint name='j' type='fixed'>") + kEnds + "</joint>",
                          "<collision><geometry><mesh filename='" + name +
                              "' scale='0.001 0.001 0.001'/></geometry></collision>"),
                "my_robot/urdf/robot.urdf");
  };
  for (const std::string name :
       {"package://my_robot/meshes/t.off", "model://renamed/meshes/t.off", "../meshes/t.off"}) {
    const RobotSpec robot = with(name);
    ASSERT_EQ(robot.links[1].shapes.size(), 1U) << name;
    EXPECT_EQ(robot.links[1].shapes[0].mesh_scale, 0.001);
    EXPECT_DOUBLE_EQ(robot.links[1].shapes[0].mesh.vertices.maxCoeff(), 0.001);
    EXPECT_THAT(robot.warnings, IsEmpty());
  }
  const RobotSpec without = with("package://my_robot/meshes/lost.stl");
  EXPECT_THAT(without.links[1].shapes, IsEmpty());
  EXPECT_THAT(without.warnings, ElementsAre(AllOf(HasSubstr("MISSING MESH"), HasSubstr("lost.stl"),
                                                  HasSubstr("tip"))));
  // Where it was looked for, and the nearest name there.
  write_file(path("my_robot/meshes/cap.stl"), "");
  const RobotSpec misspelt = with("package://my_robot/meshes/cop.stl");
  EXPECT_THAT(misspelt.warnings,
              ElementsAre(AllOf(HasSubstr("looked beside"),
                                HasSubstr("all folders above, did you mean 'cap.stl'?"))));
}

// A mirrored triangle keeps its outside: x -> -x with corners swapped.
TEST_F(Urdf, TurnsMirroredMeshesRightSideOut) {
  write_file(path("t.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const RobotSpec robot =
      read(two_links(std::string("<joint name='j' type='fixed'>") + kEnds + "</joint>",
                     "<collision><geometry><mesh filename='t.off' scale='-1 1 1'/></geometry>"
                     "</collision>"));
  const TriangleMesh& mesh = robot.links[1].shapes[0].mesh;
  const Eigen::Vector3d a = mesh.vertices.col(mesh.triangles(0, 0)),
                        b = mesh.vertices.col(mesh.triangles(1, 0)),
                        c = mesh.vertices.col(mesh.triangles(2, 0));
  EXPECT_EQ((b - a).cross(c - a), Eigen::Vector3d(0, 0, 1));
}

TEST_F(Urdf, RefusesWithTheLine) {
  EXPECT_THAT(refusal("<robot name='r'>\n<link name='a'>\n</robot>"), HasSubstr("robot.urdf:3: "));
  EXPECT_THAT(refusal("<robot name='r'>\n<xacro:finger n='1'/></robot>"),
              AllOf(HasSubstr(":2: "), HasSubstr("xacro")));
  EXPECT_THAT(refusal(two_links("<joint name='j' type='fixed'><parent link='base'/>"
                                "<child link='tipp'/></joint>")),
              AllOf(HasSubstr(":4: "), HasSubstr("'tipp'")));
  EXPECT_THAT(refusal(two_links(std::string("<joint name='j' type='revolute'>") + kEnds +
                                "<limit lower='nan' upper='1'/></joint>")),
              AllOf(HasSubstr(":4: "), HasSubstr("<limit> lower")));
  EXPECT_THAT(refusal(two_links(std::string("<joint name='j' type='continuous'>") + kEnds +
                                "<mimic joint='x'/></joint>")),
              AllOf(HasSubstr(":4: "), HasSubstr("there is no such joint")));
  EXPECT_THAT(refusal(two_links(std::string("<joint name='j' type='continuous'>") + kEnds +
                                "<mimic joint='j'/></joint>")),
              AllOf(HasSubstr(":4: "), HasSubstr("follows itself")));
  EXPECT_THAT(refusal("<robot name='r'>\n<link name='a'/><link name='b'/></robot>"),
              HasSubstr("Two root links found: [a] and [b]"));
}

// What urdfdom refuses though its meaning is plain.
TEST_F(Urdf, ForgivesMissingEffortAndDuplicateColours) {
  const RobotSpec robot = read(
      "<robot name='r'><material name='m'/><material name='m'/><link name='base'/><link name='tip'>"
      "<collision/></link>" +
      std::string("<joint name='j' type='revolute'>") + kEnds +
      "<limit lower='0' upper='1'/></joint></robot>");
  EXPECT_EQ(robot.dofs[0].max_effort, 0);
  EXPECT_EQ(robot.dofs[0].upper, 1);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("<collision> of link 'tip' has no shape")));
}

}  // namespace
}  // namespace thenar
