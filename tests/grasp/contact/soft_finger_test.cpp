// Tests for grasp/contact/soft_finger.cpp.

#include "grasp/contact/soft_finger.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "base/error.h"

namespace thenar {
namespace {

constexpr double kFriction = 0.7;

/// mu int p r dA / int p dA over a disc of radius a, by the midpoint rule.
double torsion_by_integration(double a, const std::function<double(double)>& pressure) {
  constexpr int kRings = 100'000;
  double torque = 0, force = 0;
  for (int i = 0; i < kRings; ++i) {
    const double r = a * (i + 0.5) / kRings;
    torque += pressure(r / a) * r * r;
    force += pressure(r / a) * r;
  }
  return kFriction * torque / force;
}

// A ball of 10 mm on a mattress: the springs under it carry the load, and hold the torque.
TEST(SoftFinger, WinklerLayerBalancesItsLoad) {
  constexpr double kForce = 5, kYoung = 1.5e6, kThickness = 0.003, kR = 0.01;
  const SoftPatch patch = winkler_patch(kForce, kYoung, kThickness, kR, kR, kFriction);
  double carried = 0;
  constexpr int kRings = 10'000;
  for (int i = 0; i < kRings; ++i) {
    const double r = patch.a * (i + 0.5) / kRings;
    const double pressure = kYoung / kThickness * (patch.depth - r * r / (2 * kR));
    carried += pressure * 2 * kPi * r * patch.a / kRings;
  }
  EXPECT_NEAR(carried, kForce, 1e-6 * kForce);  // the midpoint rule's
  const auto paraboloid = [](double rho) { return 1 - rho * rho; };
  EXPECT_NEAR(patch.torsion, torsion_by_integration(patch.a, paraboloid), 1e-9);
}

TEST(SoftFinger, PowerLawHoldsTheTorqueOfHertz) {
  const SoftPatch patch = power_law_patch(8, 0.002, 1.0 / 3, kFriction);
  EXPECT_NEAR(patch.a, 0.004, 1e-15);
  const auto hertz = [](double rho) { return std::sqrt(1 - rho * rho); };
  EXPECT_NEAR(patch.torsion, torsion_by_integration(patch.a, hertz), 1e-9);
}

TEST(SoftFinger, HoldsNothingWithoutLoadOrFriction) {
  EXPECT_EQ(winkler_patch(0, 1e6, 0.003, 0.01, 0.02, kFriction).torsion, 0);
  EXPECT_EQ(winkler_patch(5, 1e6, 0.003, 0.01, 0.02, 0).torsion, 0);
}

TEST(SoftFinger, RejectsImpossibleLayers) {
  EXPECT_THROW((void)winkler_patch(1, 0, 0.003, 0.01, 0.01, 1), InputError);
  EXPECT_THROW((void)power_law_patch(1, 0.002, 0.5, 1), InputError);
}

}  // namespace
}  // namespace thenar
