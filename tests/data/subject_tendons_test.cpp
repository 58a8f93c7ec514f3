// Tests for data/io/subject_tendons.cpp and subject_paths.cpp: surfaces and what bends over them.

#include <algorithm>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "base/error.h"
#include "data/io/subject.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// A hinge at the origin; surfaces and strands follow.
const std::string kBones = R"(
name = "one hinge"
side = "right"
base = "MC2"
source = "An1983"

[[segment]]
name = "MC2"

[[segment]]
name = "PP2"

[[joint]]
name = "MCP2_FE"
parent = "MC2"
child = "PP2"
direction = [0, 0, 1]
point_mm = [0, 0, 0]
)";

const std::string kHead = R"(
[[surface]]
name = "head"
segment = "MC2"
shape = "cylinder"
center_mm = [1, 2, 3]
axis = [0, 3, 4]
radius_mm = 5
half_length_mm = 6
)";

const std::string kFlexor = R"(
[[strand]]
name = "FDP"
path = [
  {segment = "PP2", point_mm = [-20, 9, 0]},
  {surface = "head", side_mm = [0, 10, 0]},
  {segment = "MC2", point_mm = [20, 9, 0]},
]
)";

Subject parse(const std::string& text) { return parse_subject(text, "hand.toml"); }

std::string surface_refusal(const std::string& text) {
  try {
    (void)parse(text);
  } catch (const DataError& error) {
    return error.what();
  }
  return "accepted";
}

std::string line_of(const std::string& text, const std::string& part) {
  const auto at = text.begin() + static_cast<std::ptrdiff_t>(text.find(part));
  return std::to_string(1 + std::count(text.begin(), at, '\n'));
}

TEST(SubjectSurfaces, ReadsACylinderInMetres) {
  const Surface surface = parse(kBones + kHead).surfaces.at(0);
  EXPECT_EQ(surface.segment, "MC2");
  EXPECT_EQ(surface.shape, SurfaceShape::kCylinder);
  EXPECT_TRUE(matrix_near(surface.size, Vector3d(0.005, 0.006, 0), 1e-18));
  EXPECT_TRUE(matrix_near(surface.center, Vector3d(0.001, 0.002, 0.003), 1e-18));
  EXPECT_TRUE(matrix_near(Vector3d(surface.axes.col(2)), Vector3d(0, 0.6, 0.8), 1e-15));
}

TEST(SubjectSurfaces, CompletesARightHandedFrame) {
  const Surface surface = parse(kBones + kHead).surfaces.at(0);
  EXPECT_NEAR(surface.axes.determinant(), 1, 1e-15);
}

TEST(SubjectSurfaces, ReadsTheOtherShapes) {
  const Subject subject = parse(kBones + R"(
[[surface]]
name = "ball"
segment = "MC2"
shape = "sphere"
center_mm = [0, 0, 0]
radius_mm = 4

[[surface]]
name = "egg"
segment = "MC2"
shape = "ellipsoid"
center_mm = [0, 0, 0]
x_axis = [0, 1, 0]
z_axis = [1, 0, 0]
semi_axes_mm = [1, 2, 3]

[[surface]]
name = "pill"
segment = "PP2"
shape = "capsule"
center_mm = [0, 0, 0]
axis = [1, 0, 0]
radius_mm = 2
half_length_mm = 7

[[surface]]
name = "pulley"
segment = "PP2"
shape = "torus"
center_mm = [0, 0, 0]
axis = [1, 0, 0]
radius_mm = 1
ring_radius_mm = 3
)");
  EXPECT_TRUE(matrix_near(subject.surfaces.at(0).size, Vector3d(0.004, 0, 0), 1e-18));
  EXPECT_TRUE(matrix_near(subject.surfaces.at(1).size, Vector3d(0.001, 0.002, 0.003), 1e-18));
  EXPECT_TRUE(matrix_near(Vector3d(subject.surfaces.at(1).axes.col(1)), Vector3d(0, 0, 1), 1e-15));
  EXPECT_TRUE(matrix_near(subject.surfaces.at(2).size, Vector3d(0.002, 0.007, 0), 1e-18));
  EXPECT_TRUE(matrix_near(subject.surfaces.at(3).size, Vector3d(0.001, 0.003, 0), 1e-18));
}

TEST(SubjectSurfaces, ReadsWhereAStrandBends) {
  const Strand strand = parse(kBones + kHead + kFlexor).strands.at(0);
  EXPECT_EQ(strand.path.at(1).surface, "head");
  EXPECT_EQ(strand.path.at(1).segment, "MC2");
  EXPECT_TRUE(matrix_near(strand.path.at(1).p, Vector3d(0, 0.01, 0), 1e-18));
}

TEST(SubjectSurfaces, ReadsAnOriginThatRides) {
  const Subject subject = parse(kBones + kHead + kFlexor + R"(
[[strand]]
name = "LU"
path = [
  {segment = "PP2", point_mm = [-10, 0, 0]},
  {segment = "MC2", point_mm = [20, 9, 0], rides_on = "FDP"},
]
)");
  EXPECT_EQ(subject.strands.at(1).path.at(1).rides_on, "FDP");
}

TEST(SubjectSurfaces, NamesTheLineOfAnUnknownSurface) {
  const std::string text = kBones + kFlexor;
  EXPECT_EQ(surface_refusal(text), "hand.toml:" + line_of(text, "{surface") +
                                       ": 'surface' names the unknown surface 'head'");
}

TEST(SubjectSurfaces, RefusesATorusWithoutAHole) {
  EXPECT_NE(surface_refusal(kBones + R"(
[[surface]]
name = "bead"
segment = "MC2"
shape = "torus"
center_mm = [0, 0, 0]
axis = [0, 0, 1]
radius_mm = 5
ring_radius_mm = 4
)")
                .find("a torus with a hole"),
            std::string::npos);
}

TEST(SubjectSurfaces, RefusesAPathThatEndsOnASurface) {
  EXPECT_NE(surface_refusal(kBones + kHead + R"(
[[strand]]
name = "FDP"
path = [
  {segment = "PP2", point_mm = [-20, 9, 0]},
  {segment = "MC2", point_mm = [20, 9, 0]},
  {surface = "head", side_mm = [0, 10, 0]},
]
)")
                .find("must begin and end with a point"),
            std::string::npos);
}

TEST(SubjectSurfaces, RefusesAnOriginFarFromWhatItRidesOn) {
  EXPECT_NE(surface_refusal(kBones + R"(
[[strand]]
name = "FDP"
path = [{segment = "PP2", point_mm = [-20, 9, 0]}, {segment = "MC2", point_mm = [20, 9, 0]}]

[[strand]]
name = "LU"
path = [
  {segment = "PP2", point_mm = [-10, 0, 0]},
  {segment = "MC2", point_mm = [10, 11, 0], rides_on = "FDP"},
]
)")
                .find("rides on 'FDP' but lies 2 mm from it, more than 1 mm"),
            std::string::npos);
}

TEST(SubjectSurfaces, RefusesAPointOnTheWayThatRides) {
  EXPECT_NE(surface_refusal(kBones + R"(
[[strand]]
name = "FDP"
path = [{segment = "PP2", point_mm = [-20, 9, 0]}, {segment = "MC2", point_mm = [20, 9, 0]}]

[[strand]]
name = "LU"
path = [
  {segment = "MC2", point_mm = [10, 9, 0], rides_on = "FDP"},
  {segment = "PP2", point_mm = [-10, 0, 0]},
]
)")
                .find("only the origin of a strand"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
