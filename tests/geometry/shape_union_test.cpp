// Tests for geometry/shape_union.cpp.

#include "geometry/shape_union.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/geometry/random_points.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kBlend = 0.008;  // [m]

std::vector<std::shared_ptr<const Shape>> fingers() {
  std::vector<std::shared_ptr<const Shape>> parts;
  for (int i = 0; i < 4; ++i)
    parts.push_back(place(build_tapered_capsule(0.010, 0.008, 0.04),
                          {rotation_about(Vector3d(0, 1, 0), 0.2 * i), {0.015 * i, 0, 0.001 * i}}));
  parts.push_back(build_box({0.05, 0.02, 0.03}));
  return parts;
}

Vector3d near_them(std::mt19937& rng) { return 0.08 * random_in_cube(rng); }

// By hand: two planes (large balls, seen near their poles) at equal distances lose k / 4.
TEST(SmoothUnion, LosesAQuarterOfTheBlendWhereTwoMeet) {
  const auto both =
      build_smooth_union({place(build_sphere(0.01), {Eigen::Matrix3d::Identity(), {0.012, 0, 0}}),
                          place(build_sphere(0.01), {Eigen::Matrix3d::Identity(), {-0.012, 0, 0}})},
                         kBlend);
  EXPECT_NEAR(both->distance({0, 0, 0}), 0.002 - kBlend / 4, 1e-17);
  EXPECT_NEAR(both->distance({0, 0.016, 0}), 0.010 - kBlend / 4, 1e-17);
  EXPECT_TRUE(matrix_near(both->nearest({0, 0.016, 0}).normal, Vector3d::UnitY(), 1e-14));
  EXPECT_NEAR(both->distance({0.05, 0, 0}), 0.028, 1e-17);  // the other is too far to matter
}

TEST(SmoothUnion, HoldsTheUnionAndLittleMore) {
  std::mt19937 rng(1);
  const auto sharp = join(fingers()), smooth = build_smooth_union(fingers(), kBlend);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = near_them(rng);
    const double added = sharp->distance(p) - smooth->distance(p);
    EXPECT_GE(added, -1e-17);
    EXPECT_LE(added, smooth->accuracy());
    largest = std::max(largest, added);
  }
  EXPECT_GT(largest, kBlend / 4);  // where three meet
  EXPECT_LT(smooth->accuracy(), kBlend);
}

TEST(SmoothUnion, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(2);
  const auto smooth = build_smooth_union(fingers(), kBlend);
  for (int i = 0; i < queries(20000); ++i) {
    const Vector3d p = near_them(rng), q = p + 0.004 * random_in_cube(rng);
    EXPECT_LE(std::abs(smooth->distance(p) - smooth->distance(q)), (p - q).norm() + 1e-16);
  }
}

TEST(SmoothUnion, NormalIsTheGradient) {
  std::mt19937 rng(3);
  const auto smooth = build_smooth_union(fingers(), kBlend);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = near_them(rng);
    const NearestSurface near = smooth->nearest(p);
    EXPECT_NEAR(near.distance, smooth->distance(p), 1e-16);
    Vector3d gradient, curved;
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = 1e-6 * Vector3d::Unit(k);
      const double up = smooth->distance(p + step), down = smooth->distance(p - step);
      gradient(k) = (up - down) / 2e-6;
      curved(k) = (up + down - 2 * near.distance) / 1e-6;
    }
    if (near.distance < -0.003 || curved.norm() > 1e-3) continue;  // a ridge passes through
    EXPECT_TRUE(matrix_near(near.normal, gradient.normalized(), 1e-4)) << p.transpose();
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(SmoothUnion, DoesNotDependOnTheOrder) {
  std::mt19937 rng(4);
  auto parts = fingers();
  const auto forth = build_smooth_union(parts, kBlend);
  std::reverse(parts.begin(), parts.end());
  const auto back = build_smooth_union(parts, kBlend);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = near_them(rng);
    EXPECT_NEAR(forth->distance(p), back->distance(p), 1e-17);
  }
}

TEST(SmoothUnion, LiesInItsBounds) {
  std::mt19937 rng(5);
  const auto smooth = build_smooth_union(fingers(), kBlend);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = near_them(rng);
    if (smooth->distance(p) <= 0) {
      EXPECT_TRUE(smooth->bounds().contains(p));
    }
  }
}

TEST(SmoothUnion, RefusesNothingToBlend) {
  EXPECT_EQ(message_of([] { (void)build_smooth_union({}, kBlend); }),
            "a smooth union takes 1 to 64 parts, got 0");
  EXPECT_EQ(message_of([] { (void)build_smooth_union(fingers(), 0); }),
            "a blend must be positive and finite, got 0 m");
}

}  // namespace
}  // namespace thenar
