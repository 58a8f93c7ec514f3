// Laws that every primitive solid obeys, against equations of their surfaces
// written anew.

#include "geometry/primitives.h"

#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/geometry/random_points.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

/// A solid and a function that is negative inside it, which is no distance.
struct Case {
  std::string name;
  std::shared_ptr<const Shape> shape;
  std::function<double(const Vector3d&)> implicit;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

/// Within the hull of two balls lies what some ball between them holds.
double between_balls(const Vector3d& p, double lower, double upper, double length) {
  const auto excess = [&](double share) {
    const double radius = lower + share * (upper - lower);
    return (p - Vector3d(0, 0, (share - 0.5) * length)).norm() - radius;
  };
  double from = 0, to = 1;  // convex in the share: golden section
  for (int i = 0; i < 60; ++i) {
    const double a = from + 0.382 * (to - from), b = from + 0.618 * (to - from);
    (excess(a) < excess(b) ? to : from) = excess(a) < excess(b) ? b : a;
  }
  return std::min({excess(from), excess(0), excess(1)});
}

Case ellipsoid(const std::string& name, const Vector3d& e) {
  return {name, build_ellipsoid(e),
          [e](const Vector3d& p) { return p.cwiseQuotient(e).norm() - 1; }};
}

Case tapered(const std::string& name, double lower, double upper, double length) {
  return {name, build_tapered_capsule(lower, upper, length),
          [=](const Vector3d& p) { return between_balls(p, lower, upper, length); }};
}

std::vector<Case> cases() {
  return {
      {"sphere", build_sphere(0.03), [](const Vector3d& p) { return p.norm() - 0.03; }},
      {"box", build_box({0.02, 0.05, 0.08}),
       [](const Vector3d& p) {
         return p.cwiseAbs().cwiseQuotient(Vector3d(0.01, 0.025, 0.04)).maxCoeff() - 1;
       }},
      {"cylinder", build_cylinder(0.03, 0.1),
       [](const Vector3d& p) {
         return std::max(p.head<2>().norm() / 0.03, std::abs(p.z()) / 0.05) - 1;
       }},
      tapered("capsule", 0.01, 0.01, 0.04),
      tapered("tapered_capsule", 0.01, 0.006, 0.025),
      tapered("tapered_capsule_upwards", 0.004, 0.012, 0.03),
      tapered("ball_in_ball", 0.02, 0.005, 0.01),
      ellipsoid("ellipsoid", {0.02, 0.05, 0.03}),
      ellipsoid("needle", {0.002, 0.002, 0.06}),
      ellipsoid("disc", {0.05, 0.05, 0.001}),
      ellipsoid("ball", {0.03, 0.03, 0.03}),
  };
}

/// Where the equation says that a ray from the origin leaves the solid.
Vector3d on_ray(const Case& c, const Vector3d& direction) {
  double inside = 0, outside = 1;
  while (outside - inside > 1e-16) {
    const double middle = (inside + outside) / 2;
    if (middle <= inside || middle >= outside) break;
    (c.implicit(middle * direction) < 0 ? inside : outside) = middle;
  }
  return inside * direction;
}

Vector3d near_it(const Case& c, std::mt19937& rng) {
  return 1.5 * random_in_cube(rng).cwiseProduct(c.shape->bounds().max());
}

class Primitive : public testing::TestWithParam<Case> {};

TEST_P(Primitive, IsNegativeInside) {
  std::mt19937 rng(1);
  for (int i = 0; i < 10000; ++i) {
    const Vector3d p = near_it(GetParam(), rng);
    const double d = GetParam().shape->distance(p);
    if (std::abs(d) > 1e-9) {
      EXPECT_EQ(d < 0, GetParam().implicit(p) < 0);
    }
  }
}

// The foot is on the surface: a step to either side of it changes the side.
TEST_P(Primitive, FootLiesOnTheSurface) {
  std::mt19937 rng(2);
  for (int i = 0; i < queries(2000); ++i) {
    const Vector3d p = near_it(GetParam(), rng);
    const NearestSurface near = GetParam().shape->nearest(p);
    const Vector3d foot = p - near.distance * near.normal;
    EXPECT_NEAR(near.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(near.distance, GetParam().shape->distance(p), 1e-15);
    EXPECT_LT(GetParam().implicit(foot - 1e-9 * near.normal), 1e-12) << p.transpose();
    EXPECT_GT(GetParam().implicit(foot + 1e-9 * near.normal), -1e-12) << p.transpose();
  }
}

TEST_P(Primitive, HasNoSurfaceNearerThanItsDistance) {
  std::mt19937 rng(3);
  Eigen::Matrix3Xd surface(3, 4000);
  for (Eigen::Index i = 0; i < surface.cols(); ++i)
    surface.col(i) = on_ray(GetParam(), random_direction(rng));
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = near_it(GetParam(), rng);
    const double nearest = std::sqrt((surface.colwise() - p).colwise().squaredNorm().minCoeff());
    EXPECT_GE(nearest, std::abs(GetParam().shape->distance(p)) - 1e-14) << p.transpose();
  }
}

TEST_P(Primitive, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(4);
  for (int i = 0; i < queries(10000); ++i) {
    const Vector3d p = near_it(GetParam(), rng);
    const Vector3d q = p + 0.01 * uniform(rng) * random_direction(rng);
    EXPECT_LE(std::abs(GetParam().shape->distance(p) - GetParam().shape->distance(q)),
              (p - q).norm() + 1e-15);
  }
}

TEST_P(Primitive, IsSupportedByItsNearestPlanes) {
  std::mt19937 rng(6);
  for (int i = 0; i < queries(10000); ++i) {
    const Vector3d p = near_it(GetParam(), rng), q = near_it(GetParam(), rng);
    const NearestSurface near = GetParam().shape->nearest(p);
    EXPECT_TRUE(near.supports);
    EXPECT_GE(GetParam().shape->distance(q), near.distance + near.normal.dot(q - p) - 1e-14);
  }
}

TEST_P(Primitive, HasAnAnswerOnItsPlanesAndAxes) {
  for (int i = 0; i < 125; ++i) {
    const Vector3d grid = Eigen::Vector3i(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2).cast<double>();
    const Vector3d p = 0.5 * grid.cwiseProduct(GetParam().shape->bounds().max());
    const NearestSurface near = GetParam().shape->nearest(p);
    const Vector3d foot = p - near.distance * near.normal;
    EXPECT_NEAR(near.normal.norm(), 1, 1e-12) << p.transpose();
    EXPECT_NEAR(GetParam().shape->distance(foot), 0, 1e-14) << p.transpose();
  }
}

TEST_P(Primitive, LiesInItsBounds) {
  std::mt19937 rng(5);
  const Eigen::AlignedBox3d box = GetParam().shape->bounds();
  for (int i = 0; i < 1000; ++i)
    EXPECT_LT(box.exteriorDistance(on_ray(GetParam(), random_direction(rng))), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Primitive, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

// By hand: a corner of the box is 3, 4 and 12 mm away along the axes, so 13 mm
// in all.
TEST(Box, MeasuresFromItsCorner) {
  const auto box = build_box({0.02, 0.02, 0.02});
  EXPECT_NEAR(box->distance({0.013, 0.014, 0.022}), 0.013, 1e-17);
  EXPECT_TRUE(
      matrix_near(box->nearest({0.013, 0.014, -0.022}).normal, Vector3d(3, 4, -12) / 13, 1e-14));
}

// By hand: the side leans by asin(0.6); half way along, the centre lies 3 - 2.5
// * 0.6 deep.
TEST(TaperedCapsule, MeasuresFromItsLeaningSide) {
  const auto cone = build_tapered_capsule(0.004, 0.001, 0.005);
  EXPECT_NEAR(cone->distance({0, 0, 0.0}), -(0.004 - 0.6 * 0.0025), 1e-17);
}

// By hand: from the centre of an ellipsoid the surface is nearest along its
// least axis.
TEST(Ellipsoid, IsAsDeepAsItsLeastAxis) {
  const auto shape = build_ellipsoid({0.02, 0.05, 0.03});
  EXPECT_NEAR(shape->distance({0, 0, 0}), -0.02, 1e-17);
  EXPECT_TRUE(matrix_near(shape->nearest({0, 0, 0}).normal.cwiseAbs(), Vector3d::UnitX(), 1e-14));
}

}  // namespace
}  // namespace thenar
