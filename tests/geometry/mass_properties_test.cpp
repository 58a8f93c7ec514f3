// Tests for geometry/mass_properties.cpp.

#include "geometry/mass_properties.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/primitives.h"
#include "geometry/tessellate.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// m (b^2 + c^2) / 12 and so on, wherever the box stands.
TEST(MassProperties, OfABoxAreItsFormula) {
  TriangleMesh box = box_mesh({0.1, 0.2, 0.3});
  box.vertices.colwise() += Vector3d(1, 2, 3);
  const MassProperties found = mass_properties(box, 1000);
  EXPECT_NEAR(found.mass, 6, 1e-12);
  EXPECT_TRUE(matrix_near(found.centre, Vector3d(1, 2, 3), 1e-14));
  EXPECT_TRUE(
      matrix_near(found.inertia, Vector3d(0.5 * 0.13, 0.5 * 0.10, 0.5 * 0.05).asDiagonal(), 1e-13));
}

// Of the tetrahedron with unit legs: volume 1/6, centre 1/4, and about its centre
// integral of x^2 = 1/60 - 1/96 = 1/160, of x y = 1/120 - 1/96 = -1/480.
TEST(MassProperties, OfATetrahedronAreItsFormula) {
  TriangleMesh corner{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xi(3, 4)};
  corner.vertices.rightCols(3).setIdentity();
  corner.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  const MassProperties found = mass_properties(corner, 1);
  EXPECT_NEAR(found.mass, 1.0 / 6, 1e-15);
  EXPECT_TRUE(matrix_near(found.centre, Vector3d::Constant(0.25), 1e-15));
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Constant(1.0 / 480);
  inertia.diagonal().setConstant(2.0 / 160);
  EXPECT_TRUE(matrix_near(found.inertia, inertia, 1e-15));
}

// Of a ball 2/5 m r^2, as fine as its triangles are.
TEST(MassProperties, OfABallTendToItsFormula) {
  const MassProperties found = mass_properties(tessellate(*build_sphere(0.02), 1e-5), 1000);
  const double mass = 4 * kPi / 3 * 8e-6 * 1000;
  EXPECT_NEAR(found.mass / mass, 1, 1e-3);
  EXPECT_NEAR(found.inertia(0, 0) / (0.4 * mass * 4e-4), 1, 2e-3);
}

TEST(MassProperties, RefuseALeakyMesh) {
  TriangleMesh open = box_mesh({0.02, 0.02, 0.02});
  open.triangles = Eigen::Matrix3Xi(open.triangles.leftCols(11));
  EXPECT_EQ(message_of([&] { (void)mass_properties(open, 1000); }).substr(0, 31),
            "a mesh bounds no solid: 1 hole(");
}

}  // namespace
}  // namespace thenar
