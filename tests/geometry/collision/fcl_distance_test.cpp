// FCL and signed_distance() must agree on meshes that are apart.

#include "tests/geometry/collision/fcl_distance.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/collision/signed_distance.h"
#include "geometry/mesh_distance.h"
#include "geometry/tessellate.h"
#include "tests/geometry/collision/drawn.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// A convex block, or a cup open at the top, of a size of its own.
TriangleMesh drawn_mesh(std::mt19937& rng, bool concave) {
  if (!concave) return box_mesh(Eigen::Vector3d::Constant(0.06) + drawn_point(rng, 0.04));
  const double r = 0.03 * (1.5 + drawn(rng)), h = 0.06 * (1.5 + drawn(rng)), wall = 0.2 * r;
  return surface_of_revolution({{0, 0}, {r, 0}, {r, h}, {r - wall, h}, {r - wall, wall}, {0, wall}},
                               24);
}

/// A mesh in all the forms it is asked in.
struct SolidPair {
  FclMesh fcl;
  CollisionTree touch;
  Solid solid;
};

SolidPair drawn_subject(std::mt19937& rng, bool concave) {
  const TriangleMesh mesh = drawn_mesh(rng, concave);
  return {FclMesh(mesh),
          collision_tree({nullptr, {{mesh, 0}}, {}}),
          {build_mesh_distance(mesh), {}, {}}};
}

class FclAgrees : public testing::TestWithParam<bool> {
 protected:
  FclAgrees() {
    for (int i = 0; i < 6; ++i) subjects_.push_back(drawn_subject(rng_, GetParam() && i % 3 > 0));
  }
  const SolidPair& any() { return subjects_[rng_() % subjects_.size()]; }

  std::mt19937 rng_{4};
  std::vector<SolidPair> subjects_;
};

// Wherever one surface is outside the other body, its distance is that of the surfaces.
TEST_P(FclAgrees, OnRandomPairsApart) {
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const SolidPair &a = any(), &b = any();
    const Pose<double> X_WA = drawn_pose(rng_, 0.1), X_WB = drawn_pose(rng_, 0.1);
    const SignedDistance s = signed_distance(a.touch, X_WA, b.solid, X_WB);
    if (s.distance < 1e-4) continue;
    ++apart;
    ASSERT_NEAR(fcl_distance(a.fcl, X_WA, b.fcl, X_WB), s.distance, s.error + 1e-9) << "pair " << i;
    ASSERT_FALSE(fcl_collide(a.fcl, X_WA, b.fcl, X_WB)) << "pair " << i;
  }
  EXPECT_GT(apart, 100);
}

// Surfaces that cross: both say so.
TEST_P(FclAgrees, OnSurfacesThatCross) {
  int crossing = 0;
  for (int i = 0; i < 200; ++i) {
    const SolidPair &a = any(), &b = any();
    const Pose<double> X_WA = drawn_pose(rng_, 0.04), X_WB = drawn_pose(rng_, 0.04);
    if (!fcl_collide(a.fcl, X_WA, b.fcl, X_WB)) continue;
    ++crossing;
    const SignedDistance s = signed_distance(a.touch, X_WA, b.solid, X_WB);
    ASSERT_LT(s.distance, s.error) << "pair " << i;
    ASSERT_EQ(fcl_distance(a.fcl, X_WA, b.fcl, X_WB), 0) << "pair " << i;
  }
  EXPECT_GT(crossing, 50);
}

INSTANTIATE_TEST_SUITE_P(ConvexAndConcave, FclAgrees, testing::Bool());

TEST(FclMesh, RejectsAnEmptyMesh) {
  EXPECT_EQ(message_of([] { (void)FclMesh(TriangleMesh{}); }),
            "a mesh for FCL must have finite vertices and triangles, got 0 of these");
}

}  // namespace
}  // namespace thenar
