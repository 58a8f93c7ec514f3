// Tests for geometry/superellipsoid.cpp, against a search of its surface by its equation.

#include "geometry/superellipsoid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/geometry/random_points.h"

namespace thenar {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

const Vector3d kAxes(0.02, 0.03, 0.04);  // [m]

/// The power of the published equation that is of degree one.
double norm_of(const Vector3d& p, const Vector2d& e) {
  const Vector3d u = p.cwiseAbs().cwiseQuotient(kAxes);
  const double disc = std::pow(u.x(), 2 / e(1)) + std::pow(u.y(), 2 / e(1));
  return std::pow(std::pow(disc, e(1) / e(0)) + std::pow(u.z(), 2 / e(0)), e(0) / 2);
}

/// Points all over the surface of one octant.
Eigen::Matrix3Xd surface(const Vector2d& e, std::mt19937& rng) {
  Eigen::Matrix3Xd points(3, 10000);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Vector3d p = random_direction(rng).cwiseAbs().cwiseProduct(kAxes);
    points.col(i) = p / norm_of(p, e);
  }
  return points;
}

/// The nearest of them, moved about at random by less and less: an upper bound of the distance, and
/// unless a better valley was missed the distance itself.
double searched(const Vector3d& p, const Vector2d& e, const Eigen::Matrix3Xd& points,
                std::mt19937& rng) {
  Eigen::Index nearest;
  (points.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  Vector3d best = points.col(nearest);
  double reach = 2e-3;
  while (reach > 1e-11) {
    bool better = false;
    for (int i = 0; i < 12; ++i) {
      Vector3d x = (best + reach * random_in_cube(rng)).cwiseMax(0.0);
      if (i % 3 == 0) x(i / 3 % 3) = i < 9 ? 0 : x(0);  // edges may lie on the planes of symmetry
      x /= norm_of(x, e);
      if (!x.allFinite() || (x - p).squaredNorm() >= (best - p).squaredNorm()) continue;
      best = x;
      better = true;
    }
    reach *= better ? 0.97 : 0.8;
  }
  return std::copysign((best - p).norm(), norm_of(p, e) - 1);
}

const std::vector<Vector2d> kSmooth{{1, 1}, {0.5, 0.5}, {0.3, 1.2}, {1.5, 1}, {0.7, 1.3}};
const std::vector<Vector2d> kSharp{{0.1, 0.1}, {0.1, 1}, {2, 2},      {2, 0.1},
                                   {0.1, 2},   {1, 2},   {1.9, 1.95}, {1.5, 1.5}};

void expect_searched(const Vector2d& e, double tolerance, int count) {
  std::mt19937 rng(1);
  const auto shape = build_superellipsoid(kAxes, e);
  const Eigen::Matrix3Xd points = surface(e, rng);
  for (int i = 0; i < count; ++i) {
    const Vector3d p = points.col(i) * (i % 2 ? 1 + 2 * uniform(rng) : uniform(rng));
    EXPECT_NEAR(shape->distance(p), searched(p, e, points, rng), tolerance)
        << e.transpose() << " at " << p.transpose();
  }
}

TEST(Superellipsoid, IsTheNearestOfASearchWhereSmooth) {
  for (const Vector2d& e : kSmooth) expect_searched(e, 1e-7, 25);
}
TEST(Superellipsoid, IsTheNearestOfASearchWithinItsAccuracyWhereSharp) {
  for (const Vector2d& e : kSharp)
    expect_searched(e, build_superellipsoid(kAxes, e)->accuracy(), 25);
}

TEST(Superellipsoid, IsAnEllipsoidOfExponentsOne) {
  std::mt19937 rng(2);
  const auto shape = build_superellipsoid(kAxes, {1, 1}), exact = build_ellipsoid(kAxes);
  for (int i = 0; i < queries(5000); ++i) {
    const Vector3d p = 0.1 * random_in_cube(rng);
    EXPECT_NEAR(shape->distance(p), exact->distance(p), 1e-9) << p.transpose();
    if (exact->distance(p) < 0) continue;  // foci: the foot may be anywhere around them
    EXPECT_LT((shape->nearest(p).normal - exact->nearest(p).normal).norm(), 1e-4);
  }
}

// By hand: a face of the octahedron x/a + y/b + z/c = 1.
TEST(Superellipsoid, IsAnOctahedronOfExponentsTwo) {
  const auto shape = build_superellipsoid(kAxes, {2, 2});
  const Vector3d slope = kAxes.cwiseInverse();
  EXPECT_NEAR(shape->distance({0, 0, 0}), -1 / slope.norm(), 1e-12);
  const Vector3d out = kAxes / 3 + 0.01 * slope.normalized();
  EXPECT_NEAR(shape->distance(out), 0.01, 1e-12);
  EXPECT_NEAR(shape->distance({0, 0, 0.05}), 0.01, 1e-9);  // beyond its tip
}

TEST(Superellipsoid, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(3);
  for (const Vector2d& e : kSharp) {
    const auto shape = build_superellipsoid(kAxes, e);
    for (int i = 0; i < queries(1000); ++i) {
      const Vector3d p = 0.06 * random_in_cube(rng), q = p + 0.004 * random_in_cube(rng);
      const double way = (p - q).norm();
      EXPECT_LE(std::abs(shape->distance(p) - shape->distance(q)), way + 2 * shape->accuracy());
    }
  }
}

TEST(Superellipsoid, IsSupportedByItsNearestPlanes) {
  std::mt19937 rng(4);
  std::vector<Vector2d> all = kSharp;
  all.insert(all.end(), kSmooth.begin(), kSmooth.end());
  int supporting = 0;
  constexpr int kPairs = 500;
  for (const Vector2d& e : all) {
    const auto shape = build_superellipsoid(kAxes, e);
    for (int i = 0; i < kPairs; ++i) {
      const Vector3d p = 0.06 * random_in_cube(rng), q = 0.06 * random_in_cube(rng);
      const NearestSurface near = shape->nearest(p);
      if (!near.supports) continue;
      ++supporting;
      EXPECT_GE(shape->distance(q),
                near.distance + near.normal.dot(q - p) - shape->accuracy() - 1e-12)
          << e.transpose();
    }
  }
  EXPECT_GT(supporting, 0.9 * kPairs * static_cast<double>(all.size()));
}

TEST(Superellipsoid, HasAnAnswerOnItsPlanesAndAxes) {
  for (const Vector2d& e : kSharp) {
    const auto shape = build_superellipsoid(kAxes, e);
    for (int i = 0; i < 125; ++i) {
      const Vector3d grid = Eigen::Vector3i(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2).cast<double>();
      const Vector3d p = 0.5 * grid.cwiseProduct(kAxes);
      const NearestSurface near = shape->nearest(p);
      EXPECT_NEAR(near.normal.norm(), 1, 1e-12) << e.transpose() << " at " << p.transpose();
      EXPECT_EQ(near.distance > 1e-12, norm_of(p, e) > 1 + 1e-9) << p.transpose();
      EXPECT_EQ(shape->distance(-p), near.distance);
    }
  }
}

}  // namespace
}  // namespace thenar
