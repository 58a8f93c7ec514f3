// Tests for grasp/closing/tendon_closing.cpp: a finger of two joints and one tendon.

#include "grasp/closing/tendon_closing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "grasp/closing/close_hand.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

constexpr double kArm0 = 0.010, kGrowth = 0.5, kArm1 = 0.006;  // [m/rad], [1/rad], [m/rad]
constexpr double kStiff0 = 0.3, kStiff1 = 0.1;                 // [N m/rad]

/// Moment arm at the knuckle, which grows as it bends [m/rad].
double arm0(double q0) { return kArm0 * (1 + kGrowth * q0); }

/// Two phalanges flexed by one tendon.
class TendonFinger final : public Hand {
 public:
  const HandLayout& layout() const override { return bones_.layout(); }
  std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override { return bones_.pose(q); }
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(const Eigen::VectorXd& q, int link,
                                                    const Eigen::Vector3d& p) const override {
    return bones_.jacobian(q, link, p);
  }
  Actuation actuation(const Eigen::VectorXd& q) const override {
    Actuation tendon;
    tendon.B = Eigen::Vector2d(arm0(q[0]), kArm1);
    tendon.tau_0 = Eigen::Vector2d::Zero();
    tendon.lower = Eigen::VectorXd::Zero(1);
    tendon.upper = Eigen::VectorXd::Constant(1, 100);
    return tendon;
  }
  const std::vector<LinkSurface>& surfaces() const override { return bones_.surfaces(); }

 private:
  RobotHand bones_{sample::finger(DriveCoupling::kCompliant)};
};

const ClosingTensions kPull{Eigen::VectorXd::Ones(1), Eigen::Vector2d(kStiff0, kStiff1), 0.02};

Eigen::Array<bool, Eigen::Dynamic, 1> marks(bool first, bool second) {
  Eigen::Array<bool, Eigen::Dynamic, 1> free(2);
  free << first, second;
  return free;
}

// Joints turn as arm / stiffness, and the tendon runs in by the sum of arm times turn.
TEST(TendonClosing, SharesExcursionByArmsAndStiffness) {
  const TendonFinger finger;
  const Eigen::Vector2d q(0.8, 0.3);
  const Eigen::VectorXd rates = tendon_rates(finger, kPull, q, marks(true, true));
  EXPECT_NEAR(rates[0] / rates[1], (arm0(0.8) / kStiff0) / (kArm1 / kStiff1), 1e-12);
  EXPECT_NEAR(arm0(0.8) * rates[0] + kArm1 * rates[1], kPull.excursion, 1e-15);
}

TEST(TendonClosing, GivesAllExcursionToTheJointThatIsFree) {
  const TendonFinger finger;
  const Eigen::Vector2d q(0.8, 0.3);
  const Eigen::VectorXd outer = tendon_rates(finger, kPull, q, marks(false, true));
  EXPECT_EQ(outer[0], 0);
  EXPECT_NEAR(outer[1], kPull.excursion / kArm1, 1e-12);
  EXPECT_TRUE(tendon_rates(finger, kPull, q, marks(false, false)).isZero(0));
}

// dq1 / dq0 = (arm1 / k1) / (arm0(q0) / k0):  q1 = arm1 k0 / (k1 kArm0 growth) ln(1 + growth q0).
TEST(TendonClosing, FollowsThePostureWhileTheHandCloses) {
  const TendonFinger finger;
  std::vector<Eigen::VectorXd> path;
  CloseOptions options;
  options.refresh = 0.002;
  options.rates = [&](const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free) {
    if (free.all()) path.push_back(q);
    return tendon_rates(finger, kPull, q, free);
  };
  const ShapeSpec ball = sample::shape(ShapeKind::kSphere, {0.01, 0, 0});
  const ClosedHand closed =
      close_hand(collision_hand(finger), {}, Eigen::Vector2d::Zero(),
                 sample::setup({sample::placed("ball", ball, {0, 0, 1})}), options);
  ASSERT_TRUE(closed.finished);
  EXPECT_TRUE(closed.q.isApprox(finger.layout().upper, 1e-12));
  ASSERT_GT(path.size(), 100u);  // steps of 2 mrad: both joints are free for 0.2 rad or more
  for (const Eigen::VectorXd& q : path) {
    const double expected =
        kArm1 * kStiff0 / (kStiff1 * kArm0 * kGrowth) * std::log1p(kGrowth * q[0]);
    EXPECT_NEAR(q[1], expected, 2e-3);  // Euler's steps of 2 mrad: half a step's change of slope
  }
}

// The ball stops the proximal phalanx; the tendon goes on to bend the distal one.
TEST(TendonClosing, BendsTheDistalPhalanxRoundAnObject) {
  const TendonFinger finger;
  CloseOptions options;
  options.rates = [&](const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free) {
    return tendon_rates(finger, kPull, q, free);
  };
  const ShapeSpec ball = sample::shape(ShapeKind::kSphere, {0.01, 0, 0});
  const ClosedHand closed =
      close_hand(collision_hand(finger), {}, Eigen::Vector2d::Zero(),
                 sample::setup({sample::placed("ball", ball, {0.025, 0.02, 0})}), options);
  ASSERT_TRUE(closed.finished);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kContact);
  EXPECT_GT(closed.q[1], 2 * closed.q[0]);
}

// Only ratios of tensions count.
TEST(TendonClosing, MakesRatesForClosing) {
  const TendonFinger finger;
  const Eigen::Vector2d q(0.8, 0.3);
  const ClosingTensions equal{Eigen::VectorXd::Ones(1), Eigen::Vector2d::Ones(), 0.01};
  const ClosingRates rates = tendon_closing_rates(finger, Eigen::VectorXd::Constant(1, 7));
  EXPECT_TRUE(rates(q, marks(true, true))
                  .isApprox(tendon_rates(finger, equal, q, marks(true, true)), 1e-12));
  EXPECT_EQ(rates(q, marks(true, false))[1], 0);
}

TEST(TendonClosing, RejectsImpossiblePulls) {
  const TendonFinger finger;
  const Eigen::Vector2d q(0, 0);
  ClosingTensions pull = kPull;
  pull.u[0] = -1;
  EXPECT_THROW((void)tendon_rates(finger, pull, q, marks(true, true)), InputError);
  pull = kPull;
  pull.stiffness[1] = 0;
  EXPECT_THROW((void)tendon_rates(finger, pull, q, marks(true, true)), InputError);
  EXPECT_THROW((void)tendon_closing_rates(finger, Eigen::VectorXd::Zero(1)), InputError);
  EXPECT_THROW((void)tendon_closing_rates(finger, Eigen::VectorXd::Ones(2)), InputError);
}

}  // namespace
}  // namespace thenar
