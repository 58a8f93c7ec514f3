// Tests for geometry/capsule_fit.cpp.

#include "geometry/capsule_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/tessellate.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

/// Points of the surface of two balls' hull: on cones, rings of balls, in any pose.
TriangleMesh on_capsule(double lower, double upper, double length, const Pose<double>& X) {
  // In the half plane of (rho, z): arcs about both centres, which meet the line at the angle of
  // the cone.
  const double sine = (lower - upper) / length, angle = std::asin(sine);
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i <= 8; ++i) {
    const double down = -kPi / 2 + (kPi / 2 + angle) * i / 8,
                 up = angle + (kPi / 2 - angle) * i / 8;
    outline.emplace_back(lower * std::cos(down), -length / 2 + lower * std::sin(down));
    outline.emplace_back(upper * std::cos(up), length / 2 + upper * std::sin(up));
  }
  TriangleMesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(outline.size()) * 12);
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (int k = 0; k < 12; ++k)
      mesh.vertices.col(static_cast<Eigen::Index>(i) * 12 + k) =
          X * Eigen::Vector3d(outline[i].x() * std::cos(kPi * k / 6),
                              outline[i].x() * std::sin(kPi * k / 6), outline[i].y());
  return mesh;
}

/// Centre of the ball of a fit that is nearer to a point, and its radius.
Eigen::Vector4d ball_near(const CapsuleFit& fit, const Eigen::Vector3d& p) {
  const Eigen::Vector3d half(0, 0, fit.shape.size[2] / 2);
  const Eigen::Vector3d lower = fit.shape.X_BS * Eigen::Vector3d(-half),
                        upper = fit.shape.X_BS * half;
  Eigen::Vector4d out;
  if ((lower - p).norm() < (upper - p).norm())
    out << lower, fit.shape.size[0];
  else
    out << upper, fit.shape.size[1];
  return out;
}

TEST(CapsuleFit, FindsTheCapsuleThatThereIs) {
  Pose<double> X;
  X.R = rotation_about<double>(Eigen::Vector3d(1, 2, 3).normalized(), 0.7);
  X.p = {0.1, -0.2, 0.3};
  const CapsuleFit fit = fit_tapered_capsule(on_capsule(0.009, 0.006, 0.03, X));
  EXPECT_LT(fit.max_distance, 1e-8);
  EXPECT_LT(fit.rms_distance, fit.max_distance);
  const Eigen::Vector3d lower = X * Eigen::Vector3d(0, 0, -0.015),
                        upper = X * Eigen::Vector3d(0, 0, 0.015);
  EXPECT_TRUE(matrix_near(ball_near(fit, lower),
                          Eigen::Vector4d(lower.x(), lower.y(), lower.z(), 0.009), 1e-7));
  EXPECT_TRUE(matrix_near(ball_near(fit, upper),
                          Eigen::Vector4d(upper.x(), upper.y(), upper.z(), 0.006), 1e-7));
}

// Of points at radii r + d and r - d about an axis by turns, the capsule of radius r is nearest,
// and misses all of them by d.
TEST(CapsuleFit, TellsHowFarItMisses) {
  TriangleMesh mesh = on_capsule(0.01, 0.01, 0.05, {});
  const TriangleMesh thin = on_capsule(0.0098, 0.0098, 0.05, {}),
                     thick = on_capsule(0.0102, 0.0102, 0.05, {});
  mesh.vertices << thin.vertices.leftCols(mesh.vertices.cols());
  mesh.vertices.conservativeResize(3, 2 * thin.vertices.cols());
  mesh.vertices.rightCols(thick.vertices.cols()) = thick.vertices;
  const CapsuleFit fit = fit_tapered_capsule(mesh);
  EXPECT_NEAR(fit.max_distance, 2e-4, 1e-8);
  EXPECT_NEAR(fit.rms_distance, 2e-4, 1e-8);
  EXPECT_NEAR(fit.shape.size[0], 0.01, 1e-7);
}

TEST(CapsuleFit, RefusesWhatIsNoSurface) {
  TriangleMesh line;
  line.vertices = Eigen::Matrix3Xd::Zero(3, 10);
  EXPECT_THROW((void)fit_tapered_capsule(line), InputError);
  for (int k = 0; k < 10; ++k) line.vertices.col(k) = k * Eigen::Vector3d(1e-3, 0.7e-3, -0.3e-3);
  EXPECT_THROW((void)fit_tapered_capsule(line), InputError);
  line.vertices.conservativeResize(3, 4);
  EXPECT_THROW((void)fit_tapered_capsule(line), InputError);
}

}  // namespace
}  // namespace thenar
