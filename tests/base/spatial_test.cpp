// Tests for base/spatial.h.

#include "base/spatial.h"

#include <gtest/gtest.h>

#include <random>

#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRounding = 1e-14;  // a few roundings of numbers of order one

Vector3d random_unit(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
}

TEST(RotationAbout, TurnsXToYAboutZ) {
  const Matrix3d R = rotation_about<double>(Vector3d::UnitZ(), kPi / 2);
  EXPECT_TRUE(matrix_near(R * Vector3d::UnitX(), Vector3d::UnitY(), kRounding));
}

// Independent implementation: Eigen's quaternion-free AngleAxis.
TEST(RotationAbout, AgreesWithAngleAxis) {
  std::mt19937 rng(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d d = random_unit(rng);
    const double a = 0.1 * (i - 50);  // [rad]
    EXPECT_TRUE(
        matrix_near(rotation_about(d, a), Eigen::AngleAxisd(a, d).toRotationMatrix(), kRounding));
  }
}

TEST(RotationAbout, IsProperForAnyAngle) {
  std::mt19937 rng(2);
  for (const double a : {0.0, 1e-9, 1.0, kPi, 100.0}) {
    const Matrix3d R = rotation_about(random_unit(rng), a);
    EXPECT_TRUE(matrix_near(R * R.transpose(), Matrix3d::Identity(), kRounding));
    EXPECT_NEAR(R.determinant(), 1, kRounding);
  }
}

TEST(ScrewMotion, LeavesPointsOfItsAxis) {
  const Vector3d d = Vector3d(1, 2, 2) / 3, point(0.1, -0.2, 0.3);
  const Pose<double> X = screw_motion(d, point, 0.7);
  EXPECT_TRUE(matrix_near(X * point, point, kRounding));
  EXPECT_TRUE(matrix_near(X * Vector3d(point + 5 * d), point + 5 * d, 10 * kRounding));
}

// A quarter turn about the vertical through (1, 0, 0) carries the origin to (1, -1, 0).
TEST(ScrewMotion, TurnsAboutAnAxisAwayFromTheOrigin) {
  const Pose<double> X = screw_motion<double>(Vector3d::UnitZ(), Vector3d::UnitX(), kPi / 2);
  EXPECT_TRUE(matrix_near(X * Vector3d(0, 0, 0), Vector3d(1, -1, 0), kRounding));
}

TEST(Pose, ProductIsOneMotionAfterTheOther) {
  const Pose<double> a = screw_motion<double>(Vector3d::UnitX(), Vector3d(0, 1, 2), 0.3);
  const Pose<double> b = screw_motion<double>(Vector3d::UnitY(), Vector3d(3, 0, 1), -0.8);
  const Vector3d p(0.5, -0.6, 0.7);
  EXPECT_TRUE(matrix_near((a * b) * p, a * (b * p), kRounding));
}

TEST(Pose, InverseUndoesIt) {
  const Pose<double> X = screw_motion<double>(Vector3d::UnitY(), Vector3d(1, 2, 3), 1.1);
  const Pose<double> none = X * X.inverse();
  EXPECT_TRUE(matrix_near(none.R, Matrix3d::Identity(), kRounding));
  EXPECT_TRUE(matrix_near(none.p, Vector3d::Zero(), kRounding));
}

TEST(Tangents, CompleteARightHandedFrame) {
  std::mt19937 rng(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3d d = random_unit(rng);
    const Tangents t = tangents(d);
    Matrix3d frame;
    frame << t.e1, t.e2, d;
    EXPECT_TRUE(matrix_near(frame.transpose() * frame, Matrix3d::Identity(), kRounding));
    EXPECT_NEAR(frame.determinant(), 1, kRounding);
  }
}

// Where other constructions divide by zero: straight down, and an ulp from it.
TEST(Tangents, AreExactAtThePoles) {
  for (const double z : {1.0, -1.0}) {
    const Vector3d d = Vector3d(1e-300, 0, z);
    const Tangents t = tangents(d);
    EXPECT_TRUE(matrix_near(t.e1.cross(t.e2), d, kRounding));
  }
}

// By hand: 2 N along y, 3 m along x; and the opposite force at the origin leaves a couple.
TEST(Wrench, OfForcesAddsToACouple) {
  Wrench sum = wrench_of_force({3, 0, 0}, {0, 2, 0});
  EXPECT_EQ(sum.moment, Vector3d(0, 0, 6));
  EXPECT_EQ(sum.force, Vector3d(0, 2, 0));
  sum += wrench_of_force({0, 0, 0}, {0, -2, 0});
  EXPECT_EQ(sum.moment, Vector3d(0, 0, 6));
  EXPECT_EQ(sum.force, Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace thenar
