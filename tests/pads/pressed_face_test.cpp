// Tests for pads/pressed_face.cpp.

#include "pads/pressed_face.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/numbers.h"
#include "base/units.h"
#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kSide = 1.6e-3;      // of the face [m]
constexpr double kStiffness = 3.6e9;  // [N/m^3]

/// A level face around the origin, as seen from above.
FaceCorners level_face() {
  FaceCorners out;
  out << -1, 1, -1, 1, -1, -1, 1, 1, 0, 0, 0, 0;
  return kSide / 2 * out;
}

PressedFace pressed_by(const FaceCorners& corners, const Shape& object, const Pose<double>& X) {
  return press_face(corners, Vector4d::Constant(kStiffness), kSide * kSide, object, X);
}

/// A cube of 10 mm that stands on an edge or on a corner at a place above the face.
Pose<double> stands_on_edge(const Vector3d& tip) {
  Pose<double> X;
  X.R = Eigen::AngleAxisd(kPi / 4, Vector3d::UnitY()).toRotationMatrix();
  X.p = tip + Vector3d(0, 0, 5e-3 * std::sqrt(2.0));
  return X;
}
Pose<double> stands_on_corner(const Vector3d& tip) {
  Pose<double> X;
  X.R = Eigen::Quaterniond::FromTwoVectors(Vector3d(-1, -1, -1), Vector3d(0, 0, -1))
            .toRotationMatrix();
  X.p = tip + Vector3d(0, 0, 5e-3 * std::sqrt(3.0));
  return X;
}

// Depth below the sides of a right angle D deep is (D - |s|) / sqrt(2), so the energy of a length
// is k D^3 / 6, wherever it stands.
TEST(PressedFace, HoldsAnEdgeAsTheIntegralSays) {
  const auto cube = build_box({1e-2, 1e-2, 1e-2});
  constexpr double kDepth = 3e-5;
  const double expected = kStiffness * std::pow(kDepth, 3) / 6 * kSide;
  for (int k = 0; k < 200; ++k) {
    const double x = kSide * (0.9 * k / 199 - 0.45);
    const PressedFace face = pressed_by(level_face(), *cube, stands_on_edge({x, 0, -kDepth}));
    EXPECT_NEAR(face.energy / expected, 1, 1e-9) << x;
    EXPECT_NEAR(face.push.row(0).sum(), 0, 1e-9 * -face.push.row(2).sum()) << x;
  }
}

// A pyramid of height D / sqrt(3) on a triangle of area 3 sqrt(3) D^2 / 2.
TEST(PressedFace, HoldsACornerAsTheIntegralSays) {
  const auto cube = build_box({1e-2, 1e-2, 1e-2});
  constexpr double kDepth = 5e-5;
  const double expected = kStiffness * std::sqrt(3.0) / 24 * std::pow(kDepth, 4);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.4 * kSide, 0.4 * kSide);
  for (int k = 0; k < 200; ++k) {
    const Vector3d tip(place(random), place(random), -kDepth);
    const PressedFace face = pressed_by(level_face(), *cube, stands_on_corner(tip));
    EXPECT_NEAR(face.energy / expected, 1, 1e-8) << tip.transpose();
    EXPECT_LT(face.push.rowwise().sum().head<2>().norm(), 1e-8 * face.push.norm());
  }
}

TEST(PressedFace, LeavesAloneWhatDoesNotReachIt) {
  const auto cube = build_box({1e-2, 1e-2, 1e-2});
  const PressedFace face = pressed_by(level_face(), *cube, stands_on_edge({0, 0, 1e-7}));
  EXPECT_EQ(face.energy, 0);
  EXPECT_TRUE(face.points.empty());
}

/// A tube of 4 to 5 mm radius, 4 mm high.
class Tube : public Shape {
 public:
  [[nodiscard]] double distance(const Vector3d& p) const override { return nearest(p).distance; }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    // A rectangle of radii and heights.
    const double r = std::hypot(p.x(), p.y()), side = r < 4.5e-3 ? -1 : 1, end = p.z() < 0 ? -1 : 1;
    const double a = side * (r - 4.5e-3) - 0.5e-3, b = end * p.z() - 2e-3;
    double along_r = a > b ? 1 : 0, along_z = 1 - along_r, distance = std::max(a, b);
    if (a > 0 && b > 0) {
      distance = std::hypot(a, b);
      along_r = a / distance;
      along_z = b / distance;
    }
    NearestSurface out;
    out.distance = distance;
    out.normal = {along_r * side * p.x() / r, along_r * side * p.y() / r, along_z * end};
    return out;
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    return {Vector3d(-5e-3, -5e-3, -2e-3), Vector3d(5e-3, 5e-3, 2e-3)};
  }
};

// A tube's inner rim, which is not convex, against a sum over 400 x 400 points.
TEST(PressedFace, HoldsRimsAsTheIntegralSays) {
  const Tube tube;
  for (const double x : {3.7e-3, 4.1e-3, 4.5e-3, 4.9e-3}) {
    Pose<double> X;
    X.p = {-x, 0, 2e-3 - 1e-5};
    const PressedFace face = pressed_by(level_face(), tube, X);
    constexpr int kPoints = 400;
    double expected = 0;
    for (int i = 0; i < kPoints; ++i)
      for (int j = 0; j < kPoints; ++j) {
        const Vector3d p = level_face() * face_shape((i + 0.5) / kPoints, (j + 0.5) / kPoints);
        const double depth = std::max(0.0, -tube.distance(X.inverse() * p));
        expected += 0.5 * kStiffness * depth * depth * kSide * kSide / (kPoints * kPoints);
      }
    EXPECT_NEAR(face.energy / expected, 1, 0.03) << x;
  }
}

// Of faces bent at random, against differences. A curved object's depth is linear over triangles,
// along a cylinder's rims with no ridge.
TEST(PressedFace, HasTheSlopesOfItsEnergy) {
  struct Trial {
    std::shared_ptr<const Shape> object;
    double most_error;  // of the stiffness [1]
  };
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const Trial trials[] = {{build_box({1e-2, 1e-2, 1e-2}), 1e-6},
                          {build_box({4e-4, 1e-2, 1e-2}), 1e-6},
                          {build_cylinder(3e-3, 1e-2), kAny},
                          {build_sphere(5e-3), 0.06}};  // without curvature .03 to .76
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3d(unit(random), unit(random), unit(random)); };
  int pressed = 0;
  for (const Trial& trial : trials)
    for (int k = 0; k < 20; ++k) {
      FaceCorners corners = level_face();
      for (int c = 0; c < 4; ++c) corners.col(c) += 0.1 * kSide * vector();
      Pose<double> X;
      X.R = Eigen::AngleAxisd(3 * unit(random), vector().normalized()).toRotationMatrix();
      // Moved until it is 40 um deep at the middle.
      X.p = vector().normalized() * 5e-3;
      for (int i = 0; i < 50; ++i) {
        const NearestSurface near = trial.object->nearest(X.inverse() * Vector3d(0, 0, 0));
        X.p += (near.distance + 4e-5) * (X.R * near.normal);
      }
      const PressedFace face = pressed_by(corners, *trial.object, X);
      if (face.points.empty()) continue;
      ++pressed;
      FaceCorners way;
      for (int c = 0; c < 4; ++c) way.col(c) = vector();
      constexpr double kStep = 1e-9;
      const PressedFace more = pressed_by(corners + kStep * way, *trial.object, X);
      const PressedFace less = pressed_by(corners - kStep * way, *trial.object, X);
      const double slope = (more.energy - less.energy) / (2 * kStep);
      EXPECT_NEAR(slope, -face.push.cwiseProduct(way).sum(), 2e-4 * face.push.norm()) << k;
      const FaceCorners lost = (less.push - more.push) / (2 * kStep);
      const FaceCorners expected = (face.stiffness * way.reshaped()).reshaped(3, 4);
      EXPECT_LT((lost - expected).norm(), trial.most_error * expected.norm()) << k;
    }
  EXPECT_GT(pressed, 60);
}

// Objects that stand upright on a level face: below their walls the nearest normals lie in the
// plane of the face, whose triangles give no slope out of it. Against differences; the cylinder so
// deep that its rim is nowhere near.
TEST(PressedFace, IsAsStiffBelowAnUprightWall) {
  struct Trial {
    std::shared_ptr<const Shape> object;
    double depth;       // of its floor [m]
    double most_error;  // of the stiffness [1]
  };
  const auto box = build_box({1e-2, 1e-2, 1e-2}), cylinder = build_cylinder(5e-3, 1e-2);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Trial& trial : {Trial{box, 0.1e-3, 1e-6}, Trial{box, 0.5e-3, 1e-6},
                             Trial{box, 1.5e-3, 1e-6}, Trial{cylinder, 1.5e-3, 0.06}}) {
    // The wall is at x = 0.1 mm, the floor below the face.
    Pose<double> X;
    X.p = {5e-3 + 0.1e-3, 0, 5e-3 - trial.depth};
    const PressedFace face = pressed_by(level_face(), *trial.object, X);
    ASSERT_TRUE(face.stiffness.allFinite()) << trial.depth;
    FaceCorners way;
    for (int c = 0; c < 4; ++c) way.col(c) << unit(random), unit(random), unit(random);
    constexpr double kStep = 1e-9;
    const PressedFace more = pressed_by(level_face() + kStep * way, *trial.object, X);
    const PressedFace less = pressed_by(level_face() - kStep * way, *trial.object, X);
    const FaceCorners lost = (less.push - more.push) / (2 * kStep);
    const FaceCorners expected = (face.stiffness * way.reshaped()).reshaped(3, 4);
    EXPECT_LT((lost - expected).norm(), trial.most_error * lost.norm()) << trial.depth;
  }
}

}  // namespace
}  // namespace thenar
