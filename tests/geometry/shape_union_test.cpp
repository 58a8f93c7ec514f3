// Tests for geometry/shape_union.cpp.

#include "geometry/shape_union.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/geometry/random_points.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

std::vector<std::shared_ptr<const Shape>> fingers() {
  std::vector<std::shared_ptr<const Shape>> parts;
  for (int i = 0; i < 4; ++i)
    parts.push_back(place(build_tapered_capsule(0.010, 0.008, 0.04),
                          {rotation_about(Vector3d(0, 1, 0), 0.2 * i), {0.015 * i, 0, 0.001 * i}}));
  parts.push_back(build_box({0.05, 0.02, 0.03}));
  return parts;
}

Vector3d near_them(std::mt19937& rng) { return 0.08 * random_in_cube(rng); }

TEST(ShapeUnion, HasTheLeastOfItsDistances) {
  std::mt19937 rng(1);
  const auto parts = fingers();
  const auto all = join(parts);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = near_them(rng);
    double least = parts.front()->distance(p);
    for (const auto& part : parts) least = std::min(least, part->distance(p));
    if (least > 0) {
      EXPECT_EQ(all->distance(p), least);
    }
    EXPECT_NEAR(all->nearest(p).distance, all->distance(p), 1e-16);
  }
}

TEST(ShapeUnion, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(2);
  const auto all = join(fingers());
  for (int i = 0; i < queries(20000); ++i) {
    const Vector3d p = near_them(rng), q = p + 0.004 * random_in_cube(rng);
    EXPECT_LE(std::abs(all->distance(p) - all->distance(q)), (p - q).norm() + 1e-16);
  }
}

TEST(ShapeUnion, LiesInItsBounds) {
  std::mt19937 rng(5);
  const auto all = join(fingers());
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = near_them(rng);
    if (all->distance(p) <= 0) {
      EXPECT_TRUE(all->bounds().contains(p));
    }
  }
}

}  // namespace
}  // namespace thenar
