// Tests for pad_laws/soft_patch.cpp.

#include "pad_laws/soft_patch.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr double kPadFriction = 0.7;

/// mu int p r dA / int p dA over a disc of radius a, by the midpoint rule.
double torsion_by_integration(double a, const std::function<double(double)>& pressure) {
  constexpr int kRings = 100'000;
  double torque = 0, force = 0;
  for (int i = 0; i < kRings; ++i) {
    const double r = a * (i + 0.5) / kRings;
    torque += pressure(r / a) * r * r;
    force += pressure(r / a) * r;
  }
  return kPadFriction * torque / force;
}

/// The same over an ellipse, ring by ring and ray by ray; p(s), s from centre to rim.
double torsion_of_ellipse(double a, double b, const std::function<double(double)>& pressure) {
  constexpr int kRings = 1000, kRays = 120;
  double torque = 0, force = 0;
  for (int i = 0; i < kRings; ++i) {
    const double s = (i + 0.5) / kRings, weight = pressure(s) * s;
    force += kRays * weight;
    for (int k = 0; k < kRays; ++k) {
      const double theta = 2 * kPi * (k + 0.5) / kRays;
      torque += weight * s * std::hypot(a * std::cos(theta), b * std::sin(theta));
    }
  }
  return kPadFriction * torque / force;
}

TEST(SoftFinger, EllipsesHoldTheTorqueOfTheirMeanRadius) {
  const auto uniform = [](double) { return 1.0; };
  const auto hertz = [](double s) { return std::sqrt(1 - s * s); };
  const auto paraboloid = [](double s) { return 1 - s * s; };
  constexpr double kA = 0.006, kRule = 1e-4;  // the midpoint rule's, relative
  for (const double b : {0.006, 0.004, 0.002, 0.0006}) {
    const auto expect = [&](PatchPressure pressure, const std::function<double(double)>& p) {
      const double expected = torsion_of_ellipse(kA, b, p);
      EXPECT_NEAR(patch_torsion(kA, b, pressure, kPadFriction), expected, kRule * expected) << b;
      EXPECT_EQ(patch_torsion(kA, b, pressure, kPadFriction),
                patch_torsion(b, kA, pressure, kPadFriction));
    };
    expect(PatchPressure::kUniform, uniform);
    expect(PatchPressure::kHertz, hertz);
    expect(PatchPressure::kParaboloid, paraboloid);
  }
}

TEST(SoftFinger, MeanRadiusIsThatOfACircleAndTwoThirdsOfALine) {
  EXPECT_NEAR(mean_radius(0.003, 0.003), 0.003, 1e-17);
  EXPECT_NEAR(mean_radius(0.003, 0), 2 * 0.003 / kPi, 1e-17);  // there and back: 4 a
  EXPECT_EQ(mean_radius(0, 0), 0);
}

TEST(SoftFinger, OblongLayersHoldMoreThanTheirRoot) {
  const SoftPatch patch = winkler_patch(1, 1e6, 0.003, 0.09, 0.01, kPadFriction);
  EXPECT_NEAR(patch.a / patch.b, 3, 1e-12);
  const double root = 8.0 / 15 * kPadFriction * std::sqrt(patch.a * patch.b);
  EXPECT_NEAR(root / patch.torsion, 0.81, 0.005);  // 19 % too little
}

// Steel balls of 20 mm pressed by 10 N, worked out by hand: E* = 115.4 GPa, R = 10 mm.
TEST(SoftFinger, HertzBallsTouchInASmallCircle) {
  const double modulus = contact_modulus(210e9, 0.3, 210e9, 0.3);
  EXPECT_NEAR(modulus, 210e9 / 1.82, 1);
  const SoftPatch patch = hertz_patch(10, modulus, 0.01, kPadFriction);
  EXPECT_NEAR(patch.a, 86.6e-6, 0.1e-6);
  // p = p0 sqrt(1 - s^2), p0 = 2 E* a / (pi R), carries 2/3 pi a^2 p0.
  const double p0 = 2 * modulus * patch.a / (kPi * 0.01);
  EXPECT_NEAR(2.0 / 3 * kPi * patch.a * patch.a * p0, 10, 1e-9);
  EXPECT_NEAR(patch.depth, patch.a * patch.a / 0.01, 1e-18);
}

TEST(SoftFinger, RigidPartnersLeaveOneModulus) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(contact_modulus(3e6, 0.5, infinite, 0.3), 4e6, 1e-6);
}

// Hooke's law with no strain sideways: stresses sideways are nu / (1 - nu) of that along.
TEST(SoftFinger, ConfinedLayersAreStiffer) {
  constexpr double kNu = 0.4, kYoung = 25e3;
  const double modulus = confined_modulus(kYoung, kNu), aside = kNu / (1 - kNu) * modulus;
  EXPECT_NEAR((modulus - 2 * kNu * aside) / kYoung, 1, 1e-12);  // strain along
  EXPECT_NEAR(confined_modulus(kYoung, 0), kYoung, 1e-9);
}

// A ball of 10 mm on a mattress: the springs under it carry the load, and hold the torque.
TEST(SoftFinger, WinklerLayerBalancesItsLoad) {
  constexpr double kForce = 5, kYoung = 1.5e6, kThickness = 0.003, kR = 0.01;
  const SoftPatch patch = winkler_patch(kForce, kYoung, kThickness, kR, kR, kPadFriction);
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
  const SoftPatch patch = power_law_patch(8, 0.002, 1.0 / 3, kPadFriction);
  EXPECT_NEAR(patch.a, 0.004, 1e-15);
  const auto hertz = [](double rho) { return std::sqrt(1 - rho * rho); };
  EXPECT_NEAR(patch.torsion, torsion_by_integration(patch.a, hertz), 1e-9);
}

TEST(SoftFinger, HoldsNothingWithoutLoadOrFriction) {
  EXPECT_EQ(winkler_patch(0, 1e6, 0.003, 0.01, 0.02, kPadFriction).torsion, 0);
  EXPECT_EQ(winkler_patch(5, 1e6, 0.003, 0.01, 0.02, 0).torsion, 0);
}

TEST(SoftFinger, RejectsImpossibleLayers) {
  EXPECT_THROW((void)winkler_patch(1, 0, 0.003, 0.01, 0.01, 1), InputError);
  EXPECT_THROW((void)power_law_patch(1, 0.002, 0.5, 1), InputError);
  EXPECT_THROW((void)hertz_patch(1, 0, 0.01, 1), InputError);
  EXPECT_THROW((void)contact_modulus(1e6, 0.6, 1e6, 0.3), InputError);
  EXPECT_THROW((void)confined_modulus(1e6, 0.5), InputError);
  EXPECT_THROW((void)patch_torsion(-1, 1, PatchPressure::kHertz, 1), InputError);
}

}  // namespace
}  // namespace thenar
