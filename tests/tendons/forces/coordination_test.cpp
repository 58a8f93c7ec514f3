// Tests for tendons/forces/coordination.cpp.

#include "tendons/forces/coordination.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "base/error.h"
#include "tendons/forces/max_tip_force.h"
#include "tests/matrix_near.h"
#include "tests/tendons/published_index.h"

namespace thenar {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kCloseActivation =
    1e-7;  // of an activation, from the tolerance of the interior point

// One hinge that moves the tip along y at 0.05 m; tendons with the given arms [m] and F0 [N].
TipStatics one_hinge(const VectorXd& arms, const VectorXd& F0) {
  TipStatics s;
  s.J = Vector3d(0, 0.05, 0);
  s.R = arms;
  s.tau_0 = VectorXd::Zero(1);
  s.max_tension = F0;
  return s;
}

const Vector2d kArms(0.010, 0.006), kF0(100, 300);

class Synergists : public testing::TestWithParam<double> {};

// Stationary: p (t_i / F_i)^(p-1) / F_i = mu r_i, so a_i is in proportion to (r_i F_i)^(1/(p-1)),
// and the sum of r_i F_i a_i is the torque 0.05 f.
TEST_P(Synergists, ShareByTheClosedForm) {
  const double p = GetParam(), f = 10;
  const ArrayXd strength = kArms.cwiseProduct(kF0);  // (1.0, 1.8) N m
  const ArrayXd shape = strength.pow(1 / (p - 1));
  const VectorXd expected = 0.05 * f / (strength * shape).sum() * shape;
  const Coordination result = coordinate(one_hinge(kArms, kF0), f * Vector3d(0, 1, 0), {p});
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_TRUE(matrix_near(result.activation, expected, kCloseActivation));
  EXPECT_NEAR(result.tau_residual(0), 0, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Powers, Synergists, testing::Values(1.5, 2.0, 3.0, 5.0, 10.0));

// p = 1: the muscle of the larger torque at full activation, r F0, goes first.
TEST(Coordination, FirstPowerUsesTheStrongestFirst) {
  const Coordination result = coordinate(one_hinge(kArms, kF0), Vector3d(0, 10, 0), {1});
  EXPECT_TRUE(matrix_near(result.activation, Vector2d(0, 0.5 / 1.8), 1e-12));
}

// Torque of 2.3 of at most 2.8 N m with p = 2: shares 2.3 (1, 1.8) / 4.24 = (0.542, 0.976), inside;
// with 2.6 N m the second would be 1.104: it saturates and the first makes 2.6 - 1.8 = 0.8.
TEST(Coordination, SaturatedMuscleIsReplaced) {
  const Coordination result = coordinate(one_hinge(kArms, kF0), Vector3d(0, 52, 0), {2});
  EXPECT_TRUE(matrix_near(result.activation, Vector2d(0.8, 1), kCloseActivation));
}

TEST(Coordination, AntagonistStaysSilent) {
  const Vector2d arms(0.01, -0.01);
  const Coordination result = coordinate(one_hinge(arms, kF0), Vector3d(0, 10, 0), {3});
  EXPECT_TRUE(matrix_near(result.activation, Vector2d(0.5, 0), 1e-4));
}

// KKT of the published finger: with mu of the balance by least squares over the muscles strictly
// between bounds, p a^(p-1) - mu' column vanishes there, is >= 0 at a = 0 and <= 0 at a = 1.
TEST(Coordination, PublishedFingerMeetsOptimalityConditions) {
  const TipStatics s = published_index();
  const Vector3d wanted = 0.6 * max_tip_force(s, Vector3d(1, 0, 0)).force;
  for (const double p : {2.0, 3.0}) {
    const Coordination result = coordinate(s, wanted, {p});
    ASSERT_EQ(result.status, Status::kSolved);
    const MatrixXd columns = s.max_tension.asDiagonal() * s.R;  // (m, n)
    const VectorXd slope = p * result.activation.array().pow(p - 1);
    const ArrayXd inside =
        (result.activation.array() > 1e-3 && result.activation.array() < 1 - 1e-3).cast<double>();
    const MatrixXd weighed = inside.matrix().asDiagonal() * columns;
    const VectorXd mu =
        weighed.completeOrthogonalDecomposition().solve(inside.matrix().cwiseProduct(slope));
    const VectorXd reduced = slope - columns * mu;
    for (Eigen::Index i = 0; i < 7; ++i) {
      const double wrong = inside(i) > 0                  ? std::abs(reduced(i))
                           : result.activation(i) <= 1e-3 ? -reduced(i)
                                                          : reduced(i);
      EXPECT_LE(wrong, 1e-5) << "muscle " << i << " at p " << p;
    }
  }
}

TEST(Coordination, GapBoundsTheEffortThatCouldBeSaved) {
  for (const double p : {1.0, 1.5, 2.0, 3.0, 6.0}) {
    const Coordination result = coordinate(published_index(), Vector3d(10, 0, 0), {p});
    ASSERT_EQ(result.status, Status::kSolved) << p << ": " << result.message;
    EXPECT_GE(result.gap, 0);
    EXPECT_LT(result.gap, 1e-6 * std::max(1.0, result.effort)) << p;
  }
}

TEST(Coordination, BalancesThePublishedFinger) {
  const Coordination result = coordinate(published_index(), Vector3d(10, 0, 0));
  EXPECT_LT(result.tau_residual.norm(), 1e-12);
  EXPECT_GE(result.tension.minCoeff(), 0);
}

TEST(Coordination, LargestForceHasItsActivation) {
  const MaxTipForce largest = max_tip_force(published_index(), Vector3d(1, 0, 0));
  const Coordination result = coordinate(published_index(), largest.force);
  EXPECT_EQ(result.status, Status::kSolved) << result.message;
  EXPECT_TRUE(matrix_near(result.activation, largest.activation, 1e-6));
}

// The hinge reaches 2.8 N m / 0.05 m = 56 N along y; x is carried by the skeleton.
TEST(Coordination, ForceOutOfReachReportsTheNearest) {
  const Coordination result = coordinate(one_hinge(kArms, kF0), Vector3d(4, 60, 0));
  EXPECT_EQ(result.status, Status::kInfeasible);
  EXPECT_TRUE(matrix_near(result.force, Vector3d(4, 56, 0), 1e-5));
  EXPECT_NEAR(result.tau_residual(0), 0.05 * (60 - 56), 1e-6);
}

TEST(Coordination, FirstPowerReportsTheNearestToo) {
  const Coordination result = coordinate(one_hinge(kArms, kF0), Vector3d(0, -5, 0), {1});
  EXPECT_EQ(result.status, Status::kInfeasible);
  EXPECT_TRUE(matrix_near(result.force, Vector3d::Zero(), 1e-5));
}

TEST(Coordination, TorqueNobodyBalancesIsInfeasible) {
  TipStatics s = published_index();
  s.tau_0(3) = 10;  // beyond all tendons together
  const Coordination result = coordinate(s, Vector3d(1, 0, 0));
  EXPECT_EQ(result.status, Status::kInfeasible);
  EXPECT_EQ(result.tension.norm(), 0);
}

TEST(Coordination, ParalysedMuscleIsLeftOut) {
  const Coordination result =
      coordinate(one_hinge(kArms, Vector2d(100, 0)), Vector3d(0, 10, 0), {2});
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(result.activation, Vector2d(0.5, 0), kCloseActivation));
}

TEST(Coordination, StraightFingerCarriesAxialForceForNothing) {
  const Coordination result = coordinate(one_hinge(kArms, kF0), Vector3d(1000, 0, 0), {2});
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.effort, 0, 1e-9);
}

TEST(Coordination, RefusesBadCalls) {
  const TipStatics s = one_hinge(kArms, kF0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)coordinate(s, Vector3d(nan, 0, 0)), InputError);
  EXPECT_THROW((void)coordinate(s, Vector3d::Zero(), {0.5}), InputError);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)coordinate(one_hinge(kArms, Vector2d(1, infinity)), Vector3d::Zero()),
               InputError);
}

// Stability: F0 of 1e-3 and 1e3 N. Strengths 1e-5 and 6 N m; closed form as above with p = 2.
TEST(CoordinationStability, TensionsOfRatioOneToAMillion) {
  const Vector2d F0(1e-3, 1e3);
  const ArrayXd strength = kArms.cwiseProduct(F0);
  const VectorXd expected = 0.05 * 10 / strength.square().sum() * strength;
  const Coordination result = coordinate(one_hinge(kArms, F0), Vector3d(0, 10, 0), {2});
  // The interior point keeps a nearly silent muscle sqrt(1e-13) = 3e-7 off the truth.
  EXPECT_TRUE(matrix_near(result.activation, expected, 4e-7));
}

}  // namespace
}  // namespace thenar
