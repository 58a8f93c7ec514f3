// Tests for tendons/net/band_course.cpp: runs whose course is plain geometry.

#include "tendons/net/band_course.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kHeadRadius = 0.005;

/// One band between two fixed points over a bone of that shape about the origin; z is its axis.
struct BandScene {
  explicit BandScene(SurfaceShape shape, const Vector3d& a, const Vector3d& b) {
    net.surfaces = {{"bone", -1, shape, {kHeadRadius, 0.01, 0}, {}}};
    net.nodes = {{"a", false, -1, a, {}}, {"b", false, -1, b, {}}};
    NetBand band{"band", 0, 1};
    band.over = 0;
    net.bands = {band};
    rest.x.resize(3, 2);
    rest.x << a, b;
  }
  [[nodiscard]] BandCourse course() const { return band_course(net, {}, rest, 0); }
  Net net;
  NetEquilibrium rest;
};

double length(const std::vector<Vector3d>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

TEST(BandCourse, RunsStraightPastABone) {
  const BandScene scene(SurfaceShape::kCylinder, {-0.02, 0.006, 0}, {0.02, 0.006, 0});
  const BandCourse course = scene.course();
  EXPECT_FALSE(course.bent);
  EXPECT_EQ(course.points.size(), 2U);
}

// From (-2r, 0) to (2r, 0): two tangents of r sqrt(3), and an arc of pi - 2 * 60 degrees.
TEST(BandCourse, BendsOverACylinderOnItsSide) {
  const BandScene scene(SurfaceShape::kCylinder, {-2 * kHeadRadius, 0, 0}, {2 * kHeadRadius, 0, 0});
  const BandCourse course = scene.course();
  ASSERT_TRUE(course.bent);
  for (std::size_t i = 1; i + 1 < course.points.size(); ++i) {
    EXPECT_NEAR(course.points[i].norm(), kHeadRadius, 1e-12);
    EXPECT_GT(course.points[i].y(), 0);
  }
  const double exact = kHeadRadius * (2 * std::sqrt(3.0) + kPi / 3);
  // Twelve chords of an arc of 60 degrees fall short by (5 deg)^2 / 24 of it.
  const double shortfall = kHeadRadius * kPi / 3 * std::pow(kPi / 36, 2) / 24;
  EXPECT_NEAR(length(course.points), exact - shortfall, 1e-3 * shortfall);
}

// Unrolled, a run along the axis as well is the hypotenuse.
TEST(BandCourse, BendsOverACylinderAsAHelix) {
  const BandScene scene(SurfaceShape::kCylinder, {-2 * kHeadRadius, 0, -0.004},
                        {2 * kHeadRadius, 0, 0.004});
  const BandCourse course = scene.course();
  const double flat = kHeadRadius * (2 * std::sqrt(3.0) + kPi / 3);
  EXPECT_NEAR(length(course.points), std::hypot(flat, 0.008), 1e-4 * flat);
  EXPECT_NEAR(course.points[course.points.size() / 2].z(), 0, 1e-3);
}

TEST(BandCourse, BendsOverASphereInThePlaneOfItsEnds) {
  const BandScene scene(SurfaceShape::kSphere, {-0.008, 0.003, 0}, {0.008, 0.003, 0});
  const BandCourse course = scene.course();
  ASSERT_TRUE(course.bent);
  for (const Vector3d& p : course.points) EXPECT_NEAR(p.z(), 0, 1e-15);
  EXPECT_NEAR(course.points[course.points.size() / 2].norm(), kHeadRadius, 1e-12);
}

TEST(BandCourse, RefusesABandThatIsNotThere) {
  const BandScene scene(SurfaceShape::kSphere, {0, 0.01, 0}, {0.01, 0, 0});
  EXPECT_THROW((void)band_course(scene.net, {}, scene.rest, 1), InputError);
}

}  // namespace
}  // namespace thenar
