// Tests for tendons/forces/tip_force.cpp.

#include "tendons/forces/tip_force.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

// Every joint moves the tip 0.1 m/rad along its own axis, so f = tau / 0.1 by hand.
const Eigen::Matrix3d kJ = 0.1 * Eigen::Matrix3d::Identity();
const Eigen::Matrix3d kFingerArms = Eigen::Vector3d(0.010, 0.008, 0.005).asDiagonal();

TEST(TipForce, MatchesHandComputedFinger) {
  const TipForce result = tip_force(kJ, kFingerArms, Eigen::Vector3d(10, 20, 30));
  EXPECT_TRUE(matrix_near(result.f_W, Eigen::Vector3d(1.0, 1.6, 1.5), 1e-12));
  EXPECT_TRUE(matrix_near(result.tau_residual, Eigen::Vector3d::Zero(), 1e-12));
}

// Virtual work: with no torque left over, tendon power is tip power for any q_dot.
TEST(TipForce, ConservesPower) {
  Eigen::Matrix3d J;
  J << 0.05, 0.02, 0.00, 0.01, 0.06, 0.02, 0.00, 0.01, 0.04;
  const Eigen::Vector3d t(5, 7, 11), q_dot(0.3, -0.2, 0.5);
  const TipForce result = tip_force(J, kFingerArms, t);
  EXPECT_NEAR(result.f_W.dot(J * q_dot), t.dot(kFingerArms * q_dot), 1e-12);  // [W]
}

TEST(TipForce, ReturnsTorqueNoForceCanBalance) {
  Eigen::Matrix<double, 3, 4> J = Eigen::Matrix<double, 3, 4>::Zero();
  J.leftCols<3>() = kJ;  // the fourth joint does not move the tip
  const Eigen::RowVector4d R(0, 0, 0, 0.01);
  const TipForce result = tip_force(J, R, Eigen::VectorXd::Constant(1, 50.0));
  EXPECT_TRUE(matrix_near(result.tau_residual, Eigen::Vector4d(0, 0, 0, 0.5), 1e-12));
}

TEST(TipForce, AddsPassiveTorque) {
  const TipStatics statics{
      kJ, {}, kFingerArms, Eigen::Vector3d(0, 0.02, 0), Eigen::Vector3d::Ones(), {}};
  const TipForce result = tip_force(statics, Eigen::Vector3d(10, 20, 30));
  EXPECT_TRUE(matrix_near(result.f_W, Eigen::Vector3d(1.0, 1.8, 1.5), 1e-12));
}

TEST(TipForce, ReportsStraightFinger) {
  Eigen::Matrix3d J = kJ;
  J(2, 2) = 0;
  const TipForce result = tip_force(J, kFingerArms, Eigen::Vector3d::Ones());
  EXPECT_EQ(result.condition, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.rank, 2);
}

// Rounding in a straight finger's Jacobian is no singular value: it must not read as a condition.
TEST(TipForce, ReportsStraightFingerThroughRounding) {
  Eigen::Matrix3d J = kJ;
  J(1, 1) = J(2, 2) = 1e-17;
  const TipForce result = tip_force(J, kFingerArms, Eigen::Vector3d::Ones());
  EXPECT_EQ(result.condition, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.rank, 1);
}

TEST(TipForce, TwoJointsNeverFixAForce) {
  const TipForce result =
      tip_force(kJ.leftCols<2>(), kFingerArms.leftCols<2>(), Eigen::Vector3d::Ones());
  EXPECT_EQ(result.condition, std::numeric_limits<double>::infinity());
}

TEST(TipForce, RejectsPushingTendonAndNamesIt) {
  try {
    (void)tip_force(kJ, kFingerArms, Eigen::Vector3d(1, -2, 1));
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "tendon 1 cannot push: tension -2 N");
  }
}

TEST(TipForce, RefusesNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)tip_force(nan * kJ, kFingerArms, Eigen::Vector3d::Ones()), InputError);
  EXPECT_THROW((void)tip_force(kJ, kFingerArms, Eigen::Vector3d(1, nan, 1)), InputError);
}

// Links of 40 and 30 mm, the second at right angles, both axes along z: torques are
// -0.03 fx + 0.04 fy and -0.03 fx, and no joint feels fz.
TEST(TipForce, OfParallelAxesIsRegularInTheirPlane) {
  TipStatics statics;
  statics.J = Eigen::Matrix3Xd(3, 2);
  statics.J << -0.03, -0.03, 0.04, 0, 0, 0;
  statics.W = Eigen::Matrix3Xd::Zero(3, 2);
  statics.W.row(2).setOnes();
  statics.R = 0.01 * Eigen::Matrix2d::Identity();
  statics.tau_0 = Eigen::Vector2d::Zero();
  statics.max_tension = Eigen::Vector2d::Constant(100);
  const TipForce result = tip_force(statics, Eigen::Vector2d(8, 3));
  EXPECT_TRUE(matrix_near(result.f_W, Eigen::Vector3d(-1, 1.25, 0), 1e-12));
  EXPECT_FALSE(result.singular());
  EXPECT_TRUE(std::isfinite(result.condition));
  statics.J.row(0).setZero();  // straight
  EXPECT_TRUE(tip_force(statics, Eigen::Vector2d(8, 3)).singular());
}

}  // namespace
}  // namespace thenar
