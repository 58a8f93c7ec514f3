#pragma once

/// Force laws of joint capsules and ligaments along one direction.

#include <limits>

namespace thenar {

/// Force, slope and energy of a law at a displacement.
struct LigamentForce {
  double force = 0;   // restoring force, the derivative of the energy [N] or [N m]
  double slope = 0;   // d force / d displacement, >= 0 [N/m] or [N m/rad]
  double energy = 0;  // stored energy [J]
};

/// Law of a joint capsule along one direction, odd in the displacement x:
///   force = k s sinh(x / s)   while  cosh(x / s) <= r,
///   then linear with the stiffness  r k.
/// The stiffness is low in the toe region |x| < s, grows exponentially beyond it, and is constant
/// where the collagen fibres are straight. Force and slope are continuous. With an infinite toe
/// region the law is linear: force = k x.
struct CapsuleLaw {
  double stiffness = 0;                                  // k, stiffness at rest [N/m] or [N m/rad]
  double toe = std::numeric_limits<double>::infinity();  // s, length of the toe region [m] or [rad]
  double stiffening = 20;                                // r, largest stiffness over k, >= 1 [1]
  double damping = 0;                                    // damping [N s/m] or [N m s/rad]
};

/// Returns force, slope and energy of a capsule law, without damping.
/// @param x  displacement from rest [m] or [rad]
[[nodiscard]] LigamentForce capsule_force(const CapsuleLaw& law, double x);

/// Checks the constants of a capsule law.
/// @throws InputError if a number is not finite or out of range; the toe region may be infinite.
void check_law(const CapsuleLaw& law);

/// Law of a ligament along its line. With the strain e = (L - L0) / L0:
///   force = K e^2 / (4 e_l)   for 0 <= e <= 2 e_l,
///   force = K (e - e_l)       beyond; zero where it is slack.
/// Source: [Blankevoort1991].
struct LigamentLaw {
  double slack_length = 0;   // L0, length at which it becomes taut [m]
  double stiffness = 0;      // K, force per strain of the linear part [N]
  double toe_strain = 0.03;  // e_l, strain offset of the linear part [1]
  double damping = 0;  // c, the force is multiplied by max(0, 1 + c times the strain rate) [s]
};

/// Returns force, slope and energy of a ligament law, without damping.
/// @param length  length of the ligament [m]
[[nodiscard]] LigamentForce ligament_force(const LigamentLaw& law, double length);

/// Checks the constants of a ligament law.
/// @throws InputError if a number is not finite or out of range.
void check_law(const LigamentLaw& law);

}  // namespace thenar
