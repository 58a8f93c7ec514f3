// Tests for tendons/muscle/joint_resistance.cpp.

#include "tendons/muscle/joint_resistance.h"

#include <gtest/gtest.h>

#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

Skeleton stiff_rod() {
  Subject subject = sample::Pendulum().subject();
  subject.joints[0].lower = -0.5;
  subject.joints[0].upper = 1;
  subject.joints[0].stiffness = 0.3;
  subject.joints[0].rest = 0.1;
  return build_skeleton(subject);
}

constexpr JointResistance kResistance{20, 0.04, 0.002};

double torque(double q) {
  return resistance_torque(stiff_rod(), kResistance, Eigen::VectorXd::Constant(1, q))[0];
}

double energy(double q) {
  return resistance_energy(stiff_rod(), kResistance, Eigen::VectorXd::Constant(1, q));
}

TEST(JointResistance, SpringAloneWithinLimits) {
  EXPECT_NEAR(torque(0.9), -0.3 * 0.8, 1e-15);
  EXPECT_NEAR(torque(-0.4), 0.3 * 0.5, 1e-15);
}

// Spring -0.3 (q - 0.1); stop 20 d^2 / 0.08 for d < 0.04, 20 (d - 0.02) beyond.
TEST(JointResistance, StopsBeyondLimits) {
  EXPECT_NEAR(torque(1.02), -0.3 * 0.92 - 20 * 0.02 * 0.02 / 0.08, 1e-14);
  EXPECT_NEAR(torque(1.10), -0.3 * 1.00 - 20 * 0.08, 1e-14);
  EXPECT_NEAR(torque(-0.60), 0.3 * 0.70 + 20 * 0.08, 1e-14);
}

TEST(JointResistance, TorqueIsMinusSlopeOfEnergy) {
  constexpr double h = 1e-6;
  for (const double q : {-0.7, -0.52, -0.3, 0.5, 1.01, 1.039, 1.041, 1.3})
    EXPECT_NEAR(torque(q), -(energy(q + h) - energy(q - h)) / (2 * h), 1e-8) << q;  // rounding / h
}

TEST(JointResistance, DampingOfTheSubjectWins) {
  Subject subject = sample::Pendulum().subject();
  EXPECT_EQ(joint_damping(build_skeleton(subject), kResistance)[0], 0.002);
  subject.joints[0].damping = 0.5;
  EXPECT_EQ(joint_damping(build_skeleton(subject), kResistance)[0], 0.5);
}

}  // namespace
}  // namespace thenar
