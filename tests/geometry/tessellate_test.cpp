// Tests for geometry/tessellate.cpp: closed surfaces within their tolerance.

#include "geometry/tessellate.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/primitives.h"
#include "tests/geometry/enclosed_volume.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

TEST(Tessellate, BoxesEncloseTheirVolume) {
  EXPECT_NEAR(enclosed_volume(box_mesh({2, 3, 4})), 24, 1e-13);
}

// A prism on a regular polygon of radius r:  n / 2 r^2 sin(2 pi / n) h.
TEST(Tessellate, RevolvesAProfileToAPrism) {
  const int sides = 7;
  const double r = 2, h = 3;
  const TriangleMesh prism = surface_of_revolution({{0, 0}, {r, 0}, {r, h}, {0, h}}, sides);
  EXPECT_NEAR(enclosed_volume(prism), sides / 2.0 * r * r * std::sin(2 * kPi / sides) * h, 1e-12);
}

// A polygon whose corners stand outside by as much as its sides sink in leaves the circle by no
// more than the tolerance, and one with four sides less would.
TEST(Tessellate, PolygonsLeaveACircleByTheToleranceAtMost) {
  for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
    const int sides = sides_of_circle(1, tolerance);
    const double outside = corner_overshoot(sides),
                 inside = 1 - (1 + outside) * std::cos(kPi / sides);
    EXPECT_NEAR(outside, inside, 1e-12);
    EXPECT_LE(outside, tolerance * (1 + 2 * tolerance));
    if (sides > 12) {
      EXPECT_GT(corner_overshoot(sides - 4), tolerance);
    }
  }
}

// Corners and middles of triangles are within the tolerance of the solid, to both sides.
TEST(Tessellate, SurfacesStayWithinTheTolerance) {
  const double tolerance = 1e-3;
  for (const auto& shape : {build_sphere(1), build_ellipsoid({1, 0.5, 0.3})}) {
    const TriangleMesh mesh = tessellate(*shape, tolerance);
    double most = 0, least = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const Vector3d a = mesh.vertices.col(mesh.triangles(0, t)),
                     b = mesh.vertices.col(mesh.triangles(1, t)),
                     c = mesh.vertices.col(mesh.triangles(2, t));
      for (const Vector3d& p : {a, Vector3d((a + b) / 2), Vector3d((a + b + c) / 3)}) {
        most = std::max(most, shape->distance(p));
        least = std::min(least, shape->distance(p));
      }
    }
    EXPECT_LT(most, 1.5 * tolerance);
    EXPECT_GT(least, -1.5 * tolerance);
    EXPECT_GT(most, 0.2 * tolerance);  // no more triangles than are needed
  }
}

TEST(Tessellate, VolumesComeNearTheSolid) {
  const double ball = 4 * kPi / 3;
  EXPECT_NEAR(enclosed_volume(tessellate(*build_sphere(1), 1e-3)), ball, 1e-3 * 4 * kPi);
  EXPECT_NEAR(enclosed_volume(tessellate(*build_ellipsoid({1, 0.5, 0.3}), 1e-3)), 0.15 * ball,
              0.02 * 0.15 * ball);
}

// The octant alone has no negative coordinate, and its triangles face outwards.
TEST(Tessellate, AnOctantStaysInItsOctant) {
  const TriangleMesh octant = tessellate_octant(*build_ellipsoid({1, 0.5, 0.3}), 1e-3);
  EXPECT_GE(octant.vertices.minCoeff(), -1e-9);
  double cone = 0;  // volume between the octant and the origin
  for (Eigen::Index t = 0; t < octant.triangles.cols(); ++t) {
    const Vector3d a = octant.vertices.col(octant.triangles(0, t)),
                   b = octant.vertices.col(octant.triangles(1, t)),
                   c = octant.vertices.col(octant.triangles(2, t));
    EXPECT_GT(a.dot(b.cross(c)), 0);
    cone += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(cone, 0.15 * kPi / 6, 0.02 * 0.15 * kPi / 6);
}

}  // namespace
}  // namespace thenar
