// Tests for geometry/rounded_shape.cpp: a box with edges and corners of a radius, by hand.

#include "geometry/rounded_shape.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// A cube of half edge 2 and radius 1: half edge 3 outside.
const std::shared_ptr<const Shape> kRounded = build_rounded(build_box({4, 4, 4}), 1);

TEST(RoundedShape, FacesMoveOut) {
  EXPECT_DOUBLE_EQ(kRounded->distance({0, 0, 5}), 2);
  EXPECT_DOUBLE_EQ(kRounded->distance({0, 0, 2.5}), -0.5);
  EXPECT_TRUE(kRounded->nearest({0, 0, 5}).normal.isApprox(Vector3d::UnitZ()));
}

TEST(RoundedShape, EdgesAreCylindersAndCornersBalls) {
  // From the edge's line (2, 2, z) by (3, 4), from the corner by (1, 2, 2).
  EXPECT_NEAR(kRounded->distance({5, 6, 0}), 4, 1e-15);
  EXPECT_TRUE(kRounded->nearest({5, 6, 0}).normal.isApprox(Vector3d(0.6, 0.8, 0)));
  EXPECT_NEAR(kRounded->distance({3, 4, 4}), 2, 1e-15);
  // The sharp corner of the larger cube is outside by sqrt(3) - 1.
  EXPECT_NEAR(kRounded->distance({3, 3, 3}), std::sqrt(3.0) - 1, 1e-15);
}

TEST(RoundedShape, BoundsHoldIt) {
  EXPECT_TRUE(kRounded->bounds().min().isApprox(Vector3d(-3, -3, -3)));
  EXPECT_TRUE(kRounded->bounds().max().isApprox(Vector3d(3, 3, 3)));
}

TEST(RoundedShape, NonsenseIsRefused) {
  EXPECT_THROW((void)build_rounded(nullptr, 1), InputError);
  EXPECT_THROW((void)build_rounded(build_sphere(1), -1), InputError);
  EXPECT_THROW((void)build_rounded(build_sphere(1), NAN), InputError);
}

}  // namespace
}  // namespace thenar
