// Tests for pad_laws/point_laws.cpp and pad_laws/elastic_foundation.cpp: laws of one contact.

#include "pad_laws/point_laws.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "pad_laws/elastic_foundation.h"

namespace thenar {
namespace {

constexpr RelativeCurvatures kGap{150, 80};  // radii of 6.7 and 12.5 mm
constexpr double kFriction = 0.7;

PowerLawConstants some_power() { return {0.3, 1.9, 4e-3, 0.2, 0.6}; }
SoftFingerConstants some_finger() { return {0.3, 1.8, 0.4, 4e-3, 0.22, 0.3, 0.55, 0.6}; }
FoundationConstants some_foundation() { return {2e4, 0.8, 6, 0.7, 1.4, 5e-3, 0}; }

std::vector<std::shared_ptr<const ContactLaw>> soft_laws() {
  return {std::make_shared<PowerLaw>(some_power()), std::make_shared<SoftFinger>(some_finger()),
          std::make_shared<ElasticFoundation>(some_foundation())};
}

void expect_near(const LawContact& a, const LawContact& b, double tolerance) {
  EXPECT_NEAR(a.force, b.force, tolerance * b.force);
  EXPECT_NEAR(a.stiffness, b.stiffness, tolerance * b.stiffness);
  EXPECT_NEAR(a.area, b.area, tolerance * b.area);
  EXPECT_NEAR(a.patch.a, b.patch.a, tolerance * b.patch.a);
  EXPECT_NEAR(a.patch.b, b.patch.b, tolerance * b.patch.b);
  EXPECT_NEAR(a.patch.depth, b.patch.depth, tolerance * b.patch.depth);
  EXPECT_NEAR(a.patch.torsion, b.patch.torsion, tolerance * b.patch.torsion);
}

TEST(ContactLaws, DepthAndForceAreInverses) {
  for (const auto& law : soft_laws())
    for (const double depth : {1e-9, 1e-5, 1e-3, 4e-3}) {
      const LawContact there = law->at_depth(kGap, depth, kFriction);
      expect_near(law->at_force(kGap, there.force, kFriction), there, 1e-12);
    }
}

TEST(ContactLaws, StiffnessIsTheSlopeOfTheForce) {
  for (const auto& law : soft_laws()) {
    constexpr double kDepth = 1.3e-3, kStep = 1e-7;
    const double slope = (law->at_depth(kGap, kDepth + kStep, 0).force -
                          law->at_depth(kGap, kDepth - kStep, 0).force) /
                         (2 * kStep);
    EXPECT_NEAR(law->at_depth(kGap, kDepth, 0).stiffness / slope, 1, 1e-8);
  }
}

TEST(ContactLaws, NothingTouchesBelowDepthZero) {
  for (const auto& law : soft_laws())
    for (const double depth : {0.0, -1e-3}) {
      const LawContact apart = law->at_depth(kGap, depth, kFriction);
      EXPECT_EQ(apart.force, 0);
      EXPECT_EQ(apart.area, 0);
      EXPECT_EQ(apart.patch.torsion, 0);
      EXPECT_EQ(apart.patch.depth, depth);
    }
}

TEST(ContactLaws, WhatMakesNoSenseIsRefused) {
  std::vector<std::shared_ptr<const ContactLaw>> laws = soft_laws();
  laws.push_back(std::make_shared<HardPoint>());
  for (const auto& law : laws) {
    EXPECT_THROW((void)law->at_depth({kNaN, 1}, 1e-3, 0), InputError);
    EXPECT_THROW((void)law->at_depth({1, 2}, 1e-3, 0), InputError);
    EXPECT_THROW((void)law->at_depth(kGap, kNaN, 0), InputError);
    EXPECT_THROW((void)law->at_depth(kGap, 1e-3, -0.1), InputError);
    EXPECT_THROW((void)law->at_force(kGap, -1, 0), InputError);
    EXPECT_THROW((void)law->at_force(kGap, kInfinity, 0), InputError);
  }
}

TEST(HardPoint, BearsAnyForceWithoutDepthPatchOrTorsion) {
  const HardPoint law;
  const LawContact contact = law.at_force(kGap, 3, kFriction);
  EXPECT_EQ(contact.force, 3);
  EXPECT_EQ(contact.patch.depth, 0);
  EXPECT_EQ(contact.area, 0);
  EXPECT_EQ(contact.patch.torsion, 0);
  EXPECT_EQ(contact.stiffness, kInfinity);
  EXPECT_EQ(law.at_depth(kGap, 1e-9, 0).force, kInfinity);
  EXPECT_EQ(law.at_depth(kGap, -1e-9, 0).force, 0);
}

// Ladder: stiffness to infinity.
TEST(ContactLaws, AStiffPadIsAHardPoint) {
  const LawContact hard = HardPoint().at_force(kGap, 2, kFriction);
  FoundationConstants bed = some_foundation();
  SoftFingerConstants finger = some_finger();
  PowerLawConstants power = some_power();
  bed.modulus *= 1e16;
  finger.force *= 1e16;
  power.force *= 1e16;
  EXPECT_NEAR(PowerLaw(power).at_force(kGap, 2, kFriction).patch.depth, hard.patch.depth, 1e-10);
  EXPECT_NEAR(SoftFinger(finger).at_force(kGap, 2, kFriction).patch.depth, hard.patch.depth, 1e-10);
  const LawContact stiff = ElasticFoundation(bed).at_force(kGap, 2, kFriction);
  EXPECT_NEAR(stiff.patch.depth, hard.patch.depth, 1e-10);
  // Its patch goes with it: torsion like the root of depth.
  EXPECT_NEAR(stiff.patch.torsion, hard.patch.torsion, 1e-6);
  EXPECT_NEAR(stiff.area, hard.area, 1e-10);
}

// Ladder: radius to zero.
TEST(ContactLaws, ASmallPatchIsAPoint) {
  SoftFingerConstants finger = some_finger();
  finger.patch = 0;
  const LawContact point = SoftFinger(finger).at_force(kGap, 2, kFriction);
  EXPECT_EQ(point.patch.torsion, 0);
  EXPECT_EQ(point.area, 0);
  EXPECT_EQ(point.force, 2);
  // A bed below a sharp tip.
  const LawContact tip = ElasticFoundation(some_foundation()).at_depth({1e9, 1e9}, 1e-3, kFriction);
  EXPECT_LT(tip.patch.torsion, 1e-5);
  EXPECT_LT(tip.area, 1e-11);
}

TEST(SoftFinger, WithHertzsExponentsIsHertzsContact) {
  constexpr double kModulus = 3e4;  // E*
  SoftFingerConstants c;
  c.force = 4.0 / 3 * kModulus * std::sqrt(kLawRadius) * std::pow(kLawDepth, 1.5);
  c.depth_exponent = 1.5;
  c.radius_exponent = 0.5;
  c.patch = std::cbrt(3 * kLawRadius / (4 * kModulus));
  c.patch_exponent = c.patch_radius = 1.0 / 3;
  c.torsion = 3 * kPi / 16;
  for (const double radius : {4e-3, 10e-3, 30e-3}) {
    const SoftPatch exact = hertz_patch(0.6, kModulus, radius, kFriction);
    const SoftPatch ours = SoftFinger(c).at_force({1 / radius, 1 / radius}, 0.6, kFriction).patch;
    EXPECT_NEAR(ours.depth, exact.depth, 1e-13);
    EXPECT_NEAR(ours.a, exact.a, 1e-13);
    EXPECT_NEAR(ours.torsion, exact.torsion, 1e-13);
  }
}

TEST(SoftFinger, WithExponentsOfALayerIsWinklersPatch) {
  constexpr double kYoung = 25e3, kThickness = 3e-3;
  SoftFingerConstants c;
  c.force = kYoung * kPi * kLawRadius * kLawDepth * kLawDepth / kThickness;
  c.depth_exponent = 2;
  c.radius_exponent = 1;
  c.patch = std::sqrt(2 * kLawRadius) * std::pow(kThickness / (kYoung * kPi * kLawRadius), 0.25);
  c.patch_exponent = c.patch_radius = 0.25;
  c.aspect = 0.5;
  c.torsion = 8.0 / 15;
  const SoftPatch exact =
      winkler_patch(1.3, kYoung, kThickness, 1 / kGap.k1, 1 / kGap.k2, kFriction);
  const SoftPatch ours = SoftFinger(c).at_force(kGap, 1.3, kFriction).patch;
  EXPECT_NEAR(ours.depth, exact.depth, 1e-12);
  EXPECT_NEAR(ours.a, exact.b, 1e-12);  // ours has the longer axis first
  EXPECT_NEAR(ours.b, exact.a, 1e-12);
  EXPECT_NEAR(ours.torsion, exact.torsion, 1e-12);
}

TEST(PowerLaw, GammaIsBetweenZeroAndAThird) {
  PowerLawConstants c = some_power();
  c.patch_exponent = 1.0 / 3;
  EXPECT_NO_THROW(PowerLaw{c});
  c.patch_exponent = 0.34;
  EXPECT_THROW(PowerLaw{c}, InputError);
  c.patch_exponent = -0.01;
  EXPECT_THROW(PowerLaw{c}, InputError);
}

TEST(PowerLaw, RadiusIsThatOfItsPublication) {
  const SoftPatch exact = power_law_patch(2.5, 4e-3, 0.2, kFriction);
  PowerLawConstants c = some_power();
  c.torsion = 3 * kPi / 16;  // Hertz's pressure
  const SoftPatch ours = PowerLaw(c).at_force(kGap, 2.5, kFriction).patch;
  EXPECT_NEAR(ours.a, exact.a, 1e-15);
  EXPECT_NEAR(ours.torsion, exact.torsion, 1e-15);
}

TEST(ElasticFoundation, PlainAndLinearIsWinklersPatch) {
  constexpr double kYoung = 25e3, kThickness = 3e-3;
  const SoftPatch exact =
      winkler_patch(1.3, kYoung, kThickness, 1 / kGap.k2, 1 / kGap.k1, kFriction);
  const LawContact ours =
      ElasticFoundation({kYoung, 1, 0, 0, 1, kThickness, 0}).at_force(kGap, 1.3, kFriction);
  EXPECT_NEAR(ours.patch.depth, exact.depth, 1e-12);
  EXPECT_NEAR(ours.patch.a, exact.a, 1e-12);
  EXPECT_NEAR(ours.patch.b, exact.b, 1e-12);
  EXPECT_NEAR(ours.patch.torsion, exact.torsion, 1e-12);
}

// A spring of power 1/2 under a patch of Hertz's size has Hertz's pressure,  p0 sqrt(1 - s^2)  with
// p0 = 3 F / (2 pi a^2).
TEST(ElasticFoundation, WithARootAndASpreadOfTwoIsHertzsContactForItsRadius) {
  constexpr double kModulus = 3e4, kRadius = 8e-3, kThickness = 5e-3, kDepth = 6e-4;
  const double force = 4.0 / 3 * kModulus * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
  const double middle = 1.5 * force / (kPi * kRadius * kDepth);
  const double E = middle / std::sqrt(kDepth / kThickness);
  const LawContact ours = ElasticFoundation({E, 0.5, 0, 0, 2, kThickness, 0})
                              .at_depth({1 / kRadius, 1 / kRadius}, kDepth, kFriction);
  const SoftPatch exact = hertz_patch(force, kModulus, kRadius, kFriction);
  EXPECT_NEAR(ours.force, force, 1e-13);
  EXPECT_NEAR(ours.stiffness, 1.5 * force / kDepth, 1e-9);
  EXPECT_NEAR(ours.patch.a, exact.a, 1e-13);
  EXPECT_NEAR(ours.patch.torsion, exact.torsion, 1e-13);
}

TEST(ElasticFoundation, ALayerThatIsThickBesideItsPatchHasHertzsPowers) {
  FoundationConstants c{20e3, 1, 0, 1e9, 2, kLawDepth, 0};
  const auto force = [&](double radius, double depth) {
    return ElasticFoundation(c).at_depth({1 / radius, 1 / radius}, depth, 0).force;
  };
  EXPECT_NEAR(force(8e-3, 2e-3) / force(8e-3, 1e-3), std::pow(2, 1.5), 1e-8);
  EXPECT_NEAR(force(8e-3, 1e-3) / force(2e-3, 1e-3), 2, 1e-8);
}

TEST(ElasticFoundation, TorsionIsTheMomentOfItsPressure) {
  const FoundationConstants c = some_foundation();
  constexpr double kDepth = 1.5e-3;
  // Sum over rings of a round patch.
  const RelativeCurvatures round{100, 100};
  const LawContact ours = ElasticFoundation(c).at_depth(round, kDepth, 1);
  double force = 0, moment = 0;
  constexpr int kRings = 200000;
  for (int i = 0; i < kRings; ++i) {
    const double r = ours.patch.a * (i + 0.5) / kRings;
    const double delta = kDepth - c.spread * r * r * 100 / 2;
    const double ring = 2 * kPi * r * ours.patch.a / kRings;
    const double p = spring_pressure(c, delta / c.thickness).pressure *
                     (1 + c.surround * c.thickness / ours.patch.a);
    force += p * ring;
    moment += p * r * ring;
  }
  EXPECT_NEAR(ours.force / force, 1, 1e-7);
  EXPECT_NEAR(ours.patch.torsion / (moment / force), 1, 1e-7);
}

TEST(ElasticFoundation, RefusesConstantsThatMakeNoSense) {
  const auto refused = [](auto change) {
    FoundationConstants c = some_foundation();
    change(c);
    EXPECT_THROW(ElasticFoundation{c}, InputError);
  };
  refused([](FoundationConstants& c) { c.modulus = 0; });
  refused([](FoundationConstants& c) { c.exponent = 0; });
  refused([](FoundationConstants& c) { c.stiffening = -1; });
  refused([](FoundationConstants& c) { c.surround = -1; });
  refused([](FoundationConstants& c) { c.spread = 0.9; });
  refused([](FoundationConstants& c) { c.thickness = kNaN; });
  refused([](FoundationConstants& c) { c.shear = -1; });
}

TEST(RelaxedContact, HeldDepthFollowsTheRelaxation) {
  const SoftFinger law(some_finger(), {{0.4, 0.05}, {0.2, 1}});
  ExponentialMemory memory;
  constexpr double kDepth = 1e-3;
  const double elastic = law.at_depth(kGap, kDepth, kFriction).force;
  (void)relaxed_contact(law, kGap, kDepth, kFriction, memory_step(law.relaxation(), 0), memory);
  LawContact held;
  for (const double h : {0.01, 0.07})
    held = relaxed_contact(law, kGap, kDepth, kFriction, memory_step(law.relaxation(), h), memory);
  EXPECT_NEAR(held.force, elastic * (0.4 + 0.4 * std::exp(-0.08 / 0.05) + 0.2 * std::exp(-0.08)),
              1e-14);
  // The patch is that of the depth.
  EXPECT_EQ(held.area, law.at_depth(kGap, kDepth, kFriction).area);
}

TEST(RelaxedContact, APadThatComesBackSlowlyTouchesAgainWhenItsCreepSays) {
  // Pressed until all has relaxed, then let go to a depth whose elastic force is a quarter of what
  // would part it. A free pad creeps back as  F = g F0 exp(-g_inf t / tau).
  constexpr double kShare = 0.6, kTime = 0.5;
  const SoftFinger law(some_finger(), {{kShare, kTime}});
  ExponentialMemory memory;
  const auto after = [&](double depth, double h) {
    return relaxed_contact(law, kGap, depth, 0, memory_step(law.relaxation(), h), memory);
  };
  const double F0 = after(1e-3, 0).force;
  EXPECT_NEAR(after(1e-3, kInfinity).force, (1 - kShare) * F0, 1e-12);
  const double less = law.at_force(kGap, kShare * F0 / 4, 0).patch.depth;
  const LawContact apart = after(less, 0);
  EXPECT_EQ(apart.force, 0);
  EXPECT_EQ(apart.area, 0);
  const double meets = kTime / (1 - kShare) * std::log(4.0);
  constexpr double kStep = 1e-3;
  double t = 0;
  while (after(less, kStep).force == 0 && t < 10) t += kStep;
  EXPECT_NEAR(t, meets, 2 * kStep);
}

}  // namespace
}  // namespace thenar
