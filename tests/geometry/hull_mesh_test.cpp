// Tests for geometry/hull_mesh.cpp: hulls that are known, and what every hull obeys.

#include "geometry/hull_mesh.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/units.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/random_points.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kHullMove = 1e-6;  // of points, over their extent [1]

// The corners of a box among points within it: the box, closed and outward.
TEST(HullMesh, OfABoxIsTheBox) {
  std::mt19937 rng(1);
  Matrix3Xd points(3, 200);
  for (int i = 0; i < 8; ++i)
    points.col(i) << ((i & 1) != 0 ? 2 : -2), ((i & 2) != 0 ? 1 : -1), ((i & 4) != 0 ? 3 : -3);
  for (int i = 8; i < 200; ++i)
    points.col(i) = random_in_cube(rng).cwiseProduct(Vector3d(1.9, 0.9, 2.9));
  const TriangleMesh hull = hull_mesh(points);
  EXPECT_EQ(hull.vertices.cols(), 8);
  EXPECT_EQ(hull.triangles.cols(), 12);
  EXPECT_NEAR(enclosed_volume(hull), 48, 48 * 10 * kHullMove);
}

// No point is above a triangle's plane; Euler: 2 V - 4 triangles.
TEST(HullMesh, HoldsAllPoints) {
  std::mt19937 rng(2);
  Matrix3Xd points(3, 300);
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = random_in_cube(rng);
  const TriangleMesh hull = hull_mesh(points);
  EXPECT_EQ(hull.triangles.cols(), 2 * hull.vertices.cols() - 4);
  EXPECT_GT(enclosed_volume(hull), 0);
  for (Eigen::Index t = 0; t < hull.triangles.cols(); ++t) {
    const Vector3d a = hull.vertices.col(hull.triangles(0, t)),
                   b = hull.vertices.col(hull.triangles(1, t)),
                   c = hull.vertices.col(hull.triangles(2, t));
    const Vector3d n = (b - a).cross(c - a).normalized();
    EXPECT_LT((n.transpose() * (points.colwise() - a)).maxCoeff(), 10 * kHullMove);
  }
}

// All points of a sphere are corners, and the volume comes to 4/3 pi from below.
TEST(HullMesh, OfASphereHasAllPointsAsCorners) {
  std::mt19937 rng(3);
  Matrix3Xd points(3, 500);
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = random_direction(rng);
  const TriangleMesh hull = hull_mesh(points);
  EXPECT_EQ(hull.vertices.cols(), 500);
  const double ball = 4 * kPi / 3, volume = enclosed_volume(hull);
  EXPECT_LT(volume, ball);
  EXPECT_GT(volume, 0.97 * ball);
}

// Points there many times change nothing but the last digits.
TEST(HullMesh, TakesPointsThatCoincide) {
  Matrix3Xd points(3, 16);
  for (int i = 0; i < 16; ++i) points.col(i) << (i & 1), ((i >> 1) & 1), ((i >> 2) & 1);
  EXPECT_NEAR(enclosed_volume(hull_mesh(points)), 1, 10 * kHullMove);
}

TEST(HullMesh, IsEmptyWherePointsAreFlat) {
  Matrix3Xd points = Matrix3Xd::Identity(3, 3);
  EXPECT_TRUE(hull_mesh(points).empty());
  std::mt19937 rng(4);
  points.resize(3, 50);
  for (Eigen::Index i = 0; i < 50; ++i)
    points.col(i) = random_in_cube(rng).cwiseProduct(Vector3d(1, 1, 1e-5));
  EXPECT_TRUE(hull_mesh(points).empty());
}

TEST(HullMesh, RefusesPointsThatAreNotFinite) {
  Matrix3Xd points = Matrix3Xd::Identity(3, 5);
  points(1, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { (void)hull_mesh(points); }), "a hull has a point that is not finite");
}

}  // namespace
}  // namespace thenar
