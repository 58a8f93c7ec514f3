// Tests for tendons/neighbouring_axes.cpp: offsets by hand, and what turning and shifting must not
// change.

#include "tendons/neighbouring_axes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "base/units.h"

namespace thenar {
namespace {

Hinge<double> axis(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
  return {-1, 0, 1, 0, direction.normalized(), point};
}

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST(AxisOffset, IsTheCommonNormalOfSkewAxes) {
  // Along y through the origin; along z, 9 mm beyond it along x and shifted along itself.
  const AxisOffset offset = axis_offset(axis({0, 5, 0}, kY), axis({0.009, 0, 7}, -kZ), kX);
  EXPECT_DOUBLE_EQ(offset.angle, kPi / 2);
  EXPECT_DOUBLE_EQ(offset.distance, 0.009);
  EXPECT_DOUBLE_EQ(offset.beyond, 0.009);
}

TEST(AxisOffset, ChangesItsSignWithTheOrder) {
  const Hinge<double> a = axis({0, 0, 0}, {0.1, 1, 0.3}), b = axis({0.02, 0.01, 0}, {0.2, 0, 1});
  const AxisOffset there = axis_offset(a, b, kX), back = axis_offset(b, a, kX);
  EXPECT_DOUBLE_EQ(there.angle, back.angle);
  EXPECT_NEAR(there.distance, back.distance, 1e-17);
  EXPECT_NEAR(there.beyond, -back.beyond, 1e-17);
  EXPECT_LE(std::abs(there.beyond), there.distance);
}

TEST(AxisOffset, CountsTheAngleBetweenLinesAndNotTheirSenses) {
  const AxisOffset offset =
      axis_offset(axis({0, 0, 0}, kY), axis({0, 0, 0}, {0, -1, -std::tan(radians(20))}), kX);
  EXPECT_NEAR(degrees(offset.angle), 20, 1e-12);
  EXPECT_NEAR(offset.distance, 0, 1e-17);
}

TEST(AxisOffset, OfParallelAxesIsThePerpendicularBetweenThem) {
  const AxisOffset offset = axis_offset(axis({0, 3, 0}, kY), axis({0.03, -2, 0.04}, -kY), kX);
  EXPECT_DOUBLE_EQ(offset.angle, 0);
  EXPECT_NEAR(offset.distance, 0.05, 1e-16);
  EXPECT_NEAR(offset.beyond, 0.03, 1e-16);
}

// Feet of the common normal are the nearest points of two lines: least squares over both places.
TEST(AxisOffset, JoinsTheNearestPointsOfRandomLines) {
  std::mt19937 rng(5);
  std::normal_distribution<double> normal;
  const auto random = [&] { return Eigen::Vector3d(normal(rng), normal(rng), normal(rng)); };
  for (int trial = 0; trial < 50; ++trial) {
    const Hinge<double> a = axis(random(), random()), b = axis(random(), random());
    Eigen::Matrix<double, 3, 2> along;
    along << a.direction, -b.direction;
    const Eigen::Vector2d at = along.colPivHouseholderQr().solve(b.point - a.point);
    const Eigen::Vector3d apart = b.point + b.direction * at[1] - a.point - a.direction * at[0];
    const AxisOffset offset = axis_offset(a, b, kX);
    EXPECT_NEAR(offset.distance, apart.norm(), 1e-12);
    EXPECT_NEAR(offset.beyond, apart.x(), 1e-12);
  }
}

// The tip on x, hinges along y and z that were stated far off: their points come back to x.
TEST(AxisPoints, LieOnTheirAxesWhereABoneWouldCross) {
  TendonModel<double> model;
  model.tree = {{-1, 0, 1, 0, kY, {0, 0, 0}},
                {0, 1, 1, 0, kZ, {0.03, 0, 7}},
                {1, 2, 1, 0, kY, {0.06, -5, 0}}};
  model.coordinates = 3;
  model.tip_link = 2;
  model.tip = {0.09, 0, 0};
  const TreeState<double> state = pose_tree(model.tree, Eigen::Vector3d(0, 0, 0));
  const std::vector<Eigen::Vector3d> points = axis_points(model, state);
  ASSERT_EQ(points.size(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR((points[i] - 0.03 * i * kX).norm(), 0, 1e-9) << i;
}

}  // namespace
}  // namespace thenar
