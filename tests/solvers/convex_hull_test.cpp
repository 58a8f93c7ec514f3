// Tests for solvers/convex_hull.cpp.

#include "solvers/convex_hull.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

// The unit cube, and a point in the middle of it and of one side.
MatrixXd cube() {
  MatrixXd points(10, 3);
  for (int i = 0; i < 8; ++i) points.row(i) << (i & 1), (i >> 1 & 1), (i >> 2);
  points.row(8) << 0.5, 0.5, 0.5;
  points.row(9) << 0.5, 0.5, 0;
  return points;
}

TEST(ConvexHull, MergesTheSidesOfACube) {
  const ConvexHull hull = convex_hull(cube());
  EXPECT_EQ(hull.message, "");
  ASSERT_EQ(hull.facets.size(), 6U);
  for (const HullFacet& facet : hull.facets) EXPECT_EQ(facet.ring.size(), 4U);
}

TEST(ConvexHull, RingsRunCounterclockwiseSeenFromOutside) {
  const MatrixXd points = cube();
  for (const HullFacet& facet : convex_hull(points).facets) {
    const Vector3d a = points.row(facet.ring[1]) - points.row(facet.ring[0]);
    const Vector3d b = points.row(facet.ring[2]) - points.row(facet.ring[1]);
    EXPECT_NEAR(a.cross(b).dot(Vector3d(facet.normal)), 1, 1e-12);
  }
}

TEST(ConvexHull, PlanesHoldAllPoints) {
  const MatrixXd points = cube();
  for (const HullFacet& facet : convex_hull(points).facets)
    EXPECT_LE((points * facet.normal).maxCoeff(), facet.offset + 1e-14);
}

// Volume 1 by x, by y and by z; 8 - 12 + 6 = 2.
TEST(ConvexHull, StatesWhatItIsHeldTo) {
  const HullCheck check = convex_hull(cube()).check;
  EXPECT_LE(check.outside, 1e-15);
  EXPECT_TRUE(check.closed);
  EXPECT_NEAR(check.volume, 1, 1e-15);
  EXPECT_LE(check.volume_error, 1e-15);
  const HullCheck square = convex_hull(cube().topLeftCorner(4, 2)).check;
  EXPECT_TRUE(square.closed);
  EXPECT_NEAR(square.volume, 1, 1e-15);
  EXPECT_LE(square.volume_error, 1e-15);
}

// A box of 2 x 3 x 5 with one corner cut off at (1, 1, 1) along the edges: 30 - 1 / 6.
TEST(ConvexHull, VolumeIsThatOfACutBox) {
  MatrixXd points(10, 3);
  for (int i = 1; i < 8; ++i) points.row(i - 1) << 2 * (i & 1), 3 * (i >> 1 & 1), 5 * (i >> 2);
  points.bottomRows<3>().setIdentity();
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.facets.size(), 7U);
  EXPECT_TRUE(hull.check.closed);
  EXPECT_NEAR(hull.check.volume, 30 - 1.0 / 6, 1e-13);
  EXPECT_LE(hull.check.volume_error, 1e-13);
}

TEST(ConvexHull, SquareHasFourEdges) {
  EXPECT_EQ(convex_hull(cube().topLeftCorner(4, 2)).facets.size(), 4U);
}

TEST(ConvexHull, FlatSetIsReportedNotJoggled) {
  const ConvexHull hull = convex_hull(cube().topRows(4));  // the bottom of the cube
  EXPECT_TRUE(hull.facets.empty());
  EXPECT_NE(hull.message.find("QH6154"), std::string::npos) << hull.message;
}

TEST(ConvexHull, RefusesTooFewPoints) {
  EXPECT_THROW((void)convex_hull(cube().topRows(3)), InputError);
}

}  // namespace
}  // namespace thenar
