// Tests for data/io/robot/robot_toml.cpp and robot_toml_read.cpp.

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/robot/robot_parts.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using internal::same_bits;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

void expect_same_pose(const Pose<double>& a, const Pose<double>& b) {
  EXPECT_TRUE(same_bits(a.R, b.R));
  EXPECT_TRUE(same_bits(a.p, b.p));
}

void expect_same_link(const RobotLink& a, const RobotLink& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.digit, b.digit);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_TRUE(same_bits(a.com, b.com));
  EXPECT_TRUE(same_bits(a.inertia, b.inertia));
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    EXPECT_EQ(a.shapes[i].kind, b.shapes[i].kind);
    EXPECT_TRUE(same_bits(a.shapes[i].size, b.shapes[i].size));
    EXPECT_TRUE(same_bits(a.shapes[i].exponents, b.shapes[i].exponents));
    EXPECT_EQ(a.shapes[i].mesh.vertices, b.shapes[i].mesh.vertices);
    EXPECT_EQ(a.shapes[i].mesh.triangles, b.shapes[i].mesh.triangles);
    EXPECT_EQ(a.shapes[i].mesh_scale, b.shapes[i].mesh_scale);
    expect_same_pose(a.shapes[i].X_BS, b.shapes[i].X_BS);
  }
}

void expect_same_joint(const RobotJoint& a, const RobotJoint& b) {
  EXPECT_EQ(std::tie(a.name, a.kind, a.parent, a.child, a.dof, a.ratio, a.offset),
            std::tie(b.name, b.kind, b.parent, b.child, b.dof, b.ratio, b.offset));
  EXPECT_EQ(std::tie(a.lower, a.upper, a.damping, a.friction, a.stiffness, a.rest),
            std::tie(b.lower, b.upper, b.damping, b.friction, b.stiffness, b.rest));
  EXPECT_TRUE(same_bits(a.axis, b.axis));
  expect_same_pose(a.X_PJ, b.X_PJ);
  expect_same_pose(a.X_JC, b.X_JC);
}

void expect_same(const RobotSpec& a, const RobotSpec& b) {
  EXPECT_EQ(std::tie(a.name, a.description, a.source, a.licence, a.closing_stated, a.warnings),
            std::tie(b.name, b.description, b.source, b.licence, b.closing_stated, b.warnings));
  EXPECT_TRUE(same_bits(a.approach.point, b.approach.point));
  EXPECT_TRUE(same_bits(a.approach.direction, b.approach.direction));
  ASSERT_EQ(a.links.size(), b.links.size());
  ASSERT_EQ(a.joints.size(), b.joints.size());
  ASSERT_EQ(a.dofs.size(), b.dofs.size());
  for (std::size_t i = 0; i < a.links.size(); ++i) expect_same_link(a.links[i], b.links[i]);
  for (std::size_t i = 0; i < a.joints.size(); ++i) expect_same_joint(a.joints[i], b.joints[i]);
  for (std::size_t i = 0; i < a.dofs.size(); ++i) {
    const RobotDof &x = a.dofs[i], &y = b.dofs[i];
    EXPECT_EQ(
        std::tie(x.name, x.kind, x.lower, x.upper, x.speed, x.max_effort, x.breakaway, x.stiffness),
        std::tie(y.name, y.kind, y.lower, y.upper, y.speed, y.max_effort, y.breakaway,
                 y.stiffness));
    EXPECT_EQ(std::tie(x.backdrivable, x.nominal_effort),
              std::tie(y.backdrivable, y.nominal_effort));
    EXPECT_EQ(std::signbit(x.lower), std::signbit(y.lower));
  }
}

TEST(RobotToml, MarksWhatWasGuessed) {
  RobotSpec stated = sample::small_robot(1);
  stated.closing_stated = false;
  for (RobotLink& link : stated.links) link.digit = link.material = "";
  RobotSpec guessed = stated;
  guessed.closing_stated = true;
  guessed.links[1].digit = "thumb";
  guessed.links[1].material = "plastic";
  guessed.approach.direction = {1, 0, 0};
  const std::string text = robot_toml(guessed, &stated);
  for (const char* line : {"\ndigit = \"thumb\"  # guessed\n",
                           "\nmaterial = \"plastic\"  # guessed\n", "\n[approach]  # guessed\n"})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(text, ContainsRegex("\nspeed = [^\n]*  # guessed\n"));
  EXPECT_THAT(robot_toml(guessed), Not(HasSubstr("guessed")));
}

// A person who reads how fast a motor closes, and writes which way, is believed.
TEST(RobotToml, BelievesSpeedsWrittenBesideRates) {
  RobotSpec robot = sample::small_robot(1);
  for (RobotDof& dof : robot.dofs) dof.speed = 0.5;
  robot.closing_stated = false;
  std::string text = robot_toml(robot);
  EXPECT_FALSE(parse_robot(text, "robot.toml").closing_stated);
  const std::string rate = "\nrate = 0.5\n", speed = "\nspeed = -0.5";
  std::size_t written = 0;
  for (std::size_t at = text.find(rate); at != std::string::npos;
       at = text.find(rate, at + speed.size() + 1)) {
    // Where only some motors have a speed the others are asked for theirs.
    if (written++ == 1) {
      EXPECT_THAT(message_of<DataError>([&] { (void)parse_robot(text, "robot.toml"); }),
                  HasSubstr("wanted a speed"));
    }
    text.insert(at, speed);
  }
  EXPECT_EQ(written, robot.dofs.size());
  const RobotSpec corrected = parse_robot(text, "robot.toml");
  EXPECT_TRUE(corrected.closing_stated);
  for (const RobotDof& dof : corrected.dofs) EXPECT_EQ(dof.speed, -0.5);
}

TEST(RobotToml, KeepsEveryBit) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RobotSpec robot = sample::small_robot(seed);
    robot.dofs[seed % 2].backdrivable = false;
    robot.dofs[seed % 2].nominal_effort = seed % 3 == 0;
    robot.closing_stated = seed % 4 != 0;
    expect_same(parse_robot(robot_toml(robot), "robot.toml"), robot);
  }
}

/// Numbers of sizes of each kind of shape.
const std::map<ShapeKind, int> kSizes{{ShapeKind::kSphere, 1},         {ShapeKind::kBox, 3},
                                      {ShapeKind::kCylinder, 2},       {ShapeKind::kCapsule, 2},
                                      {ShapeKind::kTaperedCapsule, 3}, {ShapeKind::kEllipsoid, 3},
                                      {ShapeKind::kSuperellipsoid, 3}, {ShapeKind::kMesh, 0}};

TEST(RobotToml, KeepsEveryKindOfShape) {
  RobotSpec robot = sample::small_robot();
  std::mt19937 rng(5);
  for (const auto& [kind, sizes] : kSizes) {
    ShapeSpec shape;
    shape.kind = kind;
    shape.X_BS = sample::random_pose(rng);
    for (int i = 0; i < sizes; ++i) shape.size[i] = 0.1 / (i + 3);
    if (shape.kind == ShapeKind::kSuperellipsoid) shape.exponents << 0.3, 1.0 / 3;
    robot.links[1].shapes.push_back(shape);
  }
  TriangleMesh& mesh = robot.links[1].shapes.back().mesh;
  mesh.vertices = 0.1 * Eigen::Matrix<double, 3, 4>::Identity();
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 3, 1, 2, 2, 1;
  robot.links[1].shapes.back().mesh_scale = 1e-3;
  expect_same(parse_robot(robot_toml(robot), "robot.toml"), robot);
}

TEST(RobotToml, KeepsThatARobotHasNoSource) {
  RobotSpec robot = sample::small_robot();
  robot.source.clear();
  EXPECT_EQ(parse_robot(robot_toml(robot), "robot.toml").source, "");
}

const std::string kHead = "name = \"r\"\nsource = \"GraspIt\"\n";

TEST(RobotToml, ReadsWormsAndPlaceholders) {
  const RobotSpec robot = parse_robot(kHead + R"(
link = [{name = "base"}]
dof = [{name = "d1", range_deg = [0, 90], max_effort_Nm = 50, backdrive = "held", effort_is = "nominal"}]
)",
                                      "robot.toml");
  EXPECT_FALSE(robot.dofs[0].backdrivable);
  EXPECT_TRUE(robot.dofs[0].nominal_effort);
}

// One row of each kind: Rz(theta) Tz(d) Tx(a) Rx(alpha) with theta = 90 deg, alpha = 90 deg.
TEST(RobotToml, ReadsDenavitHartenbergRows) {
  const RobotSpec robot = parse_robot(kHead + R"(
link = [{name = "base"}, {name = "a"}, {name = "b"}]
dof = [{name = "d1", range_deg = [0, 90]}, {name = "d2", range_mm = [0, 10], max_effort_N = 3}]
[[dh_chain]]
parent = "base"
frame = {position_mm = [1, 2, 3], quaternion_wxyz = [0.7071, 0.7071, 0, 0]}
rows = [
  {joint = "J1", child = "a", dof = "d1", theta_deg = 90, d_mm = 5, a_mm = 7, alpha_deg = 90},
  {joint = "J2", kind = "prismatic", child = "b", dof = "d2", range_mm = [0, 10]}]
)",
                                      "robot.toml");
  ASSERT_EQ(robot.joints.size(), 2U);
  const RobotJoint& joint = robot.joints[0];
  Eigen::Matrix3d about_x, row;
  about_x << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  row << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_TRUE(matrix_near(joint.X_PJ.R, about_x, 1e-15));
  EXPECT_TRUE(matrix_near(joint.X_PJ.p, Eigen::Vector3d(0.001, 0.002, 0.003), 1e-18));
  EXPECT_TRUE(matrix_near(joint.X_JC.R, row, 1e-15));
  EXPECT_TRUE(matrix_near(joint.X_JC.p, Eigen::Vector3d(0, 0.007, 0.005), 1e-17));
  EXPECT_EQ(robot.joints[1].parent, "a");
  EXPECT_EQ(robot.joints[1].kind, RobotJointKind::kPrismatic);
  EXPECT_EQ(robot.dofs[1].max_effort, 3);
  EXPECT_TRUE(robot.dofs[1].backdrivable);
  EXPECT_FALSE(robot.dofs[1].nominal_effort);
}

// Roll 90 deg about x first, then yaw 90 deg about the fixed z: y goes to z, x to y.
TEST(RobotToml, TurnsAboutFixedAxesRollFirst) {
  const RobotSpec robot = parse_robot(kHead + R"(
link = [{name = "base"}, {name = "a"}]
[[joint]]
name = "J"
kind = "fixed"
parent = "base"
child = "a"
frame = {rpy_deg = [90, 0, 90]}
)",
                                      "robot.toml");
  EXPECT_TRUE(matrix_near(robot.joints[0].X_PJ.R.col(1), Eigen::Vector3d::UnitZ(), 1e-15));
  EXPECT_TRUE(matrix_near(robot.joints[0].X_PJ.R.col(0), Eigen::Vector3d::UnitY(), 1e-15));
}

TEST(RobotToml, MakesDirectionsUnitVectors) {
  const RobotSpec robot = parse_robot(kHead + R"(
approach = {direction = [3, 0, 4]}
link = [{name = "base"}, {name = "a"}]
joint = [{name = "J", parent = "base", child = "a", axis = [0, -2, 0]}]
)",
                                      "robot.toml");
  EXPECT_TRUE(matrix_near(robot.approach.direction, Eigen::Vector3d(0.6, 0, 0.8), 1e-15));
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d(0, -1, 0));
}

std::string message(const std::string& body) {
  return message_of<DataError>([&] { (void)parse_robot(kHead + body, "r.toml"); });
}

TEST(RobotToml, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(message("link = []\n"), "r.toml:1: robot 'r' has no link");
  EXPECT_EQ(message("link = [{name = \"a\"}]\n[[dof]]\nname = \"d\"\nrange_deg = [2, 1]\n"),
            "r.toml:4: limits of degree of freedom 'd' cross: 0.03490658503988659 .. "
            "0.017453292519943295");
  EXPECT_THAT(message("[[link]]\nname = \"a\"\nmas_kg = 1\n"), testing::HasSubstr("r.toml:5: "));
  EXPECT_THAT(message("[[link]]\nname = \"a\"\nmass_kg = nan\n"), testing::HasSubstr("finite"));
  EXPECT_EQ(message("[[link]]\nname = \"a\"\ninertia_kg_m2 = [1, 1, 3]\n"),
            "r.toml:3: the inertia of link 'a' is not a body's");
}

}  // namespace
}  // namespace thenar
