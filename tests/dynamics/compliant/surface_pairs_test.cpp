// Tests for dynamics/compliant/surface_pairs.cpp.

#include "dynamics/compliant/surface_pairs.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::primitive;

std::vector<SimbodyPair> pairs_of(const MovingScene& scene) {
  return plan_simbody_pairs(scene, tree_model(scene.mechanism));
}

bool share(const std::vector<int>& a, const std::vector<int>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

TEST(SeparatingCliques, LetTheSurfacesOfAPairMeetAndNoOthers) {
  for (const std::size_t pairs : {1, 2, 3, 7, 8, 33}) {
    const std::vector<std::vector<int>> cliques = separating_cliques(pairs);
    ASSERT_EQ(cliques.size(), 2 * pairs);
    for (std::size_t i = 0; i < cliques.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_EQ(share(cliques[i], cliques[j]), i / 2 != j / 2) << i << " and " << j;
  }
}

// The left finger sees the face at x = -25 mm, the right one that at +25 mm.
TEST(SimbodyPairs, BoxesShowTheFaceThatLooksAtTheOther) {
  const sample::Pinch world = sample::pinch({});
  const std::vector<SimbodyPair> pairs = pairs_of(world.scene);
  ASSERT_EQ(pairs.size(), 3);  // the fingers may meet each other, too
  for (const SimbodyPair& pair : pairs) {
    if (pair.b.body != world.cube) continue;
    const double side = pair.a.body == 0 ? -1 : 1;
    EXPECT_EQ(pair.a.kind, SurfaceKind::kBall);
    EXPECT_EQ(pair.b.kind, SurfaceKind::kHalfSpace);
    EXPECT_LT((pair.b.X_BS.R.col(2) - Eigen::Vector3d(side, 0, 0)).norm(), 1e-15);
    EXPECT_LT((pair.b.X_BS.p - Eigen::Vector3d(0.025 * side, 0, 0)).norm(), 1e-15);
    EXPECT_NEAR(pair.b.X_BS.R.determinant(), 1, 1e-15);
    EXPECT_LT((pair.b.extent - Eigen::Vector2d(0.025, 0.025)).norm(), 1e-15);
  }
}

TEST(SimbodyPairs, OfTwoBoxesTheFixedOneIsTheHalfSpace) {
  const sample::Incline world = sample::incline(0.3, 0.5);
  const std::vector<SimbodyPair> pairs = pairs_of(world.scene);
  ASSERT_EQ(pairs.size(), 1);
  EXPECT_EQ(pairs[0].a.body, world.floor);
  EXPECT_EQ(pairs[0].a.kind, SurfaceKind::kHalfSpace);
  EXPECT_LT((pairs[0].a.X_BS.R.col(2) - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_EQ(pairs[0].b.kind, SurfaceKind::kBrick);
  EXPECT_LT((pairs[0].b.size - Eigen::Vector3d(0.025, 0.025, 0.025)).norm(), 1e-15);
}

TEST(SimbodyPairs, RefuseWhatSimbodyDoesNotKnowAndNameIt) {
  MovingScene scene;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1);
  sample::add_body(scene, "pad", primitive(ShapeKind::kCapsule, {0.01, 0.02, 0}), 0.1);
  try {
    (void)pairs_of(scene);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "Simbody has no contacts of 'pad' (capsule): wanted spheres, ellipsoids, boxes or "
                 "meshes");
  }
}

}  // namespace
}  // namespace thenar
