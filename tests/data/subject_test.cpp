// Tests for data/io/subject.cpp: what a file means.

#include "data/io/subject.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// A straight finger along -x with one hinge, 20 mm from its tip.
const std::string kFinger = R"(
name = "one hinge"
side = "right"
base = "MC2"
source = "An1983"
reference_length_mm = 20
specific_tension_N_cm2 = 30

[[segment]]
name = "MC2"
aliases = ["Palm"]

[[segment]]
name = "PP2"
proximal_mm = [20, 0, 0]
distal_mm = [0, 0, 0]
mass_g = 12
inertia_axial_g_mm2 = 100
inertia_transverse_g_mm2 = 400

[[joint]]
name = "MCP2_FE"
parent = "Palm"
child = "PP2"
direction = [0, 0, -2]
direction_sign = -1
direction_sd_deg = 5
point_mm = [20, 0, 0]
point_sd_mm = 2
range_deg = [-20, 90]
rest_deg = 15
stiffness_Nmm_per_rad = 50
damping_Nms_per_rad = 0.001

[[frame]]
name = "distal"
segment = "PP2"
origin_mm = [10, 0, 0]
axes = [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]

[[strand]]
name = "FDP"
path = [
  {frame = "distal", point_ratio = [0.1, -0.2, 0]},
  {frame = "distal", point_mm = [1, 2, 3], point_sd_mm = 0.5},
  {segment = "MC2", point_cm = [3, 0, 0]},
]
arms_mm = {MCP2_FE = 8}

[[muscle]]
name = "FDP"
pcsa_cm2 = 4
fibre_length_mm = 66

[[muscle]]
name = "FDS"
strand = "FDP"
max_force_N = 100
pcsa_cm2 = 4

[[digit]]
name = "index"
tip_segment = "PP2"
tip_mm = [0, -1, 0]
proximal = [1, 0, 0]
dorsal = [0.01, 1, 0]
)";

class SubjectFile : public testing::Test {
 protected:
  const Subject subject_ = parse_subject(kFinger, "finger.toml");
};

TEST_F(SubjectFile, SegmentIsInSi) {
  const Segment& bone = subject_.segments[1];
  EXPECT_DOUBLE_EQ(bone.mass, 0.012);
  EXPECT_TRUE(matrix_near(bone.proximal, Vector3d(0.02, 0, 0), 1e-15));
  EXPECT_TRUE(matrix_near(bone.com, Vector3d(0.01, 0, 0), 1e-15)) << "halfway unless stated";
}

// The small moment is about the bone, which lies along x.
TEST_F(SubjectFile, SlenderInertiaTurnsWithTheBone) {
  const Eigen::Matrix3d expected = Vector3d(100e-9, 400e-9, 400e-9).asDiagonal();
  EXPECT_TRUE(matrix_near(subject_.segments[1].inertia, expected, 1e-18));
}

TEST_F(SubjectFile, JointIsInSiAndUnit) {
  const JointAxis& joint = subject_.joints[0];
  EXPECT_TRUE(matrix_near(joint.direction, Vector3d::UnitZ(), 0)) << "published one reversed";
  EXPECT_NEAR(joint.direction_sd, 5 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(joint.point_sd, 0.002);
  EXPECT_NEAR(joint.lower, -20 * kDegree, 1e-15);
  EXPECT_NEAR(joint.upper, 90 * kDegree, 1e-15);
  EXPECT_NEAR(joint.rest, 15 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(joint.stiffness, 0.05);
  EXPECT_DOUBLE_EQ(joint.damping, 0.001);
}

TEST_F(SubjectFile, AliasBecomesTheSegment) { EXPECT_EQ(subject_.joints[0].parent, "MC2"); }

// By hand: origin 10 mm; x of the frame points to -x; ratios are of 20 mm.
TEST_F(SubjectFile, FramePointsComeToTheSubjectsFrame) {
  const std::vector<PathPoint>& path = subject_.strands[0].path;
  EXPECT_EQ(path[0].segment, "PP2");
  EXPECT_TRUE(matrix_near(path[0].p, Vector3d(0.008, -0.004, 0), 1e-15));
  EXPECT_TRUE(matrix_near(path[1].p, Vector3d(0.009, 0.002, 0.003), 1e-15));
  EXPECT_DOUBLE_EQ(path[1].sd, 0.0005);
  EXPECT_TRUE(matrix_near(path[2].p, Vector3d(0.03, 0, 0), 1e-15));
}

TEST_F(SubjectFile, ArmsAreInMetres) {
  EXPECT_DOUBLE_EQ(subject_.strands[0].arms.at("MCP2_FE"), 0.008);
}

// 4 cm^2 at 30 N/cm^2; a stated force wins.
TEST_F(SubjectFile, ForceComesFromAreaUnlessStated) {
  EXPECT_NEAR(subject_.muscles[0].max_force.value(), 120, 1e-12);
  EXPECT_DOUBLE_EQ(subject_.muscles[1].max_force.value(), 100);
  EXPECT_DOUBLE_EQ(subject_.muscles[0].pcsa, 4e-4);
}

TEST_F(SubjectFile, MusclePullsTheStrandOfItsName) {
  EXPECT_EQ(subject_.muscles[0].strand, "FDP");
  EXPECT_EQ(subject_.muscles[1].strand, "FDP");
}

TEST_F(SubjectFile, DirectionsAreMadeSquare) {
  const Digit& digit = subject_.digits[0];
  EXPECT_TRUE(matrix_near(digit.proximal, Vector3d::UnitX(), 0));
  EXPECT_TRUE(matrix_near(digit.dorsal, Vector3d::UnitY(), 1e-15));
  EXPECT_TRUE(matrix_near(digit.radial, Vector3d::UnitZ(), 1e-15));
}

TEST(SubjectFileOf, LeftHandHasRadialOnTheOtherSide) {
  std::string left = kFinger;
  left.replace(left.find("right"), 5, "left");
  const Subject subject = parse_subject(left, "left.toml");
  EXPECT_TRUE(matrix_near(subject.digits[0].radial, -Vector3d::UnitZ(), 1e-15));
}

TEST(SubjectFileOf, FullInertiaTensorIsSymmetric) {
  const Subject subject = parse_subject(R"(
name = "box"
side = "right"
base = "B"
source = "An1983"
[[segment]]
name = "B"
mass_kg = 1
inertia_kg_m2 = [3, 4, 5, 0.1, 0.2, 0.3])",
                                        "box.toml");
  Eigen::Matrix3d expected;
  expected << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
  EXPECT_TRUE(matrix_near(subject.segments[0].inertia, expected, 0));
}

// A stated zero is a muscle that cannot pull; one without any number is unknown.
TEST(SubjectFileOf, ZeroForceIsNotAnUnknownForce) {
  const Subject subject = parse_subject(R"(
name = "map"
side = "right"
source = "An1983"
[[muscle]]
name = "cut"
max_force_N = 0
[[muscle]]
name = "unknown"
[[tip_map]]
name = "A"
digit = "index"
muscles = ["cut"]
rows = {Fz = [0.1]})",
                                        "map.toml");
  EXPECT_EQ(subject.muscles[0].max_force, 0.0);
  EXPECT_EQ(subject.muscles[1].max_force, std::nullopt);
}

TEST(SubjectFileOf, TipMapsNeedNoGeometry) {
  const Subject subject = parse_subject(R"(
name = "map"
side = "right"
source = "An1983"
[[muscle]]
name = "FDP"
max_force_N = 123
[[tip_map]]
name = "A"
digit = "index"
muscles = ["FDP"]
rows = {Fz = [0.1], Fx = [-0.2]})",
                                        "map.toml");
  EXPECT_TRUE(subject.segments.empty());
  EXPECT_EQ(subject.tip_maps[0].rows, (std::vector<std::string>{"Fz", "Fx"}));
  EXPECT_TRUE(matrix_near(subject.tip_maps[0].A, Eigen::Vector2d(0.1, -0.2), 0));
}

TEST(SubjectFileOf, CoupledJointFollowsItsLeader) {
  const Subject subject = parse_subject(kFinger + R"(
[[segment]]
name = "MP2"
[[joint]]
name = "PIP2"
parent = "PP2"
child = "MP2"
direction = [0, 0, 1]
point_mm = [10, 0, 0]
couple = {to = "MCP2_FE", ratio = 0.5, offset_deg = 10})",
                                        "coupled.toml");
  const Coupling& coupling = *subject.joints[1].coupling;
  EXPECT_EQ(coupling.leader, "MCP2_FE");
  EXPECT_DOUBLE_EQ(coupling.ratio, 0.5);
  EXPECT_NEAR(coupling.offset, 10 * kDegree, 1e-15);
}

// Two links of 30 and 20 mm in a plane, published with the first variable extending.
TEST(SubjectFileOf, DhChainGivesAxesAndTip) {
  const Subject subject = parse_subject(R"(
name = "arm"
side = "right"
base = "Palm"
source = "Denavit1955"
[[segment]]
name = "Palm"
[[segment]]
name = "A"
[[segment]]
name = "B"
[[dh_chain]]
digit = "index"
parent = "Palm"
base_position_mm = [1, 0, 0]
base_quaternion_wxyz = [1, 0, 0, 0]
rows = [
  {joint = "J1", child = "A", sign = -1, a_mm = 30, range_deg = [-10, 45]},
  {joint = "J2", child = "B", theta_deg = 90, a_mm = 20},
]
[[digit]]
name = "index"
tip_segment = "B"
proximal = [0, -1, 0]
dorsal = [0, 0, 1])",
                                        "arm.toml");
  EXPECT_TRUE(matrix_near(subject.joints[0].direction, -Vector3d::UnitZ(), 0));
  EXPECT_NEAR(subject.joints[0].lower, -45 * kDegree, 1e-15);
  EXPECT_NEAR(subject.joints[0].upper, 10 * kDegree, 1e-15);
  EXPECT_EQ(subject.joints[1].parent, "A");
  EXPECT_TRUE(matrix_near(subject.joints[1].point, Vector3d(0.031, 0, 0), 1e-15));
  EXPECT_TRUE(matrix_near(subject.digits[0].tip, Vector3d(0.031, 0.02, 0), 1e-15));
}

}  // namespace
}  // namespace thenar
