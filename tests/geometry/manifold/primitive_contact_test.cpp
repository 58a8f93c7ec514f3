// Tests for geometry/manifold: contacts of two primitives.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/collision/signed_distance.h"
#include "geometry/manifold/collision_pair.h"
#include "tests/geometry/collision/drawn.h"
#include "tests/geometry/manifold/manifold_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kFar = 1.0;  // a margin that leaves nothing out [m]

/// What every point of a manifold obeys.
void expect_lawful(const ContactManifold& manifold, const SampleBody& a, const Pose<double>& X_WA,
                   const SampleBody& b, const Pose<double>& X_WB, double tolerance) {
  for (const ManifoldPoint& point : manifold) {
    ASSERT_NEAR(point.normal.norm(), 1, 1e-12);
    ASSERT_NEAR(point.gap, (point.on_a - point.on_b).dot(point.normal), 1e-12);
    // Each point is on or in its own body.
    ASSERT_LE(a.solid.shape->distance(X_WA.inverse() * point.on_a), tolerance);
    ASSERT_LE(b.solid.shape->distance(X_WB.inverse() * point.on_b), tolerance);
  }
}

struct PairOfKinds {
  ShapeKind a, b;
};

std::vector<SampleBody> sample_bodies() {
  std::vector<SampleBody> bodies;
  bodies.emplace_back(ShapeKind::kSphere, Eigen::Vector3d(0.012, 0, 0));
  bodies.emplace_back(ShapeKind::kCapsule, Eigen::Vector3d(0.008, 0.03, 0));
  bodies.emplace_back(ShapeKind::kTaperedCapsule, Eigen::Vector3d(0.011, 0.006, 0.025));
  bodies.emplace_back(ShapeKind::kBox, Eigen::Vector3d(0.04, 0.02, 0.03));
  return bodies;
}

// Apart, the least gap is the distance, but for 0.1 um where a capsule has its ends instead: that
// of the nearest point of A's surface from B's shape.
TEST(PrimitiveContact, LeastGapIsTheDistance) {
  const std::vector<SampleBody> bodies = sample_bodies();
  std::mt19937 rng(1);
  SignedDistanceOptions options;
  options.tolerance = 1e-9;
  int apart = 0;
  for (int i = 0; i < 4000; ++i) {
    const SampleBody& a = bodies[rng() % bodies.size()];
    const SampleBody& b = bodies[rng() % bodies.size()];
    const Pose<double> X_WA = drawn_pose(rng, 0.03), X_WB = drawn_pose(rng, 0.03);
    // Tapered capsules are tessellated as A: then B takes their place.
    const bool swapped = a.solid.parts[0].spec.kind == ShapeKind::kTaperedCapsule;
    if (swapped && b.solid.parts[0].spec.kind == ShapeKind::kTaperedCapsule) continue;
    const SignedDistance exact =
        swapped ? signed_distance(collision_tree(b.solid), X_WB, a.solid, X_WA, options)
                : signed_distance(collision_tree(a.solid), X_WA, b.solid, X_WB, options);
    CollisionPair pair(a.body, b.body);
    const ContactManifold& manifold = pair.update(X_WA, X_WB, kFar);
    ASSERT_FALSE(manifold.empty()) << i;
    expect_lawful(manifold, a, X_WA, b, X_WB, 1e-9);
    if (exact.distance < 1e-6) continue;
    ++apart;
    ASSERT_NEAR(least_gap(manifold), exact.distance, 1.02e-7 + exact.error)
        << i << " " << name_of(a.solid.parts[0].spec.kind) << " on "
        << name_of(b.solid.parts[0].spec.kind);
  }
  EXPECT_GT(apart, 1000);
}

// A, B swapped: the same gaps, opposite normals.
TEST(PrimitiveContact, IsTheSameTheOtherWayRound) {
  const std::vector<SampleBody> bodies = sample_bodies();
  std::mt19937 rng(2);
  for (int i = 0; i < 3000; ++i) {
    const SampleBody& a = bodies[rng() % bodies.size()];
    const SampleBody& b = bodies[rng() % bodies.size()];
    const Pose<double> X_WA = drawn_pose(rng, 0.02), X_WB = drawn_pose(rng, 0.02);
    CollisionPair one(a.body, b.body), other(b.body, a.body);
    const ContactManifold& ab = one.update(X_WA, X_WB, 1e-3);
    const ContactManifold& ba = other.update(X_WB, X_WA, 1e-3);
    if (ab.empty() && ba.empty()) continue;
    ASSERT_NEAR(least_gap(ab), least_gap(ba), 1.01e-7) << i;
    // So deep that a body's middle is as near to one face as to another, points are a matter of
    // rounding.
    if (least_gap(ab) < -0.004) continue;
    ASSERT_EQ(ab.count, ba.count) << i << " " << name_of(a.solid.parts[0].spec.kind) << " on "
                                  << name_of(b.solid.parts[0].spec.kind) << " gap "
                                  << least_gap(ab);
    for (const ManifoldPoint& point : ab) {
      double nearest = 1;
      for (const ManifoldPoint& mirrored : ba)
        nearest = std::min(nearest, (mirrored.on_a - point.on_b).norm() +
                                        (mirrored.on_b - point.on_a).norm() +
                                        (mirrored.normal + point.normal).norm() +
                                        std::abs(mirrored.gap - point.gap));
      ASSERT_LT(nearest, 1e-7) << i << " " << name_of(a.solid.parts[0].spec.kind) << " on "
                               << name_of(b.solid.parts[0].spec.kind) << " gap " << point.gap;
    }
  }
}

// Two boxes that overlap: moved by the depth along the normal they touch, and less does not do.
TEST(PrimitiveContact, DepthOfBoxesSeparatesThem) {
  const SampleBody a(ShapeKind::kBox, {0.04, 0.02, 0.03}), b(ShapeKind::kBox, {0.03, 0.05, 0.02});
  std::mt19937 rng(3);
  int overlaps = 0;
  for (int i = 0; i < 2000; ++i) {
    Pose<double> X_WA = drawn_pose(rng, 0.02);
    const Pose<double> X_WB = drawn_pose(rng, 0.01);
    CollisionPair pair(a.body, b.body);
    const ContactManifold first = pair.update(X_WA, X_WB, 0);
    const double depth = -least_gap(first);
    if (first.empty()) continue;
    ++overlaps;
    const Eigen::Vector3d n = first.points[0].normal, p = X_WA.p;
    X_WA.p = p + (depth + 1e-9) * n;
    CollisionPair apart(a.body, b.body);
    ASSERT_TRUE(apart.update(X_WA, X_WB, 0).empty()) << i;
    // No shorter way in 200 drawn directions.
    for (int k = 0; k < 200; ++k) {
      X_WA.p = p + 0.99 * depth * drawn_point(rng, 1).normalized();
      CollisionPair still(a.body, b.body);
      ASSERT_FALSE(still.update(X_WA, X_WB, 0).empty()) << i;
    }
  }
  EXPECT_GT(overlaps, 300);
}

TEST(PrimitiveContact, BoxOnAFaceTouchesInItsFourCorners) {
  const SampleBody box(ShapeKind::kBox, {0.04, 0.02, 0.03}),
      table(ShapeKind::kBox, {0.6, 0.4, 0.02});
  CollisionPair pair(box.body, table.body);
  const ContactManifold& manifold = pair.update(placed(0.1, 0.05, 0.01 + 0.015), {}, 1e-4);
  ASSERT_EQ(manifold.count, 4);
  for (const ManifoldPoint& point : manifold) {
    EXPECT_NEAR(point.gap, 0, 1e-15);
    EXPECT_NEAR(std::abs(point.on_a.x() - 0.1), 0.02, 1e-15);
    EXPECT_NEAR(std::abs(point.on_a.y() - 0.05), 0.01, 1e-15);
    EXPECT_TRUE(matrix_near(point.normal, Eigen::Vector3d::UnitZ(), 1e-15));
  }
}

TEST(PrimitiveContact, CrossedBoxesTouchWhereTheirEdgesCross) {
  const SampleBody plank(ShapeKind::kBox, {0.2, 0.02, 0.01});
  CollisionPair pair(plank.body, plank.body);
  const Pose<double> turned{rotation_about<double>(Eigen::Vector3d::UnitZ(), kPi / 2),
                            {0, 0, 0.0099}};
  const ContactManifold& manifold = pair.update(turned, {}, 1e-4);
  ASSERT_EQ(manifold.count, 4);
  for (const ManifoldPoint& point : manifold) {
    EXPECT_NEAR(point.gap, -1e-4, 1e-15);
    EXPECT_NEAR(std::abs(point.on_a.x()), 0.01, 1e-12);
    EXPECT_NEAR(std::abs(point.on_a.y()), 0.01, 1e-12);
  }
}

TEST(PrimitiveContact, CapsuleOnAFaceTouchesInTwoPoints) {
  const SampleBody capsule(ShapeKind::kCapsule, {0.008, 0.03, 0}),
      table(ShapeKind::kBox, {0.6, 0.4, 0.02});
  CollisionPair pair(capsule.body, table.body);
  const Pose<double> lying{rotation_about<double>(Eigen::Vector3d::UnitX(), kPi / 2),
                           {0, 0, 0.018}};
  const ContactManifold& manifold = pair.update(lying, {}, 1e-4);
  ASSERT_EQ(manifold.count, 2);
  for (const ManifoldPoint& point : manifold) {
    EXPECT_NEAR(point.gap, 0, 1e-15);
    EXPECT_NEAR(std::abs(point.on_b.y()), 0.015, 1e-15);
  }
}

// Side by side over 20 mm of their axes.
TEST(PrimitiveContact, CapsulesSideBySideTouchAtTheEndsOfTheOverlap) {
  const SampleBody capsule(ShapeKind::kCapsule, {0.008, 0.03, 0});
  CollisionPair pair(capsule.body, capsule.body);
  const ContactManifold& manifold = pair.update(placed(0.016, 0, 0.01), {}, 1e-4);
  ASSERT_EQ(manifold.count, 2);
  for (const ManifoldPoint& point : manifold) EXPECT_NEAR(point.gap, 0, 1e-15);
  EXPECT_NEAR(std::abs(manifold.points[0].on_a.z() - manifold.points[1].on_a.z()), 0.02, 1e-12);
}

// Edges one above the other, in parallel: half a diagonal of each away from the middles.
TEST(PrimitiveContact, ParallelEdgesAreAsFarApartAsTheyAre) {
  const SampleBody box(ShapeKind::kBox, {0.02, 0.05, 0.02});
  const Eigen::Matrix3d R = rotation_about<double>(Eigen::Vector3d::UnitY(), kPi / 4);
  for (const double gap : {2e-4, 1e-9}) {
    CollisionPair pair(box.body, box.body);
    const double z = 0.02 * std::sqrt(2.0) + gap;
    const ContactManifold& manifold = pair.update({R, {0, 0.01, z}}, {R, {0, 0, 0}}, 1e-3);
    ASSERT_GT(manifold.count, 0);
    EXPECT_NEAR(least_gap(manifold), gap, 1e-9);
  }
  // Overlapping they are pushed out along a face: by the overlap's height over the diagonal.
  CollisionPair pair(box.body, box.body);
  const double z = 0.02 * std::sqrt(2.0) - 1e-4;
  EXPECT_NEAR(least_gap(pair.update({R, {0, 0.01, z}}, {R, {0, 0, 0}}, 0)), -1e-4 / std::sqrt(2.0),
              1e-12);
}

// A dumbbell of two balls and a rod on a table: each ball touches, the rod does not.
TEST(PrimitiveContact, UnionsTouchPartByPart) {
  std::vector<ShapeSpec> specs(3, spec_of(ShapeKind::kSphere, {0.01, 0, 0}));
  specs[0].X_BS.p.x() = -0.03;
  specs[1].X_BS.p.x() = 0.03;
  specs[2] = spec_of(ShapeKind::kCapsule, {0.004, 0.06, 0});
  specs[2].X_BS.R = rotation_about<double>(Eigen::Vector3d::UnitY(), kPi / 2);
  const SampleBody dumbbell(specs), table(ShapeKind::kBox, {0.6, 0.4, 0.02});
  CollisionPair pair(dumbbell.body, table.body);
  const ContactManifold& manifold = pair.update(placed(0, 0, 0.02), {}, 1e-4);
  ASSERT_EQ(manifold.count, 2);
  EXPECT_NEAR(manifold.points[0].on_b.x() + manifold.points[1].on_b.x(), 0, 1e-15);
  EXPECT_NEAR(std::abs(manifold.points[0].on_b.x()), 0.03, 1e-15);
  // After a jump ids start anew.
  const int id = manifold.points[0].id;
  pair.clear_memory();
  pair.update(placed(0, 0, 0.02), {}, 1e-4);
  EXPECT_GT(pair.manifold().points[0].id, id);
}

TEST(PrimitiveContact, ConcentricBodiesHaveADirection) {
  for (const SampleBody& a : sample_bodies())
    for (const SampleBody& b : sample_bodies()) {
      CollisionPair pair(a.body, b.body);
      const ContactManifold& manifold = pair.update({}, {}, 0);
      ASSERT_GT(manifold.count, 0);
      for (const ManifoldPoint& point : manifold) {
        EXPECT_NEAR(point.normal.norm(), 1, 1e-12);
        EXPECT_LT(point.gap, 0);
        EXPECT_TRUE(point.on_a.allFinite() && point.on_b.allFinite());
      }
    }
}

// An ellipsoid on whatever is convex: no point of it is nearer, and the point found is.
TEST(PrimitiveContact, EllipsoidTouchesInItsNearestPoint) {
  const SampleBody egg(ShapeKind::kEllipsoid, {0.03, 0.02, 0.015});
  std::vector<SampleBody> others = sample_bodies();
  others.emplace_back(ShapeKind::kCylinder, Eigen::Vector3d(0.02, 0.03, 0));
  others.emplace_back(ShapeKind::kEllipsoid, Eigen::Vector3d(0.01, 0.02, 0.04));
  const TriangleMesh& skin = egg.solid.collision[0].core;
  std::mt19937 rng(5);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const SampleBody& b = others[static_cast<std::size_t>(i) % others.size()];
    const Pose<double> X_WA = drawn_pose(rng, 0.05), X_WB = drawn_pose(rng, 0.01);
    // Brute force over the corners of a fine surface, good to 0.02 mm.
    const Pose<double> X_BA = X_WB.inverse() * X_WA;
    double brute = 1;
    for (Eigen::Index k = 0; k < skin.vertices.cols(); ++k)
      brute =
          std::min(brute, b.solid.shape->distance(X_BA * Eigen::Vector3d(skin.vertices.col(k))));
    if (brute < -0.004 || brute > 0.02) continue;
    // Rims of cylinders within are taken for polygons.
    if (brute < 0 && b.solid.parts[0].spec.kind == ShapeKind::kCylinder) continue;
    ++tried;
    CollisionPair pair(egg.body, b.body), other(b.body, egg.body);
    const ContactManifold& manifold = pair.update(X_WA, X_WB, 0.021);
    ASSERT_EQ(manifold.count, 1) << i << " brute " << brute << " on "
                                 << name_of(b.solid.parts[0].spec.kind);
    expect_lawful(manifold, egg, X_WA, b, X_WB, 1e-9);
    ASSERT_NEAR(least_gap(other.update(X_WB, X_WA, 0.021)), least_gap(manifold), 1e-9);
    // The way out of a box with an edge in the egg is longer than the egg is deep in the box.
    ASSERT_LT(least_gap(manifold), brute + 1e-4) << i;
    if (brute > 0) {
      ASSERT_GT(least_gap(manifold), brute - 1e-4) << i;
    }
  }
  EXPECT_GT(tried, 100);
}

TEST(PrimitiveContact, CylinderStandsOnSixPointsAndLiesOnTwo) {
  const SampleBody can(ShapeKind::kCylinder, {0.03, 0.1, 0}),
      table(ShapeKind::kBox, {0.6, 0.4, 0.02});
  CollisionPair pair(can.body, table.body);
  EXPECT_EQ(pair.update(placed(0.1, 0, 0.06), {}, 1e-4).count, 6);
  for (const ManifoldPoint& point : pair.manifold()) EXPECT_NEAR(point.gap, 0, 1e-15);
  const Pose<double> lying{rotation_about<double>(Eigen::Vector3d::UnitX(), kPi / 2), {0, 0, 0.04}};
  EXPECT_EQ(pair.update(lying, {}, 1e-4).count, 2);
  for (const ManifoldPoint& point : pair.manifold()) {
    EXPECT_NEAR(point.gap, 0, 1e-15);
    EXPECT_NEAR(std::abs(point.on_b.y()), 0.05, 1e-15);
    EXPECT_NEAR(point.on_b.x(), 0, 1e-15);
  }
  // Tilted by 30 degrees: the lowest point of the rim, in closed form.
  const double tilt = kPi / 6;
  const Pose<double> tilted{rotation_about<double>(Eigen::Vector3d::UnitY(), tilt), {0, 0, 0.08}};
  EXPECT_EQ(pair.update(tilted, {}, 0.012).count, 1);
  EXPECT_NEAR(least_gap(pair.manifold()), 0.07 - 0.05 * std::cos(tilt) - 0.03 * std::sin(tilt),
              1e-15);
}

// A coin that rolls on its rim: its point does not jump, and is the lowest.
TEST(PrimitiveContact, RollingCoinKeepsItsPoint) {
  const SampleBody coin(ShapeKind::kCylinder, {0.012, 0.002, 0}),
      table(ShapeKind::kBox, {1, 1, 0.02});
  CollisionPair pair(coin.body, table.body);
  int id = -1;
  for (int i = 0; i < 2000; ++i) {
    const double turn = 0.005 * i, tilt = 1.2;
    const Eigen::Matrix3d R = rotation_about<double>(Eigen::Vector3d::UnitY(), tilt) *
                              rotation_about<double>(Eigen::Vector3d::UnitZ(), turn);
    const double height = 0.012 * std::sin(tilt) + 0.001 * std::cos(tilt);
    const ContactManifold& manifold = pair.update({R, {0, 0, 0.01 + height}}, {}, 1e-4);
    ASSERT_EQ(manifold.count, 1);
    ASSERT_NEAR(manifold.points[0].gap, 0, 1e-9);
    if (i == 0) id = manifold.points[0].id;
    ASSERT_EQ(manifold.points[0].id, id) << i;
  }
}

}  // namespace
}  // namespace thenar
