// Tests for tendons/forces/constrained_force.cpp and force_limits.cpp.

#include "tendons/forces/constrained_force.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tendons/forces/coordination.h"
#include "tendons/forces/max_tip_force.h"
#include "tests/matrix_near.h"
#include "tests/tendons/published_index.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kClose = 1e-6;  // relative, of a force by the interior-point method
const Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// Tendon i makes the force t_i along axis i, up to 2, 3, 5 N.
TipStatics box() {
  return statics_from_matrix(Eigen::Matrix3d::Identity(), Eigen::Matrix3Xd(3, 0),
                             Vector3d(2, 3, 5));
}

class Directions : public testing::TestWithParam<int> {
 public:
  static Vector3d direction() {
    const int i = GetParam();
    return Vector3d(std::cos(2.0 * i), std::sin(2.0 * i), std::sin(3.0 * i));
  }
};

TEST_P(Directions, WithoutLimitsAgreesWithTheLinearProgram) {
  const double exact = max_tip_force(published_index(), direction()).component;
  const ConstrainedForce result =
      constrained_force(published_index(), direction(), ForceDirection::kAlong, {});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_NEAR(result.component, exact, kClose * (1 + exact));
}

TEST_P(Directions, FrictionConeAgreesWithCuttingPlanes) {
  const double angle = 0.3;
  const double exact = max_tip_force(published_index(), direction(), {angle}).component;
  const ConstrainedForce result =
      constrained_force(published_index(), direction(), ForceDirection::kComponent,
                        {friction_constraint(direction(), std::tan(angle))});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_NEAR(result.component, exact, 10 * kClose * (1 + exact));
}

INSTANTIATE_TEST_SUITE_P(Twelve, Directions, testing::Range(0, 12));

TEST(ConstrainedForce, FreeComponentIsTheSupportOfTheSet) {
  const ConstrainedForce result =
      constrained_force(box(), Vector3d(1, 1, -1), ForceDirection::kComponent, {});
  EXPECT_NEAR(result.component, 5 / std::sqrt(3.0), kClose);
  EXPECT_TRUE(matrix_near(result.force, Vector3d(2, 3, 0), 10 * kClose));
}

// Effort (f/2)^2 <= 1/4 along x.
TEST(ConstrainedForce, EffortLimitsAForce) {
  const ConstrainedForce result = constrained_force(
      box(), kX, ForceDirection::kAlong, {effort_constraint(Vector3d(2, 3, 5), 2, 0.25)});
  EXPECT_NEAR(result.component, 1, kClose);
}

// At the greatest force along x under effort c, the least effort for that force is c.
TEST(ConstrainedForce, EffortLimitIsTheInverseOfCoordination) {
  const TipStatics s = published_index();
  const ConstrainedForce result =
      constrained_force(s, kX, ForceDirection::kAlong, {effort_constraint(s.max_tension, 2, 1.0)});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_NEAR(coordinate(s, result.force, {2}).effort, 1.0, 1e-5);
}

// |f| <= 1 N as a load: along the diagonal of the box the force is 1 N, whatever the tendons.
TEST(ConstrainedForce, LoadStaysInItsEllipsoid) {
  const ConstrainedForce result = constrained_force(
      box(), Vector3d(1, 1, 1), ForceDirection::kComponent,
      {load_constraint(Eigen::Matrix3d::Identity(), MatrixXd::Zero(3, 3), Vector3d::Zero())});
  EXPECT_NEAR(result.component, 1, kClose);
  EXPECT_TRUE(matrix_near(result.force, Vector3d::Constant(1 / std::sqrt(3.0)), 1e-4));
}

// The direction (2, 3, 0) lies on the cone of mu = 1.5 about x: a limit that just does not bind.
TEST(ConstrainedForce, LimitThatOnlyTouchesTakesNothing) {
  const ConstrainedForce result = constrained_force(
      box(), Vector3d(2, 3, 0), ForceDirection::kAlong, {friction_constraint(kX, 1.5)});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_NEAR(result.component, std::sqrt(13.0), 1e-4);  // all along it |f_t| = 1.5 f_n
}

// A straight finger: the skeleton carries x; friction of 0.5 about y then bounds it by f_y.
TEST(ConstrainedForce, FrictionBoundsWhatTheSkeletonCarries) {
  TipStatics s;
  s.J = Vector3d(0, 0.05, 0);
  s.R = MatrixXd::Constant(1, 1, 0.01);
  s.tau_0 = VectorXd::Zero(1);
  s.max_tension = VectorXd::Constant(1, 100);  // 1 N m: f_y <= 20 N
  EXPECT_EQ(max_tip_force(s, kX).status, Status::kUnbounded);
  const ConstrainedForce result =
      constrained_force(s, kX, ForceDirection::kComponent, {friction_constraint(kY, 0.5)});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_NEAR(result.component, 10, 1e-4);
}

TEST(ConstrainedForce, StatesWhatIsLeft) {
  const ConstrainedForce result =
      constrained_force(published_index(), Vector3d(1, 0, 0), ForceDirection::kAlong, {});
  EXPECT_LT(result.kkt_residual.stationarity, 1e-6 * result.component);
  EXPECT_LT(result.kkt_residual.complementarity, 1e-6 * result.component);
  EXPECT_LT(result.imbalance, 1e-12);
}

TEST(ConstrainedForce, ImpossibleLimitIsInfeasible) {
  const ForceConstraint never = [](const Vector3d& f, const VectorXd& t) {
    ConstraintValue value{VectorXd::Constant(1, 1 + f.squaredNorm()), 2 * f.transpose(),
                          MatrixXd::Zero(1, t.size())};
    return value;
  };
  const ConstrainedForce result = constrained_force(box(), kX, ForceDirection::kComponent, {never});
  EXPECT_EQ(result.status, Status::kInfeasible) << result.message;
  EXPECT_GE(result.excess, 1 - 1e-6);
}

TEST(ConstrainedForce, TorqueNobodyBalancesIsInfeasible) {
  TipStatics s = published_index();
  s.tau_0(3) = 10;
  EXPECT_EQ(constrained_force(s, kX, ForceDirection::kAlong, {}).status, Status::kInfeasible);
}

// Gradients against central differences at a general point.
class Limits : public testing::TestWithParam<int> {
 public:
  static ForceConstraint limit() {
    const std::vector<ForceConstraint> all{
        effort_constraint(Vector3d(2, 3, 5), 3, 1), friction_constraint(Vector3d(1, 2, 3), 0.4),
        load_constraint(Vector3d(1, 2, 3).asDiagonal().toDenseMatrix(), 0.5 * MatrixXd::Ones(3, 3),
                        Vector3d(0.1, 0.2, 0.3))};
    return all[static_cast<std::size_t>(GetParam())];
  }
};

TEST_P(Limits, GradientsAgreeWithDifferences) {
  const Vector3d f(0.3, -0.7, 1.1);
  const VectorXd t = Vector3d(0.4, 0.9, 1.6);
  const double h = 1e-6, tolerance = 1e-8;
  const ConstraintValue at = limit()(f, t);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const VectorXd e = h * VectorXd::Unit(3, i);
    const VectorXd by_f = (limit()(f + e, t).g - limit()(f - e, t).g) / (2 * h);
    const VectorXd by_t = (limit()(f, t + e).g - limit()(f, t - e).g) / (2 * h);
    EXPECT_TRUE(matrix_near(at.dg_df.col(i), by_f, tolerance));
    EXPECT_TRUE(matrix_near(at.dg_dt.col(i), by_t, tolerance));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Limits, testing::Range(0, 3));

TEST(ForceLimits, RefuseBadArguments) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)effort_constraint(Vector3d(1, 2, infinity), 2, 1), InputError);
  EXPECT_THROW((void)effort_constraint(Vector3d(1, 2, 3), 0.5, 1), InputError);
  EXPECT_THROW(
      (void)effort_constraint(Vector3d(1, 2, 3), 2, 1)(Vector3d(1, 0, 0), VectorXd::Ones(2)),
      InputError);
  EXPECT_THROW((void)friction_constraint(kX, -0.1), InputError);
  EXPECT_THROW((void)friction_constraint(Vector3d::Zero(), 0.5), InputError);
  EXPECT_THROW((void)load_constraint(Eigen::MatrixX3d(2, 3), MatrixXd(3, 1), VectorXd(2)),
               InputError);
}

}  // namespace
}  // namespace thenar
