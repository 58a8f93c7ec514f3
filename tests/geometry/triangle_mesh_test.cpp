// Tests for geometry/triangle_mesh.cpp: sides and neighbours of small meshes by hand.

#include "geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include "geometry/tessellate.h"

namespace thenar {
namespace {

/// Two triangles of a square 0 1 2 3, which share the edge 0 2.
TriangleMesh split_square() {
  TriangleMesh mesh{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xi(3, 2)};
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

TEST(TriangleMesh, ListsSidesByEdge) {
  const std::vector<MeshSide> sides = sides_by_edge(split_square());
  // Edges 01, 02 (twice), 03, 12, 23.
  const int low[] = {0, 0, 0, 0, 1, 2}, high[] = {1, 2, 2, 3, 2, 3};
  const int triangle[] = {0, 0, 1, 1, 0, 1}, side[] = {0, 2, 0, 2, 1, 1};
  const bool upwards[] = {true, false, true, false, true, true};
  ASSERT_EQ(sides.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(sides[i].low, low[i]) << i;
    EXPECT_EQ(sides[i].high, high[i]) << i;
    EXPECT_EQ(sides[i].triangle, triangle[i]) << i;
    EXPECT_EQ(sides[i].side, side[i]) << i;
    EXPECT_EQ(sides[i].upwards, upwards[i]) << i;
  }
}

TEST(TriangleMesh, FindsNeighboursAcrossCommonSides) {
  const Eigen::Matrix3Xi across = neighbours_across(split_square());
  EXPECT_EQ(across.col(0), Eigen::Vector3i(-1, -1, 1));
  EXPECT_EQ(across.col(1), Eigen::Vector3i(0, -1, -1));
}

// An edge of three triangles has no neighbours across it.
TEST(TriangleMesh, HasNoNeighbourWhereThreeMeet) {
  TriangleMesh fan{Eigen::Matrix3Xd::Zero(3, 5), Eigen::Matrix3Xi(3, 3)};
  fan.triangles << 0, 0, 0, 1, 1, 1, 2, 3, 4;
  EXPECT_EQ(neighbours_across(fan), Eigen::Matrix3Xi::Constant(3, 3, -1));
}

// Of a closed surface: being a neighbour is mutual, each edge has two sides that go opposite ways,
// and there are half as many edges again as triangles.
TEST(TriangleMesh, ClosedSurfacesHaveTwoSidesAnEdge) {
  const TriangleMesh box = box_mesh({1, 2, 3});
  int edges = 0;
  for_each_edge(sides_by_edge(box), [&](const MeshSide* first, const MeshSide* last) {
    ++edges;
    ASSERT_EQ(last - first, 2);
    EXPECT_NE(first[0].upwards, first[1].upwards);
  });
  EXPECT_EQ(edges, 18);
  const Eigen::Matrix3Xi across = neighbours_across(box);
  for (Eigen::Index t = 0; t < 12; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE((across.col(across(k, t)).array() == static_cast<int>(t)).any());
}

}  // namespace
}  // namespace thenar
