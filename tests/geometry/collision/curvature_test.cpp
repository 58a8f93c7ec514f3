// Tests for geometry/collision/curvature.cpp: against surfaces whose curvatures are known.

#include "geometry/collision/curvature.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/primitives.h"
#include "geometry/solid.h"
#include "tests/geometry/collision/analytic_shapes.h"

namespace thenar {
namespace {

constexpr double kStep = 1e-3;  // [m]

/// Of an arc: what the step leaves out, and 2 % of it for the next order.
double truncation(double k) { return 1.02 * std::abs(k * k * k) * kStep * kStep / 4 + 1e-6; }

TEST(Curvature, OfASphere) {
  constexpr double kR = 0.01;
  const PrincipalCurvatures found =
      curvatures(*build_sphere(kR), kR * Eigen::Vector3d(1, 2, -2) / 3, kStep);
  EXPECT_NEAR(found.k1, 1 / kR, truncation(1 / kR));
  EXPECT_NEAR(found.k2, 1 / kR, truncation(1 / kR));
}

TEST(Curvature, OfACylinderIsRoundAcrossAndFlatAlong) {
  constexpr double kR = 0.008;
  const Eigen::Vector3d p(kR * std::cos(0.7), kR * std::sin(0.7), 0.003);
  const PrincipalCurvatures found = curvatures(*build_cylinder(kR, 0.05), p, kStep);
  EXPECT_NEAR(found.k1, 1 / kR, truncation(1 / kR));
  // Four directions on an arc give cos(4 x) of the next order to the flat one, a quarter of it.
  EXPECT_NEAR(found.k2, 0, truncation(1 / kR));
  EXPECT_NEAR(std::abs(found.d1.dot(Eigen::Vector3d(-std::sin(0.7), std::cos(0.7), 0))), 1, 1e-6);
}

// At the end of semi-axis c: c / a^2 and c / b^2.
TEST(Curvature, OfAnEllipsoidAtItsEnds) {
  constexpr double kA = 0.02, kB = 0.03, kC = 0.015;
  const PrincipalCurvatures found =
      curvatures(*build_ellipsoid({kA, kB, kC}), {0, 0, kC}, kStep / 4);
  EXPECT_NEAR(found.k1, kC / (kA * kA), 0.02);
  EXPECT_NEAR(found.k2, kC / (kB * kB), 0.02);
  EXPECT_NEAR(std::abs(found.d1.x()), 1, 1e-6);
}

TEST(Curvature, OfAFaceIsNone) {
  const PrincipalCurvatures found =
      curvatures(*build_box({0.04, 0.04, 0.02}), {0.005, -0.003, 0.01}, kStep);
  EXPECT_NEAR(found.k1, 0, 1e-9);
  EXPECT_NEAR(found.k2, 0, 1e-9);
}

// The inner equator of a torus: round across its tube, hollow around its hole.
TEST(Curvature, OfASaddleHasBothSigns) {
  constexpr double kRing = 0.03, kTube = 0.01;
  const Solid torus = solid_of([](const Eigen::Vector3d& p) {
    return std::hypot(p.head<2>().norm() - kRing, p.z()) - kTube;
  });
  const PrincipalCurvatures found = curvatures(*torus.shape, {kRing - kTube, 0, 0}, kStep);
  EXPECT_NEAR(found.k1, 1 / kTube, truncation(1 / kTube));
  EXPECT_NEAR(found.k2, -1 / (kRing - kTube), truncation(1 / kTube));
  EXPECT_NEAR(std::abs(found.d1.z()), 1, 1e-4);
}

// Facets are flat; over a step wider than they are the ball behind them shows.
TEST(Curvature, OfFacetsIsThatOfTheirBallOverAWiderStep) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kSphere;
  spec.size = {0.01, 0, 0};
  ShapeSpec mesh;
  mesh.kind = ShapeKind::kMesh;
  mesh.mesh = build_solid({spec}).visual;
  double edge = 0;
  for (const auto& t : mesh.mesh.triangles.colwise())
    edge = std::max(edge, (mesh.mesh.vertices.col(t[0]) - mesh.mesh.vertices.col(t[1])).norm());
  const Solid solid = build_solid({mesh});
  const double h = 2.5 * edge, sagitta = edge * edge / (6 * 0.01);  // of a regular facet
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0.3, 0.5, 0.8), Eigen::Vector3d(1, 0.1, 0)}) {
    const Eigen::Vector3d p = 0.01 * way.normalized();
    const PrincipalCurvatures found = curvatures(*solid.shape, p, h);
    const double slack = 4 * sagitta / (h * h) + 100 * h * h * 100 * 100 / 4;
    EXPECT_NEAR(found.k1, 100, slack);
    EXPECT_NEAR(found.k2, 100, slack);
  }
}

TEST(Curvature, OfGapsAddsHessians) {
  const PrincipalCurvatures a{120, 30, {1, 0, 0}}, b{50, -20, {1, 0, 0}};
  for (const double angle : {0.0, 0.4, kPi / 2, 2.0}) {
    const auto hessian = [](const PrincipalCurvatures& k, double turn) {
      const Eigen::Rotation2Dd R(turn);
      return Eigen::Matrix2d(R * Eigen::Vector2d(k.k1, k.k2).asDiagonal() *
                             R.inverse().toRotationMatrix());
    };
    const Eigen::Vector2d expected =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian(a, 0) + hessian(b, angle))
            .eigenvalues();
    const RelativeCurvatures gap = relative_curvatures(a, b, angle);
    EXPECT_NEAR(gap.k1, expected(1), 1e-10);
    EXPECT_NEAR(gap.k2, expected(0), 1e-10);
  }
}

// Two like cylinders crossed at right angles touch as a ball on a plane.
TEST(Curvature, OfCrossedCylindersIsABallOnAPlane) {
  const PrincipalCurvatures cylinder{125, 0, {1, 0, 0}};
  const RelativeCurvatures gap = relative_curvatures(cylinder, cylinder, kPi / 2);
  EXPECT_NEAR(gap.k1, 125, 1e-12);
  EXPECT_NEAR(gap.k2, 125, 1e-12);
}

TEST(Curvature, RejectsImpossibleQuestions) {
  EXPECT_THROW((void)curvatures(*build_sphere(1), {1, 0, 0}, 0), InputError);
  EXPECT_THROW((void)curvatures(*build_sphere(1), {std::nan(""), 0, 0}), InputError);
}

}  // namespace
}  // namespace thenar
