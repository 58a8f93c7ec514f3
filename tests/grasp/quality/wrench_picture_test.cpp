// Tests for grasp/quality/wrench_picture.cpp.

#include "grasp/quality/wrench_picture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kSolved = 1e-7;
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
TEST(WrenchPicture, ProjectionOfAPinchIsACylinder) {
  const double mu = 0.5;
  const ForceSet forces = unit_forces(pinch(mu, 0), ForceLimit::kL1);
  const WrenchPicture picture = wrench_picture(forces, kForces, PictureKind::kProjection, 6);
  EXPECT_EQ(picture.failed, 0);
  EXPECT_EQ(picture.mesh.vertices.cols(), 4 * 6 * 6 + 2);
  for (Eigen::Index i = 0; i < picture.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d v = picture.mesh.vertices.col(i);
    EXPECT_NEAR(std::max(std::abs(v.x()), v.tail<2>().norm() / mu), 1, kSolved) << i;
  }
  const double cylinder = 2 * M_PI * mu * mu;
  EXPECT_GT(volume_of(picture.mesh), 0.8 * cylinder);
  EXPECT_LT(volume_of(picture.mesh), cylinder);
}

// Without torque both fingers share what goes across: with weights a + b = 1 the force along is
// a - b and each carries at most mu min(a, b): a double cone.
TEST(WrenchPicture, SliceWithoutTorqueIsADoubleCone) {
  const double mu = 0.5;
  const ForceSet forces = unit_forces(pinch(mu, 0), ForceLimit::kL1);
  const WrenchPicture picture = wrench_picture(forces, kForces, PictureKind::kSlice, 4);
  EXPECT_EQ(picture.failed, 0);
  for (Eigen::Index i = 0; i < picture.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d v = picture.mesh.vertices.col(i);
    EXPECT_NEAR(std::abs(v.x()) + v.tail<2>().norm() / mu, 1, kSolved) << i;
  }
}

TEST(WrenchPicture, SaysWhereASetHasNoEnd) {
  const WrenchPicture picture =
      wrench_picture(free_forces(pinch(0.5, 0)), kForces, PictureKind::kProjection, 1);
  EXPECT_EQ(picture.failed, 6);
}

TEST(WrenchPicture, RefusesACoordinateTwice) {
  EXPECT_EQ(message_of([] {
              (void)wrench_picture(free_forces({}), {0, 1, 1}, PictureKind::kSlice);
            }),
            "wanted three different coordinates of 0..5, got 0, 1, 1");
}

}  // namespace
}  // namespace thenar
