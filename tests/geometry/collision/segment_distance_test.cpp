// Tests for segments in geometry/collision/signed_distance.cpp: capsules beside what is not convex.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/collision/signed_distance.h"
#include "geometry/mesh_distance.h"
#include "geometry/tessellate.h"
#include "grasp/closing/approach_sampling.h"

namespace thenar {
namespace {

constexpr double kRadius = 0.005, kHalf = 0.02;  // of a capsule along z [m]

/// A vase with two bulges and two hollows, 12 cm high: 25 x 24 strips.
TriangleMesh vase() {
  std::vector<Eigen::Vector2d> profile{{0, -0.06}};
  for (int i = 0; i < 25; ++i) {
    const double s = (i + 0.5) / 25;
    profile.emplace_back(0.03 + 0.008 * std::sin(4 * kPi * s), 0.12 * (s - 0.5));
  }
  profile.emplace_back(0, 0.06);
  return surface_of_revolution(profile, 24);
}

CollisionTree capsule() {
  Eigen::Matrix3Xd ends = Eigen::Matrix3Xd::Zero(3, 2);
  ends.row(2) << -kHalf, kHalf;
  return collision_tree({nullptr, {{{ends, Eigen::Vector3i(0, 1, 1)}, kRadius}}, {}});
}

Pose<double> pose_within(double reach, std::mt19937& random) {
  const auto draw = [&] { return sample_between(-1, 1, random); };
  const Eigen::Vector3d axis(draw(), draw(), draw()), p(draw(), draw(), draw());
  return {rotation_about<double>(axis.normalized(), kPi * draw()), reach * p};
}

/// The least distance of points of the axis every 4 um, which is within 2 um of the least of all.
double sampled(const Pose<double>& X, const Shape& b) {
  constexpr int kSteps = 10'000;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i)
    least = std::min(
        least, b.distance(X * Eigen::Vector3d(0, 0, kHalf * (2.0 * i / kSteps - 1))) - kRadius);
  return least;
}

// Apart, touching and through each other.
TEST(SegmentSeparation, IsTheLeastOfThePointsOfACapsuleBesideAVase) {
  const auto shape = build_mesh_distance(vase());
  const CollisionTree a = capsule();
  std::mt19937 random(1);
  for (int i = 0; i < 25; ++i) {
    const Pose<double> X = pose_within(0.07, random);
    const SignedDistance s = signed_distance(a, X, *shape);
    const double least = sampled(X, *shape);
    EXPECT_LE(s.distance, least + 5e-5) << i;  // SignedDistanceOptions::tolerance
    EXPECT_GE(s.distance, least - 2e-6) << i;
    EXPECT_LE(s.distance - s.error, least + 1e-12) << i;
  }
}

// Empty balls of radius d about points a way w apart leave nothing nearer than  d - w^2 / 8 d
// between them, nearly: every  sqrt(8 d tolerance)  is enough, 1.4 mm at d = 5 mm; halves of ways
// may be half as long; and ten for a first guess. Balls alone would be needed twice a tolerance.
TEST(SegmentSeparation, NeedsAsManyBallsAsWaysBetweenThemMayBeLong) {
  const auto shape = build_mesh_distance(vase());
  const CollisionTree a = capsule();
  std::mt19937 random(2);
  int apart = 0;
  for (int i = 0; i < 200; ++i) {
    const SignedDistance s = signed_distance(a, pose_within(0.07, random), *shape);
    if (s.distance < 0) continue;
    ++apart;
    const double way = std::sqrt(8 * (s.distance + kRadius) * 5e-5);
    EXPECT_LE(s.evaluations, 10 + 2 * std::ceil(2 * kHalf / way)) << i;
  }
  EXPECT_GT(apart, 100);
}

}  // namespace
}  // namespace thenar
