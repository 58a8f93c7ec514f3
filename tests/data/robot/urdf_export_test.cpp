// Tests for data/io/robot/urdf_export.cpp.

#include "data/io/robot/urdf_export.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include <gmock/gmock.h>

#include <sys/resource.h>

#include "base/error.h"
#include "base/read_file.h"
#include "base/units.h"
#include "base/write_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/urdf.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/matrix_near.h"
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
  robot.dofs[0].kind = RobotDofKind::kBreakaway;
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
}  // namespace thenar
