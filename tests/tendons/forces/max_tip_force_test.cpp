// Tests for tendons/forces/max_tip_force.cpp and tip_map.cpp.

#include "tendons/forces/max_tip_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "tests/matrix_near.h"
#include "tests/tendons/published_index.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// Tendons that make the columns of A as tip forces, up to F0 each.
TipStatics map_of(const MatrixXd& A, const VectorXd& F0) {
  return statics_from_matrix(A, Eigen::Matrix3Xd(3, 0), F0);
}

// Pulls of 1 N/N along +x and +y, and against each; greatest 2, 3, 5, 7 N.
TipStatics cross() {
  MatrixXd A = MatrixXd::Zero(3, 4);
  A.row(0) << 1, 0, -1, 0;
  A.row(1) << 0, 1, 0, -1;
  return map_of(A, Eigen::Vector4d(2, 3, 5, 7));
}

// Planar two-link finger, links of 0.04 and 0.03 m, straight along x; one flexor and one extensor a
// joint with arms of 0.01 m.
TipStatics straight_finger() {
  TipStatics statics;
  statics.J = Eigen::Matrix3Xd::Zero(3, 2);
  statics.J.row(1) << 0.07, 0.03;
  statics.R = (MatrixXd(4, 2) << 0.01, 0, -0.01, 0, 0, 0.01, 0, -0.01).finished();
  statics.tau_0 = VectorXd::Zero(2);
  statics.max_tension = VectorXd::Constant(4, 100);
  return statics;
}

struct Published {
  Vector3d moment, force;
  double largest;  // [N] or [N m], by vertex enumeration over the published map
};

class PublishedIndex : public testing::TestWithParam<Published> {};

TEST_P(PublishedIndex, LargestWrenchAgrees) {
  const Published& p = GetParam();
  const MaxTipWrench result = max_tip_wrench(published_index(), {p.moment, p.force});
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.multiple, p.largest, 0.0006);  // half a unit of the last printed digit
}

const Vector3d kAlongX(1, 0, 0), kAlongY(0, 1, 0), kAlongZ(0, 0, 1), kNone(0, 0, 0);
INSTANTIATE_TEST_SUITE_P(
    Directions, PublishedIndex,
    testing::Values(Published{kNone, kAlongX, 28.812}, Published{kNone, kAlongY, 6.758},
                    Published{kNone, kAlongZ, 40.284}, Published{kAlongX, kNone, 0.358},
                    Published{kNone, -kAlongX, 17.593}, Published{kNone, -kAlongY, 25.497},
                    Published{kNone, -kAlongZ, 15.292}, Published{-kAlongX, kNone, 0.176}));

TEST(MaxTipForce, MatchesPublishedIndexFinger) {
  const MaxTipForce result = max_tip_force(published_index(), kAlongX);
  EXPECT_NEAR(result.component, 28.81, 0.005);
  EXPECT_TRUE(matrix_near(result.force, Vector3d(result.component, 0, 0), 1e-12));
}

TEST(MaxTipForce, MatchesPublishedActivation) {
  VectorXd published(7);
  published << 0.204, 0.138, 0.323, 1, 1, 1, 0;
  EXPECT_TRUE(
      matrix_near(max_tip_force(published_index(), kAlongX).activation, published, 0.0005 + 1e-9));
}

TEST(MaxTipForce, BalancesEveryJoint) {
  const TipStatics statics = published_index();
  const MaxTipForce result = max_tip_force(statics, Vector3d(1, -2, 0.5));
  const VectorXd left =
      statics.J.transpose() * result.force - statics.R.transpose() * result.tension - statics.tau_0;
  EXPECT_LT(left.norm(), 1e-12);
}

TEST(MaxTipForce, IgnoresLengthOfDirection) {
  const double one = max_tip_force(cross(), Vector3d(1, 1, 0)).component;
  EXPECT_NEAR(one, 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(max_tip_force(cross(), 1e-200 * Vector3d(1, 1, 0)).component, one, 1e-12);
}

// Along x the cross makes 2 N. In a cone of 30 deg about the diagonal the best corner is (2, 3):
// 11.3 deg off the diagonal, so the cone does not bind, and d'f = 5 / sqrt(2).
TEST(MaxTipForce, ReachesACornerInsideTheCone) {
  MaxTipForceOptions options;
  options.tolerance = 0.5235987755982988;
  const MaxTipForce result = max_tip_force(cross(), Vector3d(1, 1, 0), options);
  EXPECT_TRUE(matrix_near(result.force, Vector3d(2, 3, 0), 1e-12));
  EXPECT_NEAR(result.component, 5 / std::sqrt(2.0), 1e-12);
}

// f = a (1, 1, 0) + b (1, 0, 1) with a <= 1, b <= 10 N. Its angle to x is least, 35.3 deg, at a = b
// and grows with b; a cone of 40 deg is met at a = 1 and the larger root b of
// sqrt(1 + b^2) = tan(40 deg) (1 + b).
TEST(MaxTipForce, MeetsTheConeExactly) {
  MatrixXd A(3, 2);
  A << 1, 1, 1, 0, 0, 1;
  MaxTipForceOptions options;
  options.tolerance = radians(40);
  const double s = std::tan(options.tolerance) * std::tan(options.tolerance);
  const double b = (s + std::sqrt(2 * s - 1)) / (1 - s);  // of (1 - s) b^2 - 2 s b + (1 - s) = 0
  const MaxTipForce result = max_tip_force(map_of(A, Eigen::Vector2d(1, 10)), kAlongX, options);
  EXPECT_NEAR(result.component, 1 + b, 1e-9 * (1 + b));
  EXPECT_LE(result.force.tail<2>().norm(),
            std::tan(options.tolerance) * result.force.x() * (1 + 1e-9));
}

TEST(MaxTipForce, ZeroToleranceIsTheLimitOfACone) {
  MaxTipForceOptions options;
  options.tolerance = 1e-7;
  EXPECT_NEAR(max_tip_force(published_index(), kAlongX, options).component,
              max_tip_force(published_index(), kAlongX).component, 1e-4);
}

TEST(MaxTipForce, NoMuscleMakesNoForce) {
  TipStatics statics = published_index();
  statics.max_tension.setZero();
  const MaxTipForce result = max_tip_force(statics, kX);
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_EQ(result.component, 0);
}

TEST(MaxTipForce, DirectionOutOfReachHasNoComponent) {
  const MaxTipForce result = max_tip_force(cross(), kZ);
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_EQ(result.component, 0);
}

TEST(MaxTipForce, UnknownStrengthIsUnbounded) {
  TipStatics statics = cross();
  statics.max_tension(0) = kInfinity;
  const MaxTipForce result = max_tip_force(statics, kX);
  EXPECT_EQ(result.status, Status::kUnbounded);
  EXPECT_EQ(result.component, kInfinity);
  EXPECT_NEAR(max_tip_force(statics, kAlongY).component, 3, 1e-12);
}

// An unlimited pull c along (1, 0.75, 0.75), outside the cone of 0.7 rad about x but inside its
// first four tangent planes; b <= 1 N along (0, -1, -1) helps. f = (c, 0.75 c - b, 0.75 c - b)
// meets the cone at sqrt(2) (0.75 c - b) = tan(0.7) c.
TEST(MaxTipForce, UnlimitedPullOutsideTheConeStaysBounded) {
  MatrixXd A(3, 2);
  A << 1, 0, 0.75, -1, 0.75, -1;
  MaxTipForceOptions options;
  options.tolerance = 0.7;
  const MaxTipForce result = max_tip_force(map_of(A, Eigen::Vector2d(kInfinity, 1)), kX, options);
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.component, 1 / (0.75 - std::tan(0.7) / std::sqrt(2.0)), 1e-8);
}

TEST(MaxTipForce, UnlimitedPullInsideTheConeIsUnbounded) {
  TipStatics statics = cross();
  statics.max_tension(0) = kInfinity;
  EXPECT_EQ(max_tip_force(statics, Vector3d(1, 0.2, 0.3), {0.7}).status, Status::kUnbounded);
}

TEST(MaxTipForce, StraightFingerCarriesAnyForceAlongItself) {
  EXPECT_EQ(max_tip_force(straight_finger(), kX).status, Status::kUnbounded);
}

// Across itself: both joints must balance, 0.07 f <= 1 N m and 0.03 f <= 1 N m.
TEST(MaxTipForce, StraightFingerPushesAcrossItself) {
  EXPECT_NEAR(max_tip_force(straight_finger(), kAlongY).component, 1 / 0.07, 1e-12);
}

TEST(MaxTipForce, PassiveTorqueNobodyBalancesIsInfeasible) {
  TipStatics statics = cross();
  statics.tau_0 = kZ;  // a force along z that no tendon opposes and x cannot carry
  EXPECT_EQ(max_tip_force(statics, kX).status, Status::kInfeasible);
}

TEST(MaxTipForce, PassiveTorqueShiftsTheAnswer) {
  TipStatics statics = cross();
  statics.tau_0 = 0.5 * kAlongX;
  EXPECT_NEAR(max_tip_force(statics, kAlongX).component, 2.5, 1e-12);
}

TEST(MaxTipForce, RefusesBadCalls) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)max_tip_force(cross(), kNone), InputError);
  EXPECT_THROW((void)max_tip_force(cross(), Vector3d(nan, 0, 1)), InputError);
  EXPECT_THROW((void)max_tip_force(cross(), kAlongX, {-0.1}), InputError);
  EXPECT_THROW((void)max_tip_force(cross(), kAlongX, {2.0}), InputError);
  TipStatics statics = cross();
  statics.max_tension(2) = nan;
  EXPECT_THROW((void)max_tip_force(statics, kAlongX), InputError);
}

TEST(MaxTipWrench, MomentNeedsRotationJacobian) {
  EXPECT_THROW((void)max_tip_wrench(cross(), {kX, kNone}), InputError);
}

TEST(MaxTipWrench, AgreesWithLargestForceWhereNoMomentIsAsked) {
  EXPECT_NEAR(max_tip_wrench(published_index(), {kNone, 2 * kY}).multiple,
              max_tip_force(published_index(), kY).component / 2, 1e-12);
}

// Stability. F0 from 1e-3 to 1e3 N: the weakest tendon of each axis decides, to full precision.
TEST(LargestForceStability, TensionsOfRatioOneToAMillion) {
  MatrixXd A(3, 3);
  A << 1, 1, 0, 0, 1, 1, 0, 0, 1e-6;  // z only from tendon 2, which pulls y far more
  const TipStatics statics = map_of(A, Vector3d(1e-3, 1e3, 1e3));
  // f = (1, 1, 0): t = (0, 1000, 0).  f along (0, 1, 1e-6): t_2 alone.
  EXPECT_NEAR(max_tip_force(statics, Vector3d(1, 1, 0)).component, std::sqrt(2.0) * 1e3, 1e-9);
  EXPECT_NEAR(max_tip_force(statics, Vector3d(0, 1, 1e-6)).component, 1e3, 1e-8);
  EXPECT_NEAR(max_tip_force(statics, kAlongX).component, 1e-3, 1e-12);
}

// Two joints whose axes differ by 1e-6 rad: J has columns (0, 1, 0) L and (sin e, cos e, 0) L, so
// a force along x is balanced by joint 2 alone, L sin(e) f = 1 N m.
TEST(LargestForceStability, NearlyParallelAxes) {
  const double e = 1e-6, L = 0.05;
  TipStatics statics = straight_finger();
  statics.J.col(0) = L * kAlongY;
  statics.J.col(1) = L * Vector3d(std::sin(e), std::cos(e), 0);
  const double exact = 1 / (L * std::sin(e));
  EXPECT_NEAR(max_tip_force(statics, kAlongX).component, exact, 1e-9 * exact);
}

MaxTipForceOptions with_prices(double tolerance) {
  MaxTipForceOptions options;
  options.tolerance = tolerance;
  options.prices = true;
  return options;
}

// Along the diagonal of the cross both pulls must be alike, and +x is at its 2 N: a newton more of
// it gives sqrt(2) N, a newton more of any other nothing.
TEST(MaxTipForce, PricesTheMuscleThatLimits) {
  const ForceLimitPrices prices = max_tip_force(cross(), Vector3d(1, 1, 0), with_prices(0)).prices;
  EXPECT_TRUE(matrix_near(prices.increase, Eigen::Vector4d(std::sqrt(2.0), 0, 0, 0), 1e-12));
  EXPECT_FALSE(prices.degenerate());
}

// Where +x and +y have 2 N each they limit together: one alone gives nothing more.
TEST(MaxTipForce, PricesLimitsThatMeet) {
  TipStatics statics = cross();
  statics.max_tension = Eigen::Vector4d(2, 2, 5, 7);
  const ForceLimitPrices prices = max_tip_force(statics, Vector3d(1, 1, 0), with_prices(0)).prices;
  EXPECT_TRUE(matrix_near(prices.increase, Eigen::Vector4d::Zero(), 1e-12));
  EXPECT_TRUE(
      matrix_near(prices.decrease.head<2>(), Eigen::Vector2d::Constant(std::sqrt(2.0)), 1e-12));
  EXPECT_TRUE(prices.degenerate());
}

// Strong duality without passive torque: the force is what its limits are worth.
TEST(MaxTipForce, IsWorthItsLimits) {
  const TipStatics statics = published_index();
  for (const double tolerance : {0.0, 0.1, 0.5}) {
    const MaxTipForce largest =
        max_tip_force(statics, Vector3d(1, -2, 0.5), with_prices(tolerance));
    ASSERT_EQ(largest.status, Status::kSolved);
    EXPECT_NEAR(largest.prices.increase.dot(statics.max_tension), largest.component,
                1e-7 * largest.component);
    EXPECT_LT(largest.prices.gap, 1e-7 * largest.component);
    EXPECT_LT(largest.prices.dual_violation, 1e-7);
  }
}

TEST(MaxTipForce, IsNotPricedUnlessAsked) {
  EXPECT_EQ(max_tip_force(cross(), Vector3d(1, 1, 0)).prices.increase.size(), 0);
}

// Two links at right angles whose axes are parallel: a cone is searched in the plane alone, and the
// bones, which carry any force across it, get none. The plane is scanned direction by direction.
TEST(MaxTipForce, LeavesOutWhatBonesCarryAlone) {
  TipStatics statics = straight_finger();
  statics.J.row(0) << -0.03, -0.03;
  statics.J.row(1) << 0.04, 0;
  statics.max_tension << 100, 40, 70, 20;
  const double tolerance = radians(20);
  for (const Vector3d& d : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0.6, 0.8, 0)}) {
    const MaxTipForce result = max_tip_force(statics, d, {tolerance, false});
    ASSERT_EQ(result.status, Status::kSolved);
    EXPECT_NEAR(result.force.z(), 0, 1e-9);
    EXPECT_LT(result.check.outside, 1e-9);
    EXPECT_LT(result.check.imbalance, 1e-9);
    double scanned = 0;
    for (int k = -500; k <= 500; ++k) {
      const double angle = tolerance * k / 500;
      const Vector3d turned = Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * d;
      scanned = std::max(scanned, std::cos(angle) * max_tip_force(statics, turned).component);
    }
    EXPECT_LE(scanned, result.component + 1e-9);
    EXPECT_GE(scanned, 0.999 * result.component);  // a thousand directions
  }
}

}  // namespace
}  // namespace thenar
