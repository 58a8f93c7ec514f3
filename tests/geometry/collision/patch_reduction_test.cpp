// Tests for geometry/collision/patch_reduction.cpp.

#include "geometry/collision/patch_reduction.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "grasp/closing/approach_sampling.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kMerge = 1.5e-3;  // [m]

Eigen::Matrix2Xd circle(int corners, double radius) {
  Eigen::Matrix2Xd points(2, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    points.col(i) = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

/// Distance of a point from the convex polygon of the kept ones, given counterclockwise: 0 within.
double outside(const Eigen::Matrix2Xd& points, const std::vector<int>& kept,
               const Eigen::Vector2d& p) {
  double nearest = 1e9;
  bool within = true;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Eigen::Vector2d a = points.col(kept[k]);
    const Eigen::Vector2d side = points.col(kept[(k + 1) % kept.size()]) - a, arm = p - a;
    const double t = std::clamp(arm.dot(side) / side.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (arm - t * side).norm());
    within = within && side.x() * arm.y() - side.y() * arm.x() >= 0;
  }
  return within ? 0 : nearest;
}

double greatest_outside(const Eigen::Matrix2Xd& points, const std::vector<int>& kept) {
  double loss = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    loss = std::max(loss, outside(points, kept, points.col(i)));
  return loss;
}

// Every point is asked of every side.
TEST(ReducePoints, LosesWhatIsFarthestFromTheKeptHull) {
  std::mt19937 random(1);
  for (int turn = 0; turn < 50; ++turn) {
    Eigen::Matrix2Xd points(2, 60);
    for (double& x : points.reshaped()) x = sample_between(-0.02, 0.02, random);
    points.colwise().normalize();  // all on the hull, unevenly
    points *= 0.02;
    for (const int most : {3, 5, 8, 20}) {
      const ReducedPoints reduced = reduce_points(points, kMerge, most);
      EXPECT_LE(reduced.kept.size(), static_cast<std::size_t>(most));
      EXPECT_NEAR(reduced.loss, greatest_outside(points, reduced.kept), 1e-15);
    }
  }
}

// Nine corners on a circle leave at least the sagitta of a ninth of it: more than a tenth of
// `merge`, so that none is dropped.
TEST(ReducePoints, KeepsCornersThatCount) {
  const ReducedPoints reduced = reduce_points(circle(9, 0.02), kMerge, 9);
  EXPECT_EQ(reduced.kept.size(), 9U);
  EXPECT_EQ(reduced.loss, 0);
}

// A disc on a plane has as many corners as its rim was cut into.
TEST(ReducePoints, ReducesThousandsOfCornersWithinTheirSagitta) {
  const double radius = 0.03;
  const Eigen::Matrix2Xd points = circle(4000, radius);
  const ReducedPoints reduced = reduce_points(points, kMerge, 8);
  EXPECT_EQ(reduced.kept.size(), 8U);
  // No eight corners lose less than regular ones.
  EXPECT_GE(reduced.loss, radius * (1 - std::cos(kPi / 8)) * (1 - 1e-3));
  EXPECT_NEAR(reduced.loss, greatest_outside(points, reduced.kept), 1e-15);
}

TEST(ReducePoints, TakesTwoPointsOfAnEdgeAndOneOfASpeck) {
  Eigen::Matrix2Xd edge(2, 3);
  edge << 0, 0.01, 0.02, 0, 2e-4, 0;
  EXPECT_EQ(reduce_points(edge, kMerge, 8).kept, (std::vector<int>{0, 2}));
  EXPECT_NEAR(reduce_points(edge, kMerge, 8).loss, 2e-4, 1e-15);
  EXPECT_EQ(reduce_points(edge / 20, kMerge, 8).kept, std::vector<int>{0});
}

TEST(ReducePoints, WantsPoints) {
  EXPECT_EQ(message_of([] { (void)reduce_points(Eigen::Matrix2Xd(2, 0), kMerge, 8); }),
            "0 points cannot be reduced: one or more, finite");
}

}  // namespace
}  // namespace thenar
