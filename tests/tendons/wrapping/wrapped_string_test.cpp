// Tests for tendons/wrapping/wrap_string.cpp.

#include "tendons/wrapping/wrapped_string.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

BoneSurface round_bone(SurfaceShape shape, double radius) {
  BoneSurface bone;
  bone.shape = shape;
  bone.size = {radius, 0.05, 0};
  return bone;
}

WrappedString at(const BoneSurface& bone, const Vector6d& ends, const Vector3d& side) {
  return wrap_string(bone, ends.head<3>(), ends.tail<3>(), side);
}

// Richardson's differences, exact to h^4.
void expect_derivatives(const BoneSurface& bone, const Vector6d& ends, const Vector3d& side) {
  const WrappedString chord = at(bone, ends, side);
  const double h = 4e-6;
  for (int i = 0; i < 6; ++i) {
    const auto moved = [&](double by) { return at(bone, ends + by * h * Vector6d::Unit(i), side); };
    const WrappedString p1 = moved(1), m1 = moved(-1), p2 = moved(2), m2 = moved(-2);
    const double slope = (8 * (p1.length - m1.length) - (p2.length - m2.length)) / (12 * h);
    const Vector6d curve = (8 * (p1.slope - m1.slope) - (p2.slope - m2.slope)) / (12 * h);
    EXPECT_NEAR(chord.slope(i), slope, 1e-10);
    EXPECT_TRUE(matrix_near(chord.curve.col(i), curve, 1e-5));
  }
}

// Tangents 3-4-5 on both sides of a half turn: 4 + arc + 4.
TEST(ChordOver, MatchesRightTrianglesOnACylinder) {
  const BoneSurface bone = round_bone(SurfaceShape::kCylinder, 0.003);
  const WrappedString chord = wrap_string(bone, {-0.005, 0, 0}, {0.005, 0, 0}, Vector3d::UnitY());
  const double arc = 0.003 * (kPi - 2 * std::acos(0.6));
  EXPECT_NEAR(chord.length, 0.008 + arc, 1e-15);
  EXPECT_TRUE(chord.bent);
  EXPECT_TRUE(matrix_near(chord.touch_a, Vector3d(-0.0018, 0.0024, 0), 1e-15));
}

TEST(ChordOver, TakesTheGivenSideOfACylinderThoughItIsLonger) {
  const BoneSurface bone = round_bone(SurfaceShape::kCylinder, 0.003);
  const Vector3d a(-0.005, -0.001, 0), b(0.005, -0.001, 0);
  const double over = wrap_string(bone, a, b, Vector3d::UnitY()).length;
  const double under = wrap_string(bone, a, b, -Vector3d::UnitY()).length;
  EXPECT_GT(over, under);
}

TEST(ChordOver, IsAHelixAlongACylinder) {
  const BoneSurface bone = round_bone(SurfaceShape::kCylinder, 0.004);
  const WrappedString chord =
      wrap_string(bone, {-0.004, 0, 0}, {0.004, 0, 0.003}, Vector3d::UnitY());
  EXPECT_NEAR(chord.length, std::hypot(0.004 * kPi, 0.003), 1e-15);
}

TEST(ChordOver, IsAGreatCircleOnASphere) {
  const BoneSurface bone = round_bone(SurfaceShape::kSphere, 0.004);
  const WrappedString chord = wrap_string(bone, {0.004, 0, 0}, {0, 0, 0.004}, Vector3d::UnitY());
  EXPECT_NEAR(chord.length, 0.002 * kPi, 1e-15);
}

TEST(ChordOver, PassesTheGivenSideOfASphereBetweenOpposites) {
  const BoneSurface bone = round_bone(SurfaceShape::kSphere, 0.004);
  const WrappedString chord = wrap_string(bone, {-0.006, 0, 0}, {0.006, 0, 0}, Vector3d::UnitZ());
  EXPECT_GT(chord.touch_a.z(), 0.001);
  EXPECT_NEAR(chord.touch_a.y(), 0, 1e-15);
}

TEST(ChordOver, IsStraightWhereItClearsTheBone) {
  for (SurfaceShape shape : {SurfaceShape::kSphere, SurfaceShape::kCylinder}) {
    const Vector3d a(-0.01, 0.006, 0), b(0.01, 0.006, 0.001);
    const WrappedString chord = wrap_string(round_bone(shape, 0.005), a, b, Vector3d::UnitY());
    EXPECT_FALSE(chord.bent);
    EXPECT_EQ(chord.length, (a - b).norm());
  }
}

// Length and slope pass lift-off without a jump: 1 nm below and above.
TEST(ChordOver, LiftsOffWithoutAJump) {
  for (SurfaceShape shape : {SurfaceShape::kSphere, SurfaceShape::kCylinder}) {
    const BoneSurface bone = round_bone(shape, 0.005);
    const auto string = [&](double y) {
      return wrap_string(bone, {-0.01, y, 0}, {0.01, y, 0}, Vector3d::UnitY());
    };
    const WrappedString on = string(0.005 - 1e-9), off = string(0.005 + 1e-9);
    EXPECT_TRUE(on.bent);
    EXPECT_FALSE(off.bent);
    EXPECT_NEAR(on.length, off.length, 1e-12);
    EXPECT_TRUE(matrix_near(on.slope, off.slope, 1e-6));
  }
}

TEST(ChordOver, HasTheDerivativesOfItsLength) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> draw(-0.012, 0.012);
  for (SurfaceShape shape : {SurfaceShape::kSphere, SurfaceShape::kCylinder}) {
    const BoneSurface bone = round_bone(shape, 0.005);
    int bent = 0;
    while (bent < 30) {
      const Vector6d ends = Vector6d::NullaryExpr([&] { return draw(rng); });
      const WrappedString chord = at(bone, ends, Vector3d(0.3, 1, 0.1));
      const double clear =
          std::min(probe(bone, ends.head<3>()).gap, probe(bone, ends.tail<3>()).gap);
      if (!chord.bent || clear < 5e-4 || (chord.touch_a - chord.touch_b).norm() < 1e-4) continue;
      if (std::abs(ends.head<3>().normalized().dot(ends.tail<3>().normalized())) > 0.97) continue;
      expect_derivatives(bone, ends, Vector3d(0.3, 1, 0.1));
      ++bent;
    }
  }
}

TEST(ChordOver, SaysThatAnEndLiesInside) {
  for (SurfaceShape shape : {SurfaceShape::kSphere, SurfaceShape::kCylinder}) {
    const BoneSurface bone = round_bone(shape, 0.005);
    EXPECT_FALSE(wrap_string(bone, {0.004, 0, 0}, {0, 0.01, 0}, Vector3d::UnitY()).possible);
    EXPECT_TRUE(wrap_string(bone, {0.006, 0, 0}, {0, 0.01, 0}, Vector3d::UnitY()).possible);
  }
}

// The end inside counts as lying on the bone at the nearest point; the other end is not touched.
TEST(ChordOver, PullsTheOtherEndAsFromTheNearestPointOfTheBone) {
  for (SurfaceShape shape : {SurfaceShape::kSphere, SurfaceShape::kCylinder}) {
    const BoneSurface bone = round_bone(shape, 0.005);
    const Vector3d far(-0.002, 0.01, 0.003), side = Vector3d::UnitY();
    const WrappedString in = wrap_string(bone, {0.003, 0, 0}, far, side);
    const WrappedString on = wrap_string(bone, {0.005, 0, 0}, far, side);
    EXPECT_TRUE(matrix_near(in.slope.tail<3>(), on.slope.tail<3>(), 1e-14));
    const Eigen::Matrix3d there = in.curve.bottomRightCorner<3, 3>();
    EXPECT_TRUE(matrix_near(there, on.curve.bottomRightCorner<3, 3>(), 1e-11));
  }
}

}  // namespace
}  // namespace thenar
