#pragma once

/// Forces of soft tissue along one direction.

#include <limits>

namespace thenar {

/// Force, slope and energy of a law at a displacement.
struct LigamentForce {
  double force = 0;   // towards rest, the derivative of the energy [N] or [N m]
  double slope = 0;   // d force / d displacement, >= 0 [N/m] or [N m/rad]
  double energy = 0;  // [J]
};

/// A joint's capsule along one direction, the same both ways:
///   force = k s sinh(x / s)   while  k cosh(x / s) <= r k,
///   then straight on with the stiffness  r k.
/// Low stiffness in the toe region |x| < s, exponential beyond it, and straight where collagen is
/// stretched out. Force and slope are continuous. Without a toe: force = k x.
struct CapsuleLaw {
  double stiffness = 0;                                  // k, at rest [N/m] or [N m/rad]
  double toe = std::numeric_limits<double>::infinity();  // s [m] or [rad]
  double stiffening = 20;                                // r, largest stiffness over k, >= 1 [1]
  double damping = 0;                                    // [N s/m] or [N m s/rad]
};

/// @param x  [m] or [rad]
[[nodiscard]] LigamentForce capsule_force(const CapsuleLaw& law, double x);

/// @throws InputError if a number is not finite or impossible; a toe may be infinite.
void check_law(const CapsuleLaw& law);

/// A ligament along its line. With strain e = (L - L0) / L0:
///   force = K e^2 / (4 e_l)   0 <= e <= 2 e_l,
///   force = K (e - e_l)       beyond; none where it is slack.
/// Source: [Blankevoort1991] for the law.
struct LigamentLaw {
  double slack_length = 0;   // L0 [m]
  double stiffness = 0;      // K, force per strain of the straight part [N]
  double toe_strain = 0.03;  // e_l [1]
  double damping = 0;        // force grows by this times the rate of strain, and never pushes [s]
};

/// @param length  [m]
[[nodiscard]] LigamentForce ligament_force(const LigamentLaw& law, double length);

/// @throws InputError if a number is not finite or impossible.
void check_law(const LigamentLaw& law);

}  // namespace thenar
