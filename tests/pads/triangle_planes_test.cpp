// Tests for pads/triangle_planes.cpp.

#include "pads/triangle_planes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kRounded = 1e-15;

// 1 at one corner and -1 at the others: zero through the middles of two sides.
TEST(TrianglePart, BeyondTheMiddlesOfTwoSidesIsAQuarter) {
  EXPECT_NEAR(area_share(clipped(whole_triangle(), Vector3d(1, -1, -1))), 0.25, kRounded);
  EXPECT_NEAR(area_share(clipped(whole_triangle(), Vector3d(-1, 1, 1))), 0.75, kRounded);
}

// The array has 16 corners.
TEST(TrianglePart, IgnoresCornersThatItHasNoSpaceFor) {
  TrianglePart part;
  for (int i = 0; i < 20; ++i) part.add(Vector3d::Unit(i % 3));
  EXPECT_EQ(part.size, 16U);
}

// The mean square of a barycentric coordinate over a triangle is 1/6.
TEST(TrianglePart, SumsProductsOfLinearFunctionsExactly) {
  double sum = 0;
  for_each_gauss_point(whole_triangle(),
                       [&](const Vector3d& b, double share) { sum += share * b[0] * b[0]; });
  EXPECT_NEAR(sum, 1.0 / 6, kRounded);
}

TEST(TrianglePlanes, BeginWithThoseThatDiffer) {
  const Vector3d up(0, 0, 1), across(1, 0, 0), depth(-1, -1, -1);
  TrianglePlanes planes;
  planes.reset({{{depth, up}, {depth, across}, {depth, up}}});
  EXPECT_EQ(planes.size(), 2U);
}

/// Two planes whose ridge leads from the middle of one side to that of another, all inside.
TrianglePlanes roof() {
  TrianglePlanes planes;
  planes.add({Vector3d(-1, -2, -2), Vector3d(0, 0, 1)});
  planes.add({Vector3d(-2, -1, -1), Vector3d(1, 0, 0)});
  planes.update_parts();
  return planes;
}

TEST(TrianglePlanes, ShareTheTriangle) {
  EXPECT_NEAR(area_share(roof().part(0)), 0.25, kRounded);
  EXPECT_NEAR(area_share(roof().part(1)), 0.75, kRounded);
}

// From (1/2, 1/2, 0) to (1/2, 0, 1/2); the difference (1, -1, -1) falls by 2 along the first axis.
TEST(TrianglePlanes, MeetInARidge) {
  const std::optional<PlaneRidge> ridge = roof().ridge(0, 1);
  ASSERT_TRUE(ridge);
  EXPECT_NEAR(ridge->length, 0.5, kRounded);
  EXPECT_NEAR(ridge->difference_slope, 2, kRounded);
  const double off = 1 / std::sqrt(48.0);  // of Gauss points from the middle
  EXPECT_TRUE(matrix_near(ridge->points[0], Vector3d(0.5, 0.25 + off, 0.25 - off), kRounded));
  EXPECT_TRUE(matrix_near(ridge->points[1], Vector3d(0.5, 0.25 - off, 0.25 + off), kRounded));
}

TEST(TrianglePlanes, DropThoseThatOthersHide) {
  TrianglePlanes planes = roof();
  planes.add({Vector3d(-3, -3, -3), Vector3d(0, 1, 0)});
  planes.update_parts();
  planes.remove_empty_parts();
  EXPECT_EQ(planes.size(), 2U);
}

}  // namespace
}  // namespace thenar::internal
