#pragma once

/// Force laws of a compliant contact: normal force and friction.

#include <Eigen/Core>

#include "dynamics/stepping/contact_compliance.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Normal force of a contact or joint limit.
struct NormalLoad {
  double force = 0;   // normal force >= 0 [N]; effort of a joint limit [N m] or [N]
  double energy = 0;  // stored elastic energy [J]
};

/// Returns the linear normal force  max(0, k d (1 + c d')),  zero for d <= 0.
/// Source: [HuntCrossley1975].
/// @param stiffness    k [N/m];  @param dissipation  c [s/m]
/// @param depth        d [m];    @param rate         d' [m/s]
[[nodiscard]] NormalLoad linear_normal_load(double stiffness, double dissipation, double depth,
                                            double rate);

/// Returns the Hertzian normal force  max(0, (4/3) E sqrt(R) d^1.5 (1 + 1.5 c d')),  zero for
/// d <= 0. Source: [Johnson1985] section 4.2, [HuntCrossley1975].
/// @param modulus      effective modulus E [Pa];  @param radius  relative radius R [m]
/// @param dissipation  c [s/m];  @param depth  d [m];  @param rate  d' [m/s]
[[nodiscard]] NormalLoad hertz_normal_load(double modulus, double radius, double dissipation,
                                           double depth, double rate);

/// Returns the friction over its largest value, 0..1.
/// @param s  slip speed over the transition speed, >= 0 [1]
[[nodiscard]] double friction_ratio(FrictionRamp ramp, double s);

/// Friction of one contact.
struct TangentialLoad {
  Eigen::Vector3d force{0, 0, 0};  // force on the slipping body [N] (3)
  double torsion = 0;              // moment about the normal [N m]
};

/// Returns the regularized friction, opposite to the slip (u, e w) and of magnitude
///   mu f_n friction_ratio(|(u, e w)| / transition):
/// Coulomb's law, with the limit ellipsoid of soft fingers for a torsion radius e > 0
/// (docs/theory/contact_dynamics.md).
/// @param normal_force  f_n [N]
/// @param slip          u, tangential relative velocity [m/s] (3)
/// @param spin          w, relative angular velocity about the normal [rad/s]
[[nodiscard]] TangentialLoad friction_load(const ContactCompliance& compliance,
                                           const PairFriction& pair, double normal_force,
                                           const Eigen::Vector3d& slip, double spin);

/// Checks the constants of compliant contacts.
/// @throws InputError if modulus or dissipation is negative or not finite, or stiffness, layer,
/// transition speed or stop stiffness is not positive and finite.
void check_compliance(const ContactCompliance& compliance);

}  // namespace thenar
