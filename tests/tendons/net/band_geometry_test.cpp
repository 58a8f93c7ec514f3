// Tests for tendons/net/band_geometry.cpp: the fast kernel against wrap_string(), which says the
// same in another way.

#include "tendons/net/band_geometry.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tendons/wrapping/wrapped_string.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using internal::BandGeometry;
using internal::RoundBone;
using internal::WrapState;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kRunRadius = 0.005;  // [m]
constexpr SurfaceShape kRound[] = {SurfaceShape::kSphere, SurfaceShape::kCylinder};
const Vector3d kSide(0.3, 1, 0.2);

BoneSurface bone_of(SurfaceShape shape) { return {"bone", -1, shape, {kRunRadius, 0.05, 0}, {}}; }

Vector6d slope_of(const BandGeometry& run) {
  Vector6d slope;
  slope << run.ua, run.ub;
  return slope;
}

Matrix6d curve_of(const BandGeometry& run) {
  const Matrix3d ab = run.vab * run.va * run.vb.transpose();
  Matrix6d H;
  H << run.vaa * run.va * run.va.transpose() + run.wa * run.na * run.na.transpose(), ab,
      ab.transpose(), run.vbb * run.vb * run.vb.transpose() + run.wb * run.nb * run.nb.transpose();
  return H;
}

/// What coordinates of 1 cm, rounded, leave open.
struct Rounding {
  double slope;  // [1]
  double curve;  // relative to the largest second derivative [1]
};

/// Compares a bent run with its chord, both in the frame of the bone.
void expect_same(const BandGeometry& run, const WrappedString& chord, const Rounding& rounding) {
  EXPECT_NEAR(run.length, chord.length, 1e-16);
  EXPECT_TRUE(matrix_near(slope_of(run), chord.slope, rounding.slope));
  const double largest = chord.curve.cwiseAbs().maxCoeff();
  EXPECT_TRUE(matrix_near(curve_of(run) / largest, chord.curve / largest, rounding.curve));
}

/// An end at that height over the bone.
Vector3d end_at(std::mt19937& rng, SurfaceShape shape, double height) {
  std::uniform_real_distribution<double> angle(-3.1415, 3.1415), along(-1, 1);
  const double turn = angle(rng), z = along(rng), rho = kRunRadius + height;
  const Vector3d out(std::cos(turn), std::sin(turn), 0);
  if (shape == SurfaceShape::kCylinder) return rho * out + Vector3d(0, 0, 0.02 * z);
  return rho * (std::sqrt(1 - z * z) * out + Vector3d(0, 0, z));
}

/// Draws ends at the given heights until `runs` of them are bent, and compares those.
template <typename Height>
void compare_runs(SurfaceShape shape, int runs, const Height& height, const Rounding& rounding) {
  std::mt19937 rng(11);
  const BoneSurface bone = bone_of(shape);
  const RoundBone fast = internal::round_bone(bone, {}, kSide);
  for (int bent = 0, drawn = 0; bent < runs; ++drawn) {
    ASSERT_LT(drawn, 100 * runs);
    const Vector3d a = end_at(rng, shape, height(rng)), b = end_at(rng, shape, height(rng));
    const Vector3d ea = a.normalized(), eb = b.normalized();
    if (shape == SurfaceShape::kSphere && ea.cross(eb).norm() < 0.01) continue;
    const WrappedString chord = wrap_string(bone, a, b, kSide);
    BandGeometry run;
    const WrapState bend = internal::wrap_over(fast, a, b, run);
    ASSERT_EQ(bend == WrapState::kBent, chord.bent);
    if (!chord.bent || (chord.touch_a - chord.touch_b).norm() < 1e-6) continue;
    expect_same(run, chord, rounding);
    ++bent;
  }
}

// A centimetre rounds by 1e-18 m; a free run f of 1 mm or more turns by 1e-15 then.
TEST(BandGeometry, SaysWhatAChordSaysClearOfTheBone) {
  std::uniform_real_distribution<double> height(1e-4, 0.02);
  for (SurfaceShape shape : kRound)
    compare_runs(shape, 2000, [&](std::mt19937& rng) { return height(rng); }, {1e-13, 1e-12});
}

// At a height h of 1e-12 m the free run f = sqrt(2 r h) is 1e-7 m: 1e-18 m turns it by 1e-18 / f =
// 1e-11, and changes the second derivative, which goes as 1 / f, by 1e-18 / (2 h) of it.
TEST(BandGeometry, SaysWhatAChordSaysNextToTheBone) {
  std::uniform_real_distribution<double> exponent(-12, -4);
  const auto height = [&](std::mt19937& rng) { return std::pow(10, exponent(rng)); };
  for (SurfaceShape shape : kRound) compare_runs(shape, 2000, height, {1e-10, 1e-5});
}

// On it, 1e-18 m more or less is a free run of 1e-10 m, so a turn of 2e-8.
TEST(BandGeometry, SaysWhatAChordSaysOnTheBone) {
  const auto height = [](std::mt19937&) { return 0.0; };
  for (SurfaceShape shape : kRound) compare_runs(shape, 500, height, {1e-7, 1e-6});
}

// The plane of ends that are an angle `off` from opposite turns by 1e-16 / off.
TEST(BandGeometry, SaysWhatAChordSaysBetweenNearlyOppositeEnds) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> exponent(-9, -3);
  for (SurfaceShape shape : kRound)
    for (int i = 0; i < 500; ++i) {
      const double off = std::pow(10, exponent(rng));
      const Vector3d a = end_at(rng, shape, 0.003);
      const Vector3d b = -1.2 * (a + off * a.norm() * a.unitOrthogonal());
      const WrappedString chord = wrap_string(bone_of(shape), a, b, kSide);
      BandGeometry run;
      const RoundBone fast = internal::round_bone(bone_of(shape), {}, kSide);
      ASSERT_EQ(internal::wrap_over(fast, a, b, run), WrapState::kBent);
      ASSERT_TRUE(chord.bent);
      expect_same(run, chord, {1e-13 + 1e-15 / off, 1e-12 + 1e-14 / off});
    }
}

TEST(BandGeometry, IsClearWhereAChordIsStraight) {
  for (SurfaceShape shape : kRound) {
    const RoundBone bone = internal::round_bone(bone_of(shape), {}, Vector3d::UnitY());
    BandGeometry run;
    EXPECT_EQ(internal::wrap_over(bone, {-0.01, 0.0051, 0}, {0.01, 0.0051, 0}, run),
              WrapState::kStraight);
    EXPECT_EQ(internal::wrap_over(bone, {-0.01, 0.0049, 0}, {0.01, 0.0049, 0}, run),
              WrapState::kBent);
  }
}

TEST(BandGeometry, LeavesEndsInsideAndOppositeEndsOfASphereToTheChord) {
  BandGeometry run;
  for (SurfaceShape shape : kRound) {
    const RoundBone bone = internal::round_bone(bone_of(shape), {}, kSide);
    EXPECT_EQ(internal::wrap_over(bone, {0.004, 0, 0}, {0, 0.01, 0}, run), WrapState::kDegenerate);
  }
  const RoundBone ball = internal::round_bone(bone_of(SurfaceShape::kSphere), {}, kSide);
  EXPECT_EQ(internal::wrap_over(ball, {-0.007, 0, 0}, {0.009, 0, 0}, run), WrapState::kDegenerate);
}

// Derivatives turn with the bone.
TEST(BandGeometry, IsGivenInTheAxesOfTheWorld) {
  Pose<double> X;
  X.R = rotation_about(Vector3d(Vector3d(1, 2, -1).normalized()), 0.8);
  X.p = {0.01, -0.02, 0.03};
  Matrix6d turn = Matrix6d::Zero();
  turn << X.R, Matrix3d::Zero(), Matrix3d::Zero(), X.R;
  const Vector3d a(-0.007, 0.001, 0.002), b(0.006, -0.001, -0.003);
  for (SurfaceShape shape : kRound) {
    const WrappedString chord = wrap_string(bone_of(shape), a, b, kSide);
    BandGeometry run;
    const RoundBone bone = internal::round_bone(bone_of(shape), X, kSide);
    ASSERT_EQ(internal::wrap_over(bone, X * a, X * b, run), WrapState::kBent);
    EXPECT_NEAR(run.length, chord.length, 1e-16);
    EXPECT_TRUE(matrix_near(slope_of(run), turn * chord.slope, 1e-13));
    EXPECT_TRUE(matrix_near(curve_of(run), turn * chord.curve * turn.transpose(), 1e-9));
  }
}

}  // namespace
}  // namespace thenar
