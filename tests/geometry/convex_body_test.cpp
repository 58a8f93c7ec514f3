// Tests for geometry/convex_body.cpp: cuts and unions of boxes, whose moments are known.

#include "geometry/convex_body.h"

#include <vector>

#include <gtest/gtest.h>

#include "geometry/tessellate.h"
#include "tests/geometry/random_points.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kCutTolerance = 1e-9;  // [m]
constexpr double kMomentRounding = 1e-12;

ConvexBody box_of(const Vector3d& low, const Vector3d& high) {
  return convex_box(AlignedBox3d(low, high));
}

// Of a box from 0 to (a, b, c): V, V / 2 (a, b, c), and V (a^2 / 3, a b / 4, ..).
TEST(ConvexBody, MomentsOfABoxAtTheOrigin) {
  const Vector3d e(2, 3, 5);
  const Moments moments = moments_of(box_of(Vector3d::Zero(), e));
  EXPECT_NEAR(moments.volume, 30, kMomentRounding);
  EXPECT_TRUE(matrix_near(moments.first, 15 * e, 1e-11));
  Eigen::Matrix3d second = 30.0 / 4 * e * e.transpose();
  second.diagonal() = 30.0 / 3 * e.cwiseAbs2();
  EXPECT_TRUE(matrix_near(moments.second, second, 1e-10));
}

// A corner of the unit cube below x + y + z = 1 is a tetrahedron of 1/6; what is left is 5/6.
TEST(ConvexBody, CutsOffACorner) {
  ConvexBody corner = box_of(Vector3d::Zero(), Vector3d::Ones()), rest = corner;
  const HalfSpace side{Vector3d::Ones().normalized(), 1 / std::sqrt(3.0)};
  clip(corner, side, kCutTolerance);
  clip(rest, {-side.n, -side.offset}, kCutTolerance);
  EXPECT_EQ(corner.faces.size(), 4U);
  EXPECT_NEAR(moments_of(corner).volume, 1.0 / 6, kMomentRounding);
  EXPECT_NEAR(moments_of(rest).volume, 5.0 / 6, kMomentRounding);
  EXPECT_TRUE(matrix_near(moments_of(corner).first, Vector3d::Constant(1.0 / 24), 1e-13));
}

TEST(ConvexBody, CutsThatMissLeaveAllOrNothing) {
  ConvexBody body = box_of(Vector3d::Zero(), Vector3d::Ones());
  clip(body, {Vector3d::UnitX(), 1 - 0.5 * kCutTolerance}, kCutTolerance);  // less than so high
  EXPECT_NEAR(moments_of(body).volume, 1, kMomentRounding);
  clip(body, {Vector3d::UnitX(), -1}, kCutTolerance);
  EXPECT_TRUE(body.empty());
}

TEST(ConvexBody, IntersectionOfBoxesIsABox) {
  const ConvexBody both =
      intersection(box_of({0, 0, 0}, {2, 2, 2}), box_of({1, -1, 0.5}, {3, 1.5, 9}), kCutTolerance);
  EXPECT_NEAR(moments_of(both).volume, 1 * 1.5 * 1.5, kMomentRounding);
  EXPECT_TRUE(
      intersection(box_of({0, 0, 0}, {1, 1, 1}), box_of({2, 0, 0}, {3, 1, 1}), kCutTolerance)
          .empty());
}

// A convex mesh is its body; a mesh with a dent is none.
TEST(ConvexBody, OfAMeshNeedsItConvex) {
  EXPECT_NEAR(moments_of(convex_body(box_mesh({1, 2, 3}))).volume, 6, kMomentRounding);
  EXPECT_TRUE(
      convex_body(surface_of_revolution({{0, 0}, {1, 0}, {0.5, 1}, {1, 2}, {0, 2}}, 8)).empty());
}

// Moments become mass properties and back.
TEST(ConvexBody, MomentsAreMassPropertiesAboutTheOrigin) {
  const Moments moments = moments_of(box_of({1, 2, 3}, {2, 4, 6}));
  const MassProperties mass = mass_of(moments);
  EXPECT_NEAR(mass.mass, 6, kMomentRounding);
  EXPECT_TRUE(matrix_near(mass.centre, Vector3d(1.5, 3, 4.5), kMomentRounding));
  // m / 12 (b^2 + c^2) and so on.
  const Eigen::Matrix3d inertia = Vector3d(4 + 9, 1 + 9, 1 + 4).asDiagonal();
  EXPECT_TRUE(matrix_near(mass.inertia, 0.5 * inertia, 1e-11));
  EXPECT_TRUE(matrix_near(moments_of(mass).second, moments.second, 1e-10));
}

// Inclusion and exclusion of boxes by a count of the cells of a grid that they are drawn on.
TEST(ConvexBody, UnionOfBoxesCountsEachCellOnce) {
  std::mt19937 rng(5);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<ConvexBody> bodies;
    bool filled[6][6][6] = {};
    for (int k = 0; k < 5; ++k) {
      Eigen::Vector3i low, high;
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<int>(rng() % 4);
        high[axis] = low[axis] + 1 + static_cast<int>(rng() % 2);
      }
      bodies.push_back(box_of(low.cast<double>(), high.cast<double>()));
      for (int x = low[0]; x < high[0]; ++x)
        for (int y = low[1]; y < high[1]; ++y)
          for (int z = low[2]; z < high[2]; ++z) filled[x][y][z] = true;
    }
    int count = 0;
    Vector3d first(0, 0, 0);
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 6; ++y)
        for (int z = 0; z < 6; ++z)
          if (filled[x][y][z]) {
            ++count;
            first += Vector3d(x + 0.5, y + 0.5, z + 0.5);
          }
    const UnionMoments found = union_moments(bodies, kCutTolerance, 1e6);
    ASSERT_TRUE(found.complete);
    EXPECT_NEAR(found.moments.volume, count, 1e-10) << trial;
    EXPECT_TRUE(matrix_near(found.moments.first, first, 1e-9)) << trial;
  }
}

TEST(ConvexBody, UnionGivesUpBeyondItsWork) {
  const std::vector<ConvexBody> bodies{box_of({0, 0, 0}, {2, 2, 2}), box_of({1, 1, 1}, {3, 3, 3}),
                                       box_of({0, 1, 0}, {3, 2, 3})};
  EXPECT_FALSE(union_moments(bodies, kCutTolerance, 1).complete);
}

}  // namespace
}  // namespace thenar
