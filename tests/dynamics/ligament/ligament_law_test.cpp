// Tests for dynamics/ligament/ligament_law.cpp.

#include "dynamics/ligament/ligament_law.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

constexpr CapsuleLaw kCapsule{2000, 1e-3, 10, 0};
constexpr LigamentLaw kLigament{0.02, 1500, 0.03, 0};

TEST(CapsuleForce, FollowsTheSinhUpToItsStraightPart) {
  // At one toe:  k s sinh(1).
  EXPECT_NEAR(capsule_force(kCapsule, 1e-3).force, 2 * std::sinh(1.0), 1e-12);
  EXPECT_NEAR(capsule_force(kCapsule, -1e-3).force, -2 * std::sinh(1.0), 1e-12);
  EXPECT_DOUBLE_EQ(capsule_force(kCapsule, 0).slope, 2000);
  // Straight from  s acosh(10)  on, at ten times the stiffness and  k s sqrt(99).
  const double end = 1e-3 * std::acosh(10.0);
  EXPECT_NEAR(capsule_force(kCapsule, end + 2e-3).force, 2 * std::sqrt(99.0) + 40, 1e-10);
  EXPECT_NEAR(capsule_force(kCapsule, 0.05).slope, 20000, 1e-8);
  EXPECT_DOUBLE_EQ(capsule_force({300}, 0.01).force, 3);
}

TEST(LigamentForce, IsThatOfItsSourceAndNeverPushes) {
  EXPECT_DOUBLE_EQ(ligament_force(kLigament, 0.0199).force, 0);
  // Strain 0.03 = e_l:  K e_l / 4; strain 0.06: K e_l; strain 0.1: K 0.07.
  EXPECT_NEAR(ligament_force(kLigament, 0.0206).force, 1500 * 0.03 / 4, 1e-10);
  EXPECT_NEAR(ligament_force(kLigament, 0.0212).force, 1500 * 0.03, 1e-10);
  EXPECT_NEAR(ligament_force(kLigament, 0.022).force, 1500 * 0.07, 1e-10);
}

// Central differences of the energy and of the force.
template <typename Law, typename Force>
void expect_gradients(const Law& law, const Force& force, double x, double scale) {
  SCOPED_TRACE(x);
  const double d = 1e-5 * scale;
  const LigamentForce at = force(law, x), up = force(law, x + d), down = force(law, x - d);
  EXPECT_NEAR((up.energy - down.energy) / (2 * d), at.force, 1e-8 * (1 + std::abs(at.force)));
  EXPECT_NEAR((up.force - down.force) / (2 * d), at.slope, 1e-7 * (1 + at.slope));
}

TEST(LigamentLaws, HaveForcesThatAreGradients) {
  for (const double x : {-8e-3, -2e-3, -3e-4, 0.0, 1e-6, 7e-4, 2.9e-3, 3.1e-3, 1e-2})
    expect_gradients(kCapsule, capsule_force, x, 1e-3);
  for (const double length : {0.018, 0.0201, 0.0208, 0.0211, 0.0213, 0.025})
    expect_gradients(kLigament, ligament_force, length, 0.001);
}

TEST(LigamentLaws, RefuseWhatIsImpossible) {
  EXPECT_THROW(check_law(CapsuleLaw{-1}), InputError);
  EXPECT_THROW(check_law(CapsuleLaw{1, 0}), InputError);
  EXPECT_THROW(check_law(CapsuleLaw{1, 1, 0.5}), InputError);
  EXPECT_THROW(check_law(LigamentLaw{0, 1}), InputError);
  EXPECT_THROW(check_law(LigamentLaw{1, std::nan("")}), InputError);
}

}  // namespace
}  // namespace thenar
