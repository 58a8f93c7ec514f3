// Tests for geometry/triangle_tree.cpp: the nearest triangle against a look at all of them.

#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/geometry/random_points.h"
#include "tests/geometry/sample_meshes.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

FootPoint foot_of(const TriangleForm& form, const Vector3d& p) {
  FootPoint foot;
  EXPECT_TRUE(form.find_foot(p, 1e300, foot));
  return foot;
}

// A right triangle in the plane z = 0: over its face, beside its edges, beyond its corners.
TEST(TriangleTree, FootIsOnFaceEdgeOrCorner) {
  const TriangleForm form = TriangleForm::from_corners({0, 0, 0}, {4, 0, 0}, {0, 3, 0});
  const FootPoint face = foot_of(form, {1, 1, -2});
  EXPECT_EQ(face.feature.kind, Feature::kFace);
  EXPECT_DOUBLE_EQ(face.squared, 4);
  const FootPoint edge = foot_of(form, {1, -3, 4});
  EXPECT_EQ(edge.feature.kind, Feature::kEdge);
  EXPECT_EQ(edge.feature.k, 0);
  EXPECT_DOUBLE_EQ(edge.squared, 25);
  EXPECT_LT((edge.point - Vector3d(1, 0, 0)).norm(), 1e-15);
  const FootPoint corner = foot_of(form, {6, -1, 2});
  EXPECT_EQ(corner.feature.kind, Feature::kCorner);
  EXPECT_EQ(corner.feature.k, 1);
  EXPECT_DOUBLE_EQ(corner.squared, 9);
  // Beside the slanting edge: its line is 3 x + 4 y = 12.
  EXPECT_NEAR(foot_of(form, {3, 3, 0}).squared, 81.0 / 25, 1e-14);
}

TEST(TriangleTree, ALimitHidesWhatIsFarther) {
  const TriangleForm form = TriangleForm::from_corners({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  FootPoint foot;
  EXPECT_FALSE(form.find_foot({0.2, 0.2, 1}, 0.99, foot));
  EXPECT_TRUE(form.find_foot({0.2, 0.2, 1}, 1.01, foot));
}

// Every triangle is in one leaf, within the boxes of all nodes above.
TEST(TriangleTree, OrdersEachTriangleOnce) {
  const TriangleTree tree(handled_mug(0.01));
  std::vector<int> order = tree.order();
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], static_cast<int>(i));
  int held = 0;
  for (const TriangleTree::Node& node : tree.nodes()) {
    held += node.count;
    for (int i = node.first; i < node.first + node.count; ++i)
      for (const Vector3d& corner : tree.forms()[static_cast<std::size_t>(i)].corner)
        EXPECT_TRUE(node.box.contains(corner));
  }
  EXPECT_EQ(held, static_cast<int>(order.size()));
}

// The same triangle at the same distance as a look at all, whatever the first guess was.
TEST(TriangleTree, FindsTheNearestOfAll) {
  std::mt19937 rng(2);
  for (const TriangleMesh& mesh : {mug(), thin_plate(), ring()}) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 100; ++i) {
      const Vector3d p = 0.08 * random_in_cube(rng);
      NearestTriangle best;
      for (int k = 0; k < static_cast<int>(tree.forms().size()); ++k)
        tree.update_nearest(k, p, best);
      double least = 1e300;
      for (const TriangleForm& form : tree.forms())
        least = std::min(least, foot_of(form, p).squared);
      EXPECT_EQ(best.foot.squared, least);
      const NearestTriangle found = tree.nearest(p, {});
      EXPECT_EQ(found.triangle, best.triangle);
      EXPECT_EQ(found.foot.squared, best.foot.squared);
      NearestTriangle guess;
      tree.update_nearest(static_cast<int>(rng() % tree.forms().size()), p, guess);
      EXPECT_EQ(tree.nearest(p, guess).triangle, best.triangle);
    }
  }
}

}  // namespace
}  // namespace thenar::internal
