// Tests for tendons/forces/tip_wrench.cpp.

#include "tendons/forces/tip_wrench.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Three sliding joints along x y z [m/m], then three hinges through the tip: torques are the
// wrench.
TipStatics six_joints() {
  TipStatics statics;
  statics.J = Matrix3Xd::Zero(3, 6);
  statics.J.leftCols<3>().setIdentity();
  statics.W = Matrix3Xd::Zero(3, 6);
  statics.W.rightCols<3>().setIdentity();
  statics.R = 0.01 * Eigen::MatrixXd::Identity(6, 6);
  statics.tau_0 = VectorXd::Zero(6);
  statics.max_tension = VectorXd::Constant(6, 100);
  return statics;
}

// One hinge along z; the tip is 0.03 m away along x, so it moves along y. One tendon of 0.01 m arm.
TipStatics one_hinge() {
  TipStatics statics;
  statics.J = Vector3d(0, 0.03, 0);
  statics.W = Vector3d(0, 0, 1);
  statics.R = Eigen::MatrixXd::Constant(1, 1, 0.01);
  statics.tau_0 = VectorXd::Zero(1);
  statics.max_tension = VectorXd::Constant(1, 100);
  return statics;
}

TEST(TipWrench, ReadsOffSixIndependentJoints) {
  const VectorXd t = VectorXd::LinSpaced(6, 1, 6);
  const TipWrench result = tip_wrench(six_joints(), t);
  EXPECT_TRUE(matrix_near(result.f_W, Vector3d(0.01, 0.02, 0.03), 1e-14));
  EXPECT_TRUE(matrix_near(result.m_W, Vector3d(0.04, 0.05, 0.06), 1e-14));
  EXPECT_FALSE(result.minimum_norm);
}

TEST(TipWrench, SixJointsDoNotFeelTheLength) {
  const VectorXd t = VectorXd::LinSpaced(6, 1, 6);
  TipWrenchOptions options;
  options.length = 7;
  const TipWrench a = tip_wrench(six_joints(), t), b = tip_wrench(six_joints(), t, options);
  EXPECT_TRUE(matrix_near(a.f_W, b.f_W, 1e-14));
  EXPECT_TRUE(matrix_near(a.m_W, b.m_W, 1e-14));
}

// 0.03 f + m = tau with least f^2 + (m / l)^2:  f = 0.03 s, m = l^2 s,  s = tau / (0.03^2 + l^2).
TEST(TipWrench, OneHingeSharesByTheLength) {
  TipWrenchOptions options;
  options.length = 0.04;  // a 3-4-5 triangle
  const TipWrench result = tip_wrench(one_hinge(), VectorXd::Constant(1, 25.0), options);
  EXPECT_TRUE(matrix_near(result.f_W, Vector3d(0, 3, 0), 1e-13));
  EXPECT_TRUE(matrix_near(result.m_W, Vector3d(0, 0, 0.16), 1e-13));
  EXPECT_TRUE(result.minimum_norm);
  EXPECT_EQ(result.rank, 1);
}

TEST(TipWrench, ConditionIsInfiniteWhereRankIsLostToRounding) {
  TipStatics statics = six_joints();
  statics.J(2, 2) = 1e-17;
  const TipWrench result = tip_wrench(statics, VectorXd::Ones(6));
  EXPECT_EQ(result.condition, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result.rank, 5);
}

// Fewer joints than six, all independent, have a condition.
TEST(TipWrench, ConditionOfOneHingeIsOne) {
  EXPECT_NEAR(tip_wrench(one_hinge(), VectorXd::Ones(1)).condition, 1, 1e-15);
}

TEST(TipWrench, SeventhJointLeavesTorqueOver) {
  TipStatics statics = six_joints();
  statics.J.conservativeResize(3, 7);
  statics.W.conservativeResize(3, 7);
  statics.J.col(6).setZero();  // a joint beyond the tip: it carries no wrench
  statics.W.col(6).setZero();
  statics.R = 0.01 * Eigen::MatrixXd::Identity(7, 7);
  statics.tau_0 = VectorXd::Zero(7);
  statics.max_tension = VectorXd::Constant(7, 100);
  const TipWrench result = tip_wrench(statics, VectorXd::Constant(7, 10.0));
  EXPECT_NEAR(result.tau_residual(6), 0.1, 1e-14);
  EXPECT_NEAR(result.tau_residual.head(6).norm(), 0, 1e-14);
}

TEST(TipWrench, AddsPassiveTorque) {
  TipStatics statics = six_joints();
  statics.tau_0(5) = -0.5;
  EXPECT_NEAR(tip_wrench(statics, VectorXd::Zero(6)).m_W.z(), -0.5, 1e-14);
}

TEST(TipWrench, NeedsRotationJacobian) {
  TipStatics statics = one_hinge();
  statics.W.resize(3, 0);
  EXPECT_THROW((void)tip_wrench(statics, VectorXd::Ones(1)), InputError);
}

TEST(TipWrench, RefusesLengthThatIsNotPositive) {
  EXPECT_THROW((void)tip_wrench(one_hinge(), VectorXd::Ones(1), {0.0}), InputError);
}

// Three hinges along z at 90, 45 and 20 mm from a tip that is 20, 10 and 5 mm off their line: three
// torques fix fx, fy and the moment about z, and no joint feels the rest.
TEST(TipWrench, OfThreeParallelAxesIsUniqueInTheirPlane) {
  TipStatics statics;
  statics.J = Matrix3Xd::Zero(3, 3);
  statics.J.row(0) << -0.02, -0.01, -0.005;
  statics.J.row(1) << 0.09, 0.045, 0.02;
  statics.W = Matrix3Xd::Zero(3, 3);
  statics.W.row(2).setOnes();
  statics.R = Matrix3d::Identity();  // [m/rad]: tensions are torques
  statics.tau_0 = VectorXd::Zero(3);
  statics.max_tension = VectorXd::Constant(3, 100);
  // f = (2, 3, 0) N and m = 0.04 N m about z.
  const VectorXd t = statics.J.transpose() * Vector3d(2, 3, 0) + VectorXd::Constant(3, 0.04);
  const TipWrench result = tip_wrench(statics, t);
  EXPECT_TRUE(matrix_near(result.f_W, Vector3d(2, 3, 0), 1e-9));
  EXPECT_TRUE(matrix_near(result.m_W, Vector3d(0, 0, 0.04), 1e-10));
  EXPECT_FALSE(result.minimum_norm);
  EXPECT_TRUE(std::isfinite(result.condition));
  EXPECT_TRUE(tip_wrench(one_hinge(), VectorXd::Ones(1)).minimum_norm);
}

}  // namespace
}  // namespace thenar
