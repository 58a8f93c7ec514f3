// Tests for hand/passive_moment.cpp.

#include "hand/passive_moment.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/hand/sample_subjects.h"

namespace thenar {
namespace {

/// Linear, with ends of its own hinge and of one that follows at -0.7 q + 0.2.
CoordinateLimits stiff_coordinate() {
  CoordinateLimits limits{-1, 1.5, 0.3, 0.04, 0};
  limits.ends.push_back({1, 0, 0.3, {0.02, 0.25}, {0.01, 0.15}});
  limits.ends.push_back({-0.7, 0.2, 0.1, {0.03, 0.3}, {0, 1}});
  return limits;
}

// By hand: x = 0.5 past rest, 0.04 x + 0.02 (e^2 - 1) - 0.01 (e^(-0.5 / 0.15) - 1).
TEST(PassiveMoment, IsTwoExponentialsAboutALine) {
  CoordinateLimits limits = stiff_coordinate();
  limits.ends.pop_back();
  const double expected =
      -0.04 * 0.5 - 0.02 * (std::exp(2.0) - 1) + 0.01 * (std::exp(-0.5 / 0.15) - 1);
  EXPECT_NEAR(passive_moment(limits, 0.8), expected, 1e-16);
  EXPECT_EQ(passive_moment(limits, 0.3), 0);
  EXPECT_EQ(passive_energy(limits, 0.3), 0);
}

// A hinge that follows at ratio r has the power m r q' on the coordinate.
TEST(PassiveMoment, FollowersActByTheirRatio) {
  CoordinateLimits leader = stiff_coordinate(), alone = stiff_coordinate();
  leader.ends.erase(leader.ends.begin());
  leader.stiffness = alone.stiffness = 0;
  alone.ends = {{1, 0, 0.1, {0.03, 0.3}, {0, 1}}};
  for (const double q : {-0.9, 0.2, 1.4})
    EXPECT_NEAR(passive_moment(leader, q), -0.7 * passive_moment(alone, -0.7 * q + 0.2), 1e-16);
}

TEST(PassiveMoment, SlopesAreThoseOfMomentAndEnergy) {
  const CoordinateLimits limits = stiff_coordinate();
  constexpr double h = 1e-6;
  for (const double q : {-1.2, -0.4, 0.3, 0.9, 1.6, 2.9, 4.0}) {  // the last two past kMaxExponent
    const double moment = passive_moment(limits, q), slope = passive_moment_slope(limits, q);
    EXPECT_NEAR(slope, (passive_moment(limits, q + h) - passive_moment(limits, q - h)) / (2 * h),
                1e-8 * (1 + std::abs(slope)))
        << q;
    EXPECT_NEAR(moment, -(passive_energy(limits, q + h) - passive_energy(limits, q - h)) / (2 * h),
                1e-8 * (1 + std::abs(moment)))
        << q;
  }
}

TEST(PassiveMoment, FallsEverywhereWithoutOverflow) {
  const CoordinateLimits limits = stiff_coordinate();
  double before = std::numeric_limits<double>::infinity();
  for (double q = -400; q <= 400; q += 0.37) {
    const double moment = passive_moment(limits, q);
    EXPECT_TRUE(std::isfinite(moment) && std::isfinite(passive_energy(limits, q))) << q;
    EXPECT_LT(moment, before) << q;
    EXPECT_LT(passive_moment_slope(limits, q), 0) << q;
    before = moment;
  }
}

TEST(PassiveMoment, SkeletonsTakeItFromTheirJoints) {
  Subject subject = sample::coupled_digit();
  for (JointAxis& joint : subject.joints) joint.flexing = {0.02, 0.4};
  const Skeleton skeleton = build_skeleton(subject);
  EXPECT_TRUE(has_passive(skeleton));
  EXPECT_EQ(skeleton.limits[2].ends.size(), 2);  // PIP, and DIP, which follows
  const Skeleton without = build_skeleton(with_passive(subject, PassiveMoments::kOff));
  EXPECT_FALSE(has_passive(without));
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(without.coordinates(), 0.1, 0.9);
  EXPECT_TRUE(passive_torque(without, q).isZero(0));
  EXPECT_EQ(without.limits[2].damping, skeleton.limits[2].damping);
}

}  // namespace
}  // namespace thenar
