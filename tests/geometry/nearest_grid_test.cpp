// Tests for geometry/nearest_grid.cpp: cubes find what the tree finds, however often they are
// asked.

#include "geometry/nearest_grid.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/geometry/random_points.h"
#include "tests/geometry/sample_meshes.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

/// Expects the tree's own answer at points that are asked again and again, so that cubes fill.
void expect_the_trees_answers(const TriangleMesh& mesh, double extent, double share) {
  const TriangleTree tree(mesh);
  const NearestGrid grid(tree, share);
  std::mt19937 rng(6);
  std::vector<Vector3d> points;
  for (int i = 0; i < 60; ++i) points.push_back(extent * random_in_cube(rng));
  for (int round = 0; round < 40; ++round)
    for (const Vector3d& p : points) {
      const Vector3d near = p + 1e-4 * extent * random_in_cube(rng);
      const NearestTriangle wanted = tree.nearest(near, {}), found = grid.nearest(near, tree);
      ASSERT_EQ(found.triangle, wanted.triangle) << round << ": " << near.transpose();
      ASSERT_EQ(found.foot.squared, wanted.foot.squared);
      ASSERT_EQ(found.foot.point, wanted.foot.point);
    }
}

TEST(NearestGrid, AnswersAsTheTreeNearTheSurface) {
  expect_the_trees_answers(mug(), 0.06, 0.3);
  expect_the_trees_answers(thin_plate(), 0.06, 0.3);
}

TEST(NearestGrid, AnswersAsTheTreeFarOff) { expect_the_trees_answers(ring(), 2, 0.3); }

TEST(NearestGrid, AnswersAsTheTreeInLargeCubes) { expect_the_trees_answers(mug(), 0.3, 2); }

// Points of the surface itself, its corners among them, are at distance 0.
TEST(NearestGrid, FindsPointsOfTheSurface) {
  const TriangleMesh mesh = ring();
  const TriangleTree tree(mesh);
  const NearestGrid grid(tree);
  for (int round = 0; round < 20; ++round)
    for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
      EXPECT_LT(grid.nearest(mesh.vertices.col(i), tree).foot.squared, 1e-32);
}

}  // namespace
}  // namespace thenar::internal
