// Tests for geometry/manifold/polyhedron_contact.cpp.

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "geometry/collision/signed_distance.h"
#include "geometry/manifold/collision_pair.h"
#include "geometry/tessellate.h"
#include "tests/data_folder.h"
#include "tests/geometry/collision/drawn.h"
#include "tests/geometry/manifold/manifold_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

SampleBody mesh_body(const TriangleMesh& mesh) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = mesh;
  return SampleBody(std::vector<ShapeSpec>{spec});
}

TriangleMesh ball_mesh(double radius, int rings, int sides) {
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= rings; ++i) {
    const double up = kPi * (static_cast<double>(i) / rings - 0.5);
    profile.emplace_back(radius * std::cos(up), radius * std::sin(up));
  }
  profile.front().x() = profile.back().x() = 0;
  return surface_of_revolution(profile, sides);
}

TriangleMesh mug_mesh() { return read_mesh(kData + "/objects/mug.obj", 0.001); }

/// Both ways: the lesser of the distances of A's points from B and of B's from A.
double distance_both_ways(const SampleBody& a, const Pose<double>& X_WA, const SampleBody& b,
                          const Pose<double>& X_WB) {
  SignedDistanceOptions options;
  options.tolerance = 1e-9;
  return std::min(signed_distance(collision_tree(a.solid), X_WA, b.solid, X_WB, options).distance,
                  signed_distance(collision_tree(b.solid), X_WB, a.solid, X_WA, options).distance);
}

/// A pose of A at which the bodies are `gap` apart, coming from somewhere; the identity for B.
Pose<double> approached(const SampleBody& a, const SampleBody& b, std::mt19937& rng, double gap) {
  Pose<double> X = drawn_pose(rng, 0);
  const Eigen::Vector3d from = drawn_point(rng, 1).normalized();
  SignedDistanceOptions options;
  options.tolerance = 1e-9;
  const CollisionTree tree = collision_tree(a.solid);
  X.p = 0.3 * from;
  for (int i = 0; i < 300; ++i) {
    const double d = signed_distance(tree, X, b.solid, {}, options).distance - gap;
    if (std::abs(d) < 1e-9) break;
    X.p -= d * from;
  }
  return X;
}

// Apart, the least gap is the distance of the surfaces.
TEST(MeshContact, LeastGapIsTheDistanceOfMeshes) {
  const SampleBody ball = mesh_body(ball_mesh(0.01, 10, 14)), mug = mesh_body(mug_mesh());
  const SampleBody capsule(ShapeKind::kCapsule, {0.008, 0.03, 0});
  const SampleBody tapered(ShapeKind::kTaperedCapsule, {0.009, 0.005, 0.03});
  const SampleBody box(ShapeKind::kBox, {0.04, 0.02, 0.03});
  std::mt19937 rng(1);
  int apart = 0;
  for (int i = 0; i < 400; ++i) {
    const SampleBody& a = *std::array{&ball, &capsule, &box, &ball, &tapered}[i % 5];
    const SampleBody& b = i % 5 == 3 ? ball : mug;
    const Pose<double> X = approached(a, b, rng, 4e-4);
    // Tapered capsules are tessellated as A.
    const double exact =
        i % 5 == 4 ? signed_distance(collision_tree(b.solid), {}, a.solid, X, {1e-9}).distance
                   : distance_both_ways(a, X, b, {});
    if (exact < 1e-5 || exact > 9e-4) continue;
    ++apart;
    CollisionPair pair(a.body, b.body);
    const ContactManifold& manifold = pair.update(X, {}, 1e-3);
    ASSERT_FALSE(manifold.empty()) << i;
    ASSERT_NEAR(least_gap(manifold), exact, 1e-8) << i;
    CollisionPair other(b.body, a.body);
    ASSERT_NEAR(least_gap(other.update({}, X, 1e-3)), exact, 1e-8) << i;
  }
  EXPECT_GT(apart, 300);
}

// Overlapping: as deep as the deepest point of either.
TEST(MeshContact, DeepestPointIsThatOfTheSignedDistance) {
  const SampleBody ball = mesh_body(ball_mesh(0.01, 10, 14)), mug = mesh_body(mug_mesh());
  const SampleBody block = mesh_body(box_mesh({0.03, 0.02, 0.01}));
  std::mt19937 rng(2);
  for (int i = 0; i < 100; ++i) {
    const SampleBody& a = i % 2 == 0 ? ball : block;
    const Pose<double> X = approached(a, mug, rng, -3e-4);
    CollisionPair pair(a.body, mug.body);
    const double least = least_gap(pair.update(X, {}, 1e-4));
    const double exact = distance_both_ways(a, X, mug, {});
    // Edges that cross go deeper, seen along their common normal, than corners see.
    ASSERT_LE(least, exact + 1e-8) << i;
    ASSERT_GE(least, 2 * exact - 1e-4) << i;
  }
}

// A finger inside of the cavity touches nothing, and the wall where it is near.
TEST(MeshContact, FingerInTheCavityOfTheMugIsNotPenetrating) {
  const SampleBody finger(ShapeKind::kCapsule, {0.008, 0.03, 0}), mug = mesh_body(mug_mesh());
  const SampleBody skin = mesh_body(ball_mesh(0.008, 10, 14));
  const double inner = 0.037;  // of the cavity [m]
  for (const SampleBody* a : {&finger, &skin}) {
    CollisionPair pair(a->body, mug.body);
    EXPECT_TRUE(pair.update(placed(0, 0, 0.06), {}, 1e-3).empty());
    const ContactManifold& manifold = pair.update(placed(-inner + 0.008 + 3e-4, 0, 0.06), {}, 1e-3);
    ASSERT_FALSE(manifold.empty());
    for (const ManifoldPoint& point : manifold) {
      EXPECT_GT(point.gap, 0);
      EXPECT_GT(point.normal.x(), 0.8);
    }
  }
}

// A ball in the corner of the cavity touches the wall and the floor.
TEST(MeshContact, BallInACornerTouchesBothSides) {
  const SampleBody ball(ShapeKind::kSphere, {0.01, 0, 0});
  const SampleBody corner(std::vector<ShapeSpec>{[] {
    // A box with a box cut out, as a mesh of revolution: an open can.
    ShapeSpec spec;
    spec.kind = ShapeKind::kMesh;
    spec.mesh = surface_of_revolution(
        {{0, 0}, {0.05, 0}, {0.05, 0.06}, {0.04, 0.06}, {0.04, 0.01}, {0, 0.01}}, 40);
    return spec;
  }()});
  CollisionPair pair(ball.body, corner.body);
  const double apothem = 0.04 * std::cos(kPi / 40);
  const Eigen::Vector3d out(std::cos(kPi / 40), std::sin(kPi / 40), 0);
  Pose<double> X;
  X.p = (apothem - 0.01 + 1e-5) * out + Eigen::Vector3d(0, 0, 0.02 - 2e-5);
  const ContactManifold& manifold = pair.update(X, {}, 1e-4);
  ASSERT_EQ(manifold.count, 2);
  std::set<long> depths;
  for (const ManifoldPoint& point : manifold) depths.insert(std::lround(point.gap * 1e9));
  EXPECT_EQ(depths, (std::set<long>{-20000, -10000}));
}

// A box of triangles on a box of triangles crosses it in four points, as boxes do.
TEST(MeshContact, CrossedPlanksOfTrianglesTouchWhereTheirEdgesCross) {
  const SampleBody plank = mesh_body(box_mesh({0.2, 0.02, 0.01}));
  CollisionPair pair(plank.body, plank.body);
  const Pose<double> turned{rotation_about<double>(Eigen::Vector3d::UnitZ(), kPi / 2),
                            {0, 0, 0.0099}};
  const ContactManifold& manifold = pair.update(turned, {}, 1e-4);
  ASSERT_EQ(manifold.count, 4);
  for (const ManifoldPoint& point : manifold) {
    EXPECT_NEAR(point.gap, -1e-4, 1e-15);
    EXPECT_NEAR(std::abs(point.on_a.x()), 0.01, 1e-12);
    EXPECT_NEAR(std::abs(point.on_a.y()), 0.01, 1e-12);
    EXPECT_TRUE(matrix_near(point.normal, Eigen::Vector3d::UnitZ(), 1e-12));
  }
}

// A small body wholly within a solid one, far from its surface.
TEST(MeshContact, BodyWithinAnotherIsDeep) {
  const SampleBody small = mesh_body(ball_mesh(0.004, 8, 12)),
                   large = mesh_body(box_mesh({0.1, 0.1, 0.1}));
  CollisionPair pair(small.body, large.body), other(large.body, small.body);
  const double least = least_gap(pair.update(placed(0, 0, 0.03), {}, 1e-4));
  EXPECT_NEAR(least, -0.024, 1e-3);
  EXPECT_NEAR(least_gap(other.update({}, placed(0, 0, 0.03), 1e-4)), least, 1e-12);
}

// The mug stands on a table by its rim: six points around it, of its lowest face.
TEST(MeshContact, MugStandsOnItsRim) {
  const SampleBody mug = mesh_body(mug_mesh()), table(ShapeKind::kBox, {0.6, 0.4, 0.02});
  CollisionPair pair(mug.body, table.body);
  const double low = mug.body->box.min().z();
  const ContactManifold& manifold = pair.update(placed(0, 0, 0.01 - low), {}, 1e-4);
  EXPECT_EQ(manifold.count, 6);
  Eigen::Vector3d mean(0, 0, 0);
  for (const ManifoldPoint& point : manifold) {
    EXPECT_NEAR(point.gap, 0, 1e-9);
    mean += point.on_b / manifold.count;
  }
  EXPECT_LT(mean.norm(), 0.02);
}

// Along a way at shallow depth gaps are those of a pair without memory, which may prefer another
// point by 1 um.
TEST(MeshContact, MemoryDoesNotChangeGaps) {
  const SampleBody ball = mesh_body(ball_mesh(0.01, 10, 14)), mug = mesh_body(mug_mesh());
  const SampleBody capsule(ShapeKind::kCapsule, {0.008, 0.03, 0});
  for (const SampleBody* a : {&ball, &capsule}) {
    CollisionPair pair(a->body, mug.body);
    for (int i = 0; i < 2000; ++i) {
      const double angle = 0.002 * i, off = 0.0505 + 0.001 * std::sin(0.01 * i);
      const Pose<double> X{rotation_about<double>(Eigen::Vector3d(1, 2, 2) / 3, 0.003 * i),
                           {-off * std::cos(angle), off * std::sin(angle), 0.05}};
      const double least = least_gap(pair.update(X, {}, 5e-4));
      CollisionPair fresh(a->body, mug.body);
      ASSERT_NEAR(least, least_gap(fresh.update(X, {}, 5e-4)), 1.01e-6) << i;
    }
  }
}

}  // namespace
}  // namespace thenar
