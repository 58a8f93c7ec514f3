// Tests for geometry/solid.cpp.

#include "geometry/solid.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/random_points.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

ShapeSpec spec(ShapeKind kind, const Vector3d& size) {
  ShapeSpec made;
  made.kind = kind;
  made.size = size;
  return made;
}

std::vector<ShapeSpec> round_shapes() {
  ShapeSpec brick = spec(ShapeKind::kSuperellipsoid, {0.02, 0.03, 0.04});
  brick.exponents = {0.1, 0.2};
  return {brick,
          spec(ShapeKind::kSphere, {0.03, 0, 0}),
          spec(ShapeKind::kBox, {0.02, 0.03, 0.04}),
          spec(ShapeKind::kCylinder, {0.035, 0.11, 0}),
          spec(ShapeKind::kCapsule, {0.01, 0.04, 0}),
          spec(ShapeKind::kTaperedCapsule, {0.011, 0.007, 0.03}),
          spec(ShapeKind::kTaperedCapsule, {0.004, 0.02, 0.01}),
          spec(ShapeKind::kEllipsoid, {0.01, 0.02, 0.04}),
          spec(ShapeKind::kEllipsoid, {0.04, 0.04, 0.003})};
}

/// The largest distance from the surface at random points of a touch surface.
double worst(const RoundedMesh& touch, const Shape& shape, std::mt19937& rng) {
  double largest = 0;
  for (Eigen::Index t = 0; t < touch.core.triangles.cols(); ++t)
    for (int i = 0; i < 4; ++i) {
      const double u = uniform(rng), v = uniform(rng) * (1 - u);
      const Eigen::Vector3i corners = touch.core.triangles.col(t);
      const Vector3d p = touch.core.vertices.col(corners(0)) * u +
                         touch.core.vertices.col(corners(1)) * v +
                         touch.core.vertices.col(corners(2)) * (1 - u - v);
      largest = std::max(largest, std::abs(shape.distance(p) + touch.radius));
    }
  return largest;
}

TEST(BuildSolid, DrawsClosedOutwardSurfaces) {
  for (const ShapeSpec& shape : round_shapes()) {
    SCOPED_TRACE(name_of(shape.kind));
    EXPECT_GT(enclosed_volume(build_solid({shape}).visual), 0);
  }
}

TEST(BuildSolid, TouchesWithinTwoHundredthsOfAMillimetre) {
  std::mt19937 rng(1);
  for (const ShapeSpec& shape : round_shapes()) {
    const Solid solid = build_solid({shape});
    EXPECT_LT(worst(solid.collision[0], *solid.shape, rng), 2e-5) << name_of(shape.kind);
    EXPECT_LT(solid.collision[0].core.triangles.cols(), 25000) << name_of(shape.kind);
  }
}

// A surface that is wrong by as much inwards as outwards encloses nearly the
// true volume.
TEST(BuildSolid, DrawsSurfacesOfTheRightVolume) {
  const auto volume = [](ShapeKind kind, const Vector3d& size) {
    return enclosed_volume(build_solid({spec(kind, size)}).visual);
  };
  EXPECT_NEAR(volume(ShapeKind::kSphere, {0.03, 0, 0}) / (4 * kPi / 3 * 2.7e-5), 1, 2e-3);
  EXPECT_NEAR(volume(ShapeKind::kEllipsoid, {0.01, 0.02, 0.04}) / (4 * kPi / 3 * 8e-6), 1, 5e-3);
  EXPECT_NEAR(volume(ShapeKind::kCylinder, {0.03, 0.1, 0}) / (kPi * 9e-5), 1, 2e-3);
  EXPECT_NEAR(volume(ShapeKind::kBox, {0.02, 0.03, 0.04}) / 2.4e-5, 1, 1e-14);
}

TEST(BuildSolid, SweepsBallsAlongPointsAndSegments) {
  const Solid sphere = build_solid({spec(ShapeKind::kSphere, {0.03, 0, 0})});
  EXPECT_EQ(sphere.collision[0].core.triangles.cols(), 1);
  EXPECT_EQ(sphere.collision[0].radius, 0.03);
  const Solid capsule = build_solid({spec(ShapeKind::kCapsule, {0.01, 0.04, 0})});
  EXPECT_EQ(capsule.collision[0].core.triangles.cols(), 1);
  EXPECT_EQ(capsule.collision[0].core.vertices.cols(), 2);
}

TEST(BuildSolid, PlacesShapesInTheirBody) {
  std::mt19937 rng(2);
  ShapeSpec placed = spec(ShapeKind::kEllipsoid, {0.01, 0.02, 0.04});
  placed.X_BS = {random_rotation(rng), {0.1, -0.2, 0.3}};
  const Solid there = build_solid({placed});
  placed.X_BS = {};
  const Solid here = build_solid({placed});
  EXPECT_LT(worst(there.collision[0], *there.shape, rng), 2e-5);
  for (Eigen::Index i = 0; i < there.visual.vertices.cols(); ++i)
    EXPECT_NEAR(there.shape->distance(there.visual.vertices.col(i)),
                here.shape->distance(here.visual.vertices.col(i)), 1e-15);
}

// Two balls of 10 mm whose centres are 10 mm apart.
TEST(BuildSolid, UnionTakesTheNearest) {
  std::vector<ShapeSpec> balls(2, spec(ShapeKind::kSphere, {0.01, 0, 0}));
  balls[1].X_BS.p.x() = 0.01;
  const Solid solid = build_solid(balls);
  EXPECT_NEAR(solid.shape->distance({-0.02, 0, 0}), 0.01, 1e-17);
  EXPECT_NEAR(solid.shape->distance({0.04, 0, 0}), 0.02, 1e-17);
  EXPECT_NEAR(solid.shape->nearest({0.04, 0, 0}).normal.x(), 1, 1e-15);
  EXPECT_EQ(solid.collision.size(), 2U);
  // The nearest surface point, where the balls' surfaces meet, is sqrt(75) mm
  // away; the bound is 5.
  EXPECT_NEAR(solid.shape->distance({0.005, 0, 0}), -0.005, 1e-17);
}

TEST(BuildSolid, UnionOfManyIsTheLeastOfAll) {
  std::mt19937 rng(3);
  std::vector<ShapeSpec> shapes = round_shapes();
  for (ShapeSpec& shape : shapes) shape.X_BS = {random_rotation(rng), 0.1 * random_in_cube(rng)};
  const Solid all = build_solid(shapes);
  std::vector<Solid> each;
  for (const ShapeSpec& shape : shapes) each.push_back(build_solid({shape}));
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = 0.2 * random_in_cube(rng);
    double least = 1;
    for (const Solid& solid : each) least = std::min(least, solid.shape->distance(p));
    EXPECT_EQ(all.shape->distance(p), least);
  }
}

TEST(BuildSolid, RefusesSizesThatAreNone) {
  EXPECT_EQ(message_of([] { (void)build_solid({}); }), "a solid needs at least one shape");
  EXPECT_EQ(message_of([] {
              (void)build_solid({spec(ShapeKind::kBox, {0.1, 0, 0.1})});
            }),
            "size 1 of a box: wanted 1e-09 to 1e+06 m, got 0 m");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] {
              (void)build_solid({spec(ShapeKind::kSphere, {nan, 0, 0})});
            }),
            "size 0 of a sphere: wanted 1e-09 to 1e+06 m, got nan m");
  ShapeSpec star = spec(ShapeKind::kSuperellipsoid, {0.1, 0.1, 0.1});
  star.exponents = {3, 1};
  EXPECT_EQ(message_of([&] { (void)build_solid({star}); }),
            "exponents of a superellipsoid must lie in [0.1, 2], got 3 and 1");
  ShapeSpec stretched = spec(ShapeKind::kSphere, {0.1, 0, 0});
  stretched.X_BS.R *= 2;
  EXPECT_EQ(message_of([&] { (void)build_solid({stretched}); }),
            "a sphere must be placed by a rotation");
}

}  // namespace
}  // namespace thenar
