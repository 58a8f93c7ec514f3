// Tests for geometry/shape_reach.cpp against closed forms and against many points of surfaces.

#include "geometry/shape_reach.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/geometry/manifold/manifold_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

TEST(ShapeReach, IsTheClosedFormOfPlainShapes) {
  EXPECT_EQ(reach_of(spec_of(ShapeKind::kSphere, {0.03, 0, 0}), {0, 0, 0}), 0.03);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kSphere, {0.03, 0, 0}), {0.003, 0, 0.004}), 0.035);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kBox, {0.02, 0.04, 0.04}), {0, 0, 0}), 0.03);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kCylinder, {0.03, 0.08, 0}), {0, 0, 0}), 0.05);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kCylinder, {0.03, 0.06, 0}), {0, 0, 0.01}), 0.05);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kCapsule, {0.01, 0.06, 0}), {0, 0, 0.01}), 0.05);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kTaperedCapsule, {0.02, 0.01, 0.04}), {0, 0, 0}),
                   0.04);
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kEllipsoid, {0.01, 0.04, 0.02}), {0, 0, 0}), 0.04);
  // From a point of its longest axis.
  EXPECT_DOUBLE_EQ(reach_of(spec_of(ShapeKind::kEllipsoid, {0.01, 0.04, 0.02}), {0, 0.01, 0}),
                   0.05);
}

// An octahedron by its tips, and almost a box by its corners.
TEST(ShapeReach, IsThatOfSuperellipsoidsAtTheEndsOfTheirExponents) {
  ShapeSpec octahedron = spec_of(ShapeKind::kSuperellipsoid, {0.01, 0.02, 0.03});
  octahedron.exponents = {2, 2};
  EXPECT_DOUBLE_EQ(reach_of(octahedron, {0, 0, 0.01}), 0.04);
  // Just below, where roots of sums round to 1.
  octahedron.exponents = {2, 2 - 1e-15};
  EXPECT_NEAR(reach_of(octahedron, {0, 0, 0.01}), 0.04, 1e-12);
  // |x/a|^20 + |y/b|^20 + |z/c|^20 = 1  reaches farthest with x in proportion to a^(10/9), by
  // (sum a^(20/9))^(9/20).
  ShapeSpec box = spec_of(ShapeKind::kSuperellipsoid, {0.01, 0.02, 0.02});
  box.exponents = {0.1, 0.1};
  const double sum = std::pow(0.01, 20 / 9.0) + 2 * std::pow(0.02, 20 / 9.0);
  EXPECT_NEAR(reach_of(box, {0, 0, 0}), std::pow(sum, 9 / 20.0), 1e-12);
}

// From near the centre of almost a ball the ascent is slow.
TEST(ShapeReach, HoldsOfAlmostABall) {
  const Vector3d from(1e-4, 0, 0);
  EXPECT_NEAR(reach_of(spec_of(ShapeKind::kEllipsoid, {0.03, 0.03, 0.03}), from), 0.0301, 3e-7);
  EXPECT_NEAR(reach_of(spec_of(ShapeKind::kEllipsoid, {0.03, 0.0299, 0.0298}), from), 0.0301, 3e-7);
}

TEST(ShapeReach, RefusesAPointThatIsNotFinite) {
  EXPECT_THROW((void)reach_of(spec_of(ShapeKind::kSphere, {0.03, 0, 0}), {std::nan(""), 0, 0}),
               InputError);
}

// No point of the surface is farther, and one of a fine grid is almost as far.
TEST(ShapeReach, NoPointOfASuperellipsoidIsFarther) {
  const Vector3d from(0.004, -0.003, 0.002);
  for (const Eigen::Vector2d& e :
       {Eigen::Vector2d(1, 1), Eigen::Vector2d(0.3, 1.7), Eigen::Vector2d(1.9, 0.2)}) {
    ShapeSpec spec = spec_of(ShapeKind::kSuperellipsoid, {0.02, 0.03, 0.025});
    spec.exponents = e;
    double farthest = 0;
    const auto power = [](double x, double p) {
      return std::copysign(std::pow(std::abs(x), p), x);
    };
    constexpr int kGrid = 1000;
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j < 2 * kGrid; ++j) {
        const double v = kPi * (i - kGrid / 2.0) / kGrid, w = kPi * j / kGrid;
        const Vector3d point(0.02 * power(std::cos(v), e[0]) * power(std::cos(w), e[1]),
                             0.03 * power(std::cos(v), e[0]) * power(std::sin(w), e[1]),
                             0.025 * power(std::sin(v), e[0]));
        farthest = std::max(farthest, (point - from).norm());
      }
    EXPECT_GE(reach_of(spec, from), farthest - 1e-15) << e.transpose();
    EXPECT_NEAR(reach_of(spec, from), farthest, 2e-5) << e.transpose();
  }
}

TEST(ShapeReach, CountsWhereTheShapeStands) {
  ShapeSpec cylinder = spec_of(ShapeKind::kCylinder, {0.03, 0.08, 0});
  cylinder.X_BS.p = {0.1, 0, 0};
  cylinder.X_BS.R = rotation_about<double>({0, 1, 0}, kPi / 2);  // its axis along x
  EXPECT_NEAR(reach_of(cylinder, {0, 0, 0}), std::hypot(0.14, 0.03), 1e-15);
}

}  // namespace
}  // namespace thenar
