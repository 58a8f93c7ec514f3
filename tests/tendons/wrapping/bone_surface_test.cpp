// Tests for tendons/wrapping/bone_surface.cpp.

#include "tendons/wrapping/bone_surface.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

BoneSurface surface_of(SurfaceShape shape, const Vector3d& size) {
  return {"S", -1, shape, size, {}};
}

std::vector<BoneSurface> all_shapes() {
  return {surface_of(SurfaceShape::kCylinder, {0.005, 0.01, 0}),
          surface_of(SurfaceShape::kSphere, {0.005, 0, 0}),
          surface_of(SurfaceShape::kEllipsoid, {0.004, 0.006, 0.01}),
          surface_of(SurfaceShape::kCapsule, {0.004, 0.01, 0}),
          surface_of(SurfaceShape::kTorus, {0.002, 0.007, 0})};
}

TEST(BoneSurface, GapOfKnownPoints) {
  EXPECT_NEAR(probe(all_shapes()[0], {0.008, 0, 0.5}).gap, 0.003, 1e-15);
  EXPECT_NEAR(probe(all_shapes()[1], {0, 0.003, 0}).gap, -0.002, 1e-15);
  EXPECT_NEAR(probe(all_shapes()[2], {0, 0, 0.013}).gap, 0.003, 1e-15);
  EXPECT_NEAR(probe(all_shapes()[3], {0, 0.003, 0.018}).gap, std::hypot(0.003, 0.008) - 0.004,
              1e-15);
  EXPECT_NEAR(probe(all_shapes()[4], {0, 0, 0}).gap, 0.005, 1e-15);
}

// The gap changes by its normal, the normal by its curvature, at random points near each surface.
TEST(BoneSurface, SlopesAgreeWithDifferences) {
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> draw(-0.015, 0.015);
  const double h = 1e-7;  // [m]
  for (const BoneSurface& s : all_shapes())
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3d p(draw(rng), draw(rng), draw(rng));
      const SurfaceProbe at = probe(s, p);
      if (at.gap < -0.0005) continue;  // near the medial axis distances have kinks
      for (int k = 0; k < 3; ++k) {
        const Vector3d d = h * Vector3d::Unit(k);
        const SurfaceProbe up = probe(s, p + d), down = probe(s, p - d);
        EXPECT_NEAR((up.gap - down.gap) / (2 * h), at.normal[k], 1e-8);
        EXPECT_TRUE(matrix_near((up.normal - down.normal) / (2 * h), at.curvature.col(k), 2e-3));
      }
    }
}

TEST(BoneSurface, NearestPointLiesOnTheSurface) {
  for (const BoneSurface& s : all_shapes())
    EXPECT_NEAR(probe(s, nearest_point(s, {0.006, 0.004, 0.012})).gap, 0, 1e-14);
}

// Inside an ellipsoid of semi-axes (5, 4, 9) mm, across whose shortest axis all of these points
// lie.
const BoneSurface kEgg = surface_of(SurfaceShape::kEllipsoid, {0.005, 0.004, 0.009});

TEST(BoneSurface, DepthOfTheCentreOfAnEllipsoidIsItsShortestSemiAxis) {
  EXPECT_NEAR(probe(kEgg, {0, 0, 0}).gap, -0.004, 1e-17);
}

TEST(BoneSurface, NormalAtTheCentreOfAnEllipsoidIsAlongItsShortestAxis) {
  const SurfaceProbe at = probe(kEgg, {0, 0, 0});
  EXPECT_NEAR(std::abs(at.normal.y()), 1, 1e-15);
  EXPECT_NEAR(at.normal.norm(), 1, 1e-15);
}

// On the ellipse (a cos v, b sin v) the distance squared from (p, 0) is
//   (a cos v - p)^2 + b^2 sin^2 v,  least at cos v = a p / (a^2 - b^2):  b^2 (1 - p^2 / (a^2 -
//   b^2)),
// of 5, 4 and 1 mm 16 (1 - 1 / 9) = 128 / 9 mm^2, of 9, 4 and 1 mm 16 (1 - 1 / 65) mm^2.
TEST(BoneSurface, DepthOnTheMiddleAxisOfAnEllipsoid) {
  EXPECT_NEAR(probe(kEgg, {0.001, 0, 0}).gap, -1e-3 * std::sqrt(128.0 / 9), 1e-17);
}
TEST(BoneSurface, DepthOnTheLongestAxisOfAnEllipsoid) {
  EXPECT_NEAR(probe(kEgg, {0, 0, -0.001}).gap, -1e-3 * std::sqrt(16 * 64.0 / 65), 1e-17);
}
TEST(BoneSurface, DepthOnTheShortestAxisOfAnEllipsoid) {
  EXPECT_NEAR(probe(kEgg, {0, 0.001, 0}).gap, -0.003, 1e-17);
}

// Beyond p = (a^2 - b^2) / a, here 65 / 9 mm, the nearest point is the tip of that axis.
TEST(BoneSurface, DepthNearTheTipOfAnEllipsoid) {
  EXPECT_NEAR(probe(kEgg, {0, 0, 0.008}).gap, -0.001, 1e-17);
}

// A hair off the plane changes the depth by no more than that hair.
TEST(BoneSurface, DepthDoesNotJumpAcrossTheMiddlePlaneOfAnEllipsoid) {
  for (const double hair : {1e-25, -1e-25, 1e-18, -1e-18})
    EXPECT_NEAR(probe(kEgg, {0.001, hair, 0}).gap, -1e-3 * std::sqrt(128.0 / 9), 1e-17);
}

TEST(BoneSurface, DepthOfTheCentreOfARoundEllipsoidIsItsRadius) {
  const SurfaceProbe at =
      probe(surface_of(SurfaceShape::kEllipsoid, {0.005, 0.005, 0.005}), {0, 0, 0});
  EXPECT_NEAR(at.gap, -0.005, 1e-17);
  EXPECT_TRUE(at.normal.allFinite() && at.curvature.allFinite());
}

// Two shortest axes: off the longest one the nearest point is straight outwards.
TEST(BoneSurface, DepthOnAShortestAxisOfAnEllipsoidOfRevolution) {
  const BoneSurface egg = surface_of(SurfaceShape::kEllipsoid, {0.004, 0.004, 0.009});
  EXPECT_NEAR(probe(egg, {0, 0.001, 0}).gap, -0.003, 1e-17);
}

}  // namespace
}  // namespace thenar
