// Tests for tendons/convex_hull.cpp.

#include "tendons/convex_hull.h"

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
  for (int i = 0; i < 8; ++i) points.row(i) << i % 2, i / 2 % 2, i / 4;
  points.row(8) << 0.5, 0.5, 0.5;
  points.row(9) << 0.5, 0.5, 0;
  return points;
}

TEST(ConvexHull, MergesTheSidesOfACube) {
  const ConvexHull hull = convex_hull(cube());
  EXPECT_EQ(hull.failure, "");
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

TEST(ConvexHull, SquareHasFourEdges) {
  EXPECT_EQ(convex_hull(cube().topLeftCorner(4, 2)).facets.size(), 4U);
}

TEST(ConvexHull, FlatSetIsReportedNotJoggled) {
  const ConvexHull hull = convex_hull(cube().topRows(4));  // the bottom of the cube
  EXPECT_TRUE(hull.facets.empty());
  EXPECT_NE(hull.failure.find("QH6154"), std::string::npos) << hull.failure;
}

TEST(ConvexHull, RefusesTooFewPoints) {
  EXPECT_THROW((void)convex_hull(cube().topRows(3)), InputError);
}

}  // namespace
}  // namespace thenar
