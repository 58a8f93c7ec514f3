// Tests for dynamics/compliant/penalty_law.cpp.

#include "dynamics/compliant/penalty_law.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/dynamics/compliant/creep_speed.h"

namespace thenar {
namespace {

TEST(PenaltyLaw, LinearSpringIsThatOfAHandCalculation) {
  const NormalLoad rest = linear_normal_load(1e3, 2, 1e-3, 0);
  EXPECT_DOUBLE_EQ(rest.force, 1);
  EXPECT_DOUBLE_EQ(rest.energy, 0.5e-3);
  EXPECT_DOUBLE_EQ(linear_normal_load(1e3, 2, 1e-3, 0.1).force, 1.2);
  EXPECT_EQ(linear_normal_load(1e3, 2, 1e-3, -1).force, 0);  // what is pulled away does not stick
  EXPECT_EQ(linear_normal_load(1e3, 2, -1e-3, 1).force, 0);
}

// Two rigid balls of 20 mm that overlap by 0.1 mm: 4/3 * 1e6 * sqrt(0.01) * 1e-6 = 0.1333 N.
TEST(PenaltyLaw, HertzSpringIsThatOfAHandCalculation) {
  const NormalLoad rest = hertz_normal_load(1e6, 0.01, 0.2, 1e-4, 0);
  EXPECT_NEAR(rest.force, 0.4 / 3, 1e-15);
  EXPECT_NEAR(hertz_normal_load(1e6, 0.01, 0.2, 1e-4, 0.1).force, 1.03 * 0.4 / 3, 1e-15);
  EXPECT_EQ(hertz_normal_load(1e6, 0.01, 0.2, 1e-4, -4).force, 0);
}

TEST(PenaltyLaw, ForcesAreTheSlopesOfEnergies) {
  const double h = 1e-9;  // [m]
  for (const double depth : {1e-6, 1e-5, 1e-3}) {
    const auto slope = [&](const auto& load) {
      return (load(depth + h).energy - load(depth - h).energy) / (2 * h);
    };
    const auto linear = [](double d) { return linear_normal_load(1e5, 0, d, 0); };
    const auto hertz = [](double d) { return hertz_normal_load(1e7, 0.02, 0, d, 0); };
    EXPECT_NEAR(slope(linear) / linear(depth).force, 1, 1e-6);
    EXPECT_NEAR(slope(hertz) / hertz(depth).force, 1, 1e-6);
  }
}

// 10 * 0.064 - 15 * 0.0256 + 6 * 0.01024 = 0.31744.
TEST(PenaltyLaw, RampsRiseFromRestToCoulomb) {
  EXPECT_NEAR(friction_ratio(FrictionRamp::kQuintic, 0.4), 0.31744, 1e-15);
  EXPECT_EQ(friction_ratio(FrictionRamp::kLinear, 0.4), 0.4);
  for (const FrictionRamp ramp : {FrictionRamp::kQuintic, FrictionRamp::kLinear}) {
    EXPECT_EQ(friction_ratio(ramp, 0), 0);
    EXPECT_EQ(friction_ratio(ramp, 1), 1);
    EXPECT_EQ(friction_ratio(ramp, 7), 1);
    for (const double share : {0.0, 0.1, 0.5, 0.99})
      EXPECT_NEAR(friction_ratio(ramp, closed_form::creep_speed(ramp, share)), share, 1e-14);
  }
}

TEST(PenaltyLaw, FrictionOpposesSlip) {
  ContactCompliance compliance;
  compliance.transition = 0.01;
  const TangentialLoad load =
      friction_load(compliance, {0.5, 0, 0}, 2, Eigen::Vector3d(0, 0.03, -0.04), 5);
  EXPECT_LT((load.force - Eigen::Vector3d(0, -0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(load.torsion, 0);  // a point has none
}

// Where a patch slides, force and torque lie on |f|^2 + (torque / e)^2 = (mu f_n)^2, along (u, e
// w).
TEST(PenaltyLaw, SoftFingersSlideOnTheEllipsoid) {
  ContactCompliance compliance;
  const double e = 0.004;
  const TangentialLoad load =
      friction_load(compliance, {0.5, e, 0}, 2, Eigen::Vector3d(0.03, 0, 0), 10);
  EXPECT_NEAR(std::hypot(load.force.norm(), load.torsion / e), 1, 1e-15);
  EXPECT_NEAR(load.torsion / e / load.force.x(), e * 10 / 0.03, 1e-12);
  EXPECT_LT(load.torsion, 0);
}

TEST(PenaltyLaw, RefusesImpossibleSprings) {
  ContactCompliance compliance;
  compliance.transition = 0;
  EXPECT_THROW(check_compliance(compliance), InputError);
  compliance = {};
  compliance.dissipation = -1;
  EXPECT_THROW(check_compliance(compliance), InputError);
  compliance = {};
  compliance.stiffness = std::nan("");
  EXPECT_THROW(check_compliance(compliance), InputError);
}

}  // namespace
}  // namespace thenar
