// Tests for grasp/quality/wrench_set_mesh.cpp.

#include "grasp/quality/wrench_set_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kSolvedPicture = 1e-7;
const std::array<int, 3> kForces{0, 1, 2};

/// Signed: positive if triangles stand counterclockwise seen from outside.
double volume_of(const TriangleMesh& mesh) {
  double volume = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.col(mesh.triangles(k, i));
    volume += corners.determinant() / 6;
  }
  return volume;
}

// Forces of a pinch: the hull of two discs of radius mu at x = +-1, a cylinder. Straight along the
// disc's axes the picture reaches mu, along x 1.
TEST(WrenchSetMesh, ProjectionOfAPinchIsACylinder) {
  const double mu = 0.5;
  const ForceSet forces = unit_forces(pinch(mu, 0), ForceNorm::kL1);
  const WrenchSetMesh picture = wrench_set_mesh(forces, kForces, PictureKind::kProjection, 6);
  EXPECT_EQ(picture.failed, 0);
  EXPECT_EQ(picture.mesh.vertices.cols(), 4 * 6 * 6 + 2);
  for (Eigen::Index i = 0; i < picture.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d v = picture.mesh.vertices.col(i);
    EXPECT_NEAR(std::max(std::abs(v.x()), v.tail<2>().norm() / mu), 1, kSolvedPicture) << i;
  }
  const double cylinder = 2 * M_PI * mu * mu;
  EXPECT_GT(volume_of(picture.mesh), 0.8 * cylinder);
  EXPECT_LT(volume_of(picture.mesh), cylinder);
}

// Without torque both fingers share what goes across: with weights a + b = 1 the force along is
// a - b and each carries at most mu min(a, b): a double cone.
TEST(WrenchSetMesh, SliceWithoutTorqueIsADoubleCone) {
  const double mu = 0.5;
  const ForceSet forces = unit_forces(pinch(mu, 0), ForceNorm::kL1);
  const WrenchSetMesh picture = wrench_set_mesh(forces, kForces, PictureKind::kSlice, 4);
  EXPECT_EQ(picture.failed, 0);
  for (Eigen::Index i = 0; i < picture.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d v = picture.mesh.vertices.col(i);
    EXPECT_NEAR(std::abs(v.x()) + v.tail<2>().norm() / mu, 1, kSolvedPicture) << i;
  }
}

/// Corners of a cube of side 2 pressed along x from both sides.
std::vector<Contact> cube_corners(double mu) {
  std::vector<Contact> contacts;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1}) contacts.push_back({{x, y, z}, {-x, 0, 0}, mu, 0});
  return contacts;
}

// Flush jaws of friction 1: a jaw that presses at (y, z) of its face, 1 from the middle, takes
// friction (f_y, f_z) = (y, z) without turning the cube, however much the other presses. So the
// pinch's double cone grows to the cylinder of all forces: many ways to make each, and none fails.
TEST(WrenchSetMesh, SliceOfFlushJawsIsACylinder) {
  const ForceSet forces =
      unit_forces(wrench_set(cube_corners(1), {0, 0, 0}, std::sqrt(3)), ForceNorm::kL1);
  const WrenchSetMesh picture = wrench_set_mesh(forces, kForces, PictureKind::kSlice, 4);
  EXPECT_EQ(picture.failed, 0);
  for (Eigen::Index i = 0; i < picture.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d v = picture.mesh.vertices.col(i);
    EXPECT_NEAR(std::max(std::abs(v.x()), v.tail<2>().norm()), 1, kSolvedPicture) << i;
  }
}

// Without friction a pinch makes forces along x alone: a segment, and no torque at all.
TEST(WrenchSetMesh, OfAFlatSetIsFlat) {
  const ForceSet forces = unit_forces(pinch(0, 0), ForceNorm::kL1);
  for (const PictureKind kind : {PictureKind::kProjection, PictureKind::kSlice}) {
    const WrenchSetMesh picture = wrench_set_mesh(forces, kForces, kind, 2);
    EXPECT_EQ(picture.failed, 0);
    EXPECT_NEAR(picture.mesh.vertices.row(0).maxCoeff(), 1, kSolvedPicture);
    EXPECT_NEAR(picture.mesh.vertices.row(0).minCoeff(), -1, kSolvedPicture);
    EXPECT_NEAR(picture.mesh.vertices.bottomRows(2).cwiseAbs().maxCoeff(), 0, kSolvedPicture);
    const WrenchSetMesh torques = wrench_set_mesh(forces, {3, 4, 5}, kind, 2);
    EXPECT_EQ(torques.failed, 0);
    EXPECT_NEAR(torques.mesh.vertices.cwiseAbs().maxCoeff(), 0, kSolvedPicture);
  }
}

// One finger presses off the middle: its forces come with torque, so without torque there is none.
TEST(WrenchSetMesh, SliceThroughARimIsThePointZero) {
  const ForceSet forces =
      unit_forces(wrench_set({{{0, 0, 1}, {0, 1, 0}, 0, 0}}, {0, 0, 0}, 1), ForceNorm::kL1);
  const WrenchSetMesh picture = wrench_set_mesh(forces, kForces, PictureKind::kSlice, 2);
  EXPECT_EQ(picture.failed, 0);
  EXPECT_NEAR(picture.mesh.vertices.cwiseAbs().maxCoeff(), 0, kSolvedPicture);
}

TEST(WrenchSetMesh, SaysWhereASetHasNoEnd) {
  const WrenchSetMesh picture =
      wrench_set_mesh(free_forces(pinch(0.5, 0)), kForces, PictureKind::kProjection, 1);
  EXPECT_EQ(picture.failed, 6);
}

TEST(WrenchSetMesh, RefusesACoordinateTwice) {
  EXPECT_EQ(message_of([] {
              (void)wrench_set_mesh(free_forces({}), {0, 1, 1}, PictureKind::kSlice);
            }),
            "wanted three different coordinates of 0..5, got 0, 1, 1");
}

}  // namespace
}  // namespace thenar
