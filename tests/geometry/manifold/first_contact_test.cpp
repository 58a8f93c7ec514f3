// Tests for geometry/manifold/first_contact.cpp.

#include "geometry/manifold/first_contact.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/tessellate.h"
#include "tests/geometry/collision/drawn.h"
#include "tests/geometry/manifold/manifold_samples.h"

namespace thenar {
namespace {

BodyMotion motion(const Pose<double>& X, const Eigen::Vector3d& v,
                  const Eigen::Vector3d& omega = {0, 0, 0}) {
  return {X, omega, v};
}

SampleBody plate(bool as_mesh) {
  ShapeSpec spec = spec_of(ShapeKind::kBox, {0.1, 0.1, 0.0005});
  if (as_mesh) {
    spec.mesh = box_mesh(spec.size);
    spec.kind = ShapeKind::kMesh;
  }
  return SampleBody(std::vector<ShapeSpec>{spec});
}

// Two balls:  |p + v t| = r1 + r2.
TEST(FirstContact, OfBallsIsTheRootOfAQuadratic) {
  const SampleBody a(ShapeKind::kSphere, {0.01, 0, 0}), b(ShapeKind::kSphere, {0.02, 0, 0});
  std::mt19937 rng(1);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p = 0.1 * drawn_point(rng, 1).normalized();
    const Eigen::Vector3d v = -10 * p + 0.6 * drawn_point(rng, 1), w = drawn_point(rng, 20);
    CollisionPair pair(a.body, b.body);
    FirstContactOptions options;
    options.gap = 1e-8;
    const FirstContact found = first_contact(pair, motion(placed(p.x(), p.y(), p.z()), v),
                                             motion({}, {0, 0, 0}, w), 0.2, options);
    ASSERT_TRUE(found.complete);
    const double half = p.dot(v) / v.squaredNorm();
    const double root = half * half - (p.squaredNorm() - 0.03 * 0.03) / v.squaredNorm();
    const double exact = root > 0 ? -half - std::sqrt(root) : 1;
    // At a grazing angle a gap of 1e-8 m is earlier by more.
    if (root < 1e-4) continue;
    ASSERT_EQ(found.found, exact < 0.2) << i;
    if (!found.found) continue;
    ++hits;
    ASSERT_NEAR(found.time, exact, 1e-6);
    ASSERT_LE(found.time, exact);
  }
  EXPECT_GT(hits, 100);
}

// At 20 m/s a capsule passes a plate of 0.5 mm within 0.025 ms; steps are 5 ms.
TEST(FirstContact, CapsuleDoesNotTunnelThroughAThinPlate) {
  const SampleBody capsule(ShapeKind::kCapsule, {0.004, 0.02, 0});
  std::mt19937 rng(2);
  for (const bool as_mesh : {false, true}) {
    const SampleBody wall = plate(as_mesh);
    for (int i = 0; i < 100; ++i) {
      BodyMotion fast = motion(drawn_pose(rng, 0.02), {0, 0, -20}, drawn_point(rng, 100));
      fast.X_WB.p.z() = 0.05;
      CollisionPair pair(capsule.body, wall.body);
      const FirstContact found = first_contact(pair, fast, motion({}, {0, 0, 0}), 0.005);
      ASSERT_TRUE(found.found && found.complete) << i;
      // It touches the upper side, where it is then.
      ASSERT_FALSE(pair.manifold().empty());
      for (const ManifoldPoint& point : pair.manifold()) {
        ASSERT_GT(point.normal.z(), 0.99);
        ASSERT_GT(point.gap, 0);
      }
      ASSERT_LE(least_gap(pair.manifold()), 1e-5);
    }
  }
}

// A spinning plank meets a ball beside it when its corner comes round.
TEST(FirstContact, OfASpinningPlankIsWhenItsFaceComesRound) {
  const SampleBody plank(ShapeKind::kBox, {0.2, 0.01, 0.01}),
      ball(ShapeKind::kSphere, {0.01, 0, 0});
  CollisionPair pair(plank.body, ball.body);
  FirstContactOptions options;
  options.gap = 1e-8;
  // The face y = 5 mm is at the ball's centre, 80 mm out, when  80 mm sin(90 deg - angle) = 15 mm.
  const FirstContact found = first_contact(pair, motion({}, {0, 0, 0}, {0, 0, 10}),
                                           motion(placed(0, 0.08, 0), {0, 0, 0}), 0.2, options);
  ASSERT_TRUE(found.found);
  EXPECT_NEAR(10 * found.time, kPi / 2 - std::asin(0.015 / 0.08), 1e-6);
}

TEST(FirstContact, OfBodiesThatPartIsNever) {
  const SampleBody box(ShapeKind::kBox, {0.02, 0.02, 0.02});
  CollisionPair pair(box.body, box.body);
  const FirstContact found =
      first_contact(pair, motion(placed(0, 0, 0.0201), {0, 0, 1}), motion({}, {0, 0, 0}), 1);
  EXPECT_FALSE(found.found);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.time, 1);
}

TEST(FirstContact, OfBodiesThatOverlapIsNow) {
  const SampleBody box(ShapeKind::kBox, {0.02, 0.02, 0.02});
  CollisionPair pair(box.body, box.body);
  const FirstContact found =
      first_contact(pair, motion(placed(0, 0, 0.01), {0, 0, 1}), motion({}, {0, 0, 0}), 1);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.time, 0);
}

// Points of the body at many times lie in the box.
TEST(FirstContact, SweptBoxHoldsTheWholeMotion) {
  const SampleBody box(ShapeKind::kBox, {0.05, 0.02, 0.1});
  std::mt19937 rng(3);
  for (int i = 0; i < 50; ++i) {
    const BodyMotion moving =
        motion(drawn_pose(rng, 0.1), drawn_point(rng, 1), drawn_point(rng, 8));
    const Eigen::AlignedBox3d swept = swept_box(*box.body, moving, 0.2, 0);
    for (int k = 0; k <= 40; ++k)
      for (int c = 0; c < 8; ++c) {
        const Eigen::Vector3d corner(c & 1 ? 0.025 : -0.025, c & 2 ? 0.01 : -0.01,
                                     c & 4 ? 0.05 : -0.05);
        ASSERT_TRUE(swept.contains(moving.pose_at(0.005 * k) * corner)) << i;
      }
  }
}

TEST(FirstContact, RefusesWhatIsNotFinite) {
  const SampleBody box(ShapeKind::kBox, {0.02, 0.02, 0.02});
  CollisionPair pair(box.body, box.body);
  const BodyMotion lost = motion({}, {0, 0, std::nan("")});
  EXPECT_THROW((void)first_contact(pair, lost, {}, 1), InputError);
  EXPECT_THROW((void)first_contact(pair, {}, {}, -1), InputError);
  Pose<double> nowhere;
  nowhere.p.x() = std::nan("");
  EXPECT_THROW((void)pair.update(nowhere, {}, 0), InputError);
  EXPECT_THROW((void)pair.update({}, {}, -1), InputError);
}

}  // namespace
}  // namespace thenar
