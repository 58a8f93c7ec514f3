#pragma once

/// Forces of one compliant contact: normal, tangential, and how fast it creeps.

#include <Eigen/Core>

#include "dynamics/stepping/contact_compliance.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// A normal force, and what its spring has stored.
struct NormalLoad {
  double force = 0;   // >= 0 [N]; of joint limits [N m] or [N]
  double energy = 0;  // [J]
};

/// k d (1 + c d'), never below zero; nothing at d <= 0. Source: [HuntCrossley1975].
/// @param stiffness    k [N/m];  @param dissipation  c [s/m]
/// @param depth        d [m];    @param rate         d' [m/s]
[[nodiscard]] NormalLoad linear_load(double stiffness, double dissipation, double depth,
                                     double rate);

/// (4/3) E sqrt(R) d^1.5 (1 + 1.5 c d'), never below zero; nothing at d <= 0.
/// @param modulus  effective, E [Pa];  @param radius  relative, R [m];  else as linear_load()
/// Source: [Johnson1985] section 4.2, [HuntCrossley1975].
[[nodiscard]] NormalLoad hertz_load(double modulus, double radius, double dissipation, double depth,
                                    double rate);

/// Share of the largest friction, 0..1. @param s  slip speed over the transition, >= 0 [1]
[[nodiscard]] double friction_share(FrictionRamp ramp, double s);

/// The other way round: speed at which a contact creeps that has to carry a share of its largest
/// friction, over the transition [1]. @param share  0..1
[[nodiscard]] double creep_speed(FrictionRamp ramp, double share);

/// Friction of one contact.
struct TangentialLoad {
  Eigen::Vector3d force{0, 0, 0};  // on what slips [N] (3)
  double torsion = 0;              // about the normal [N m]
};

/// Against the slip (u, e w) as a whole, of size  mu f_n share(|(u, e w)| / transition): Coulomb's
/// law, and the ellipsoid of soft fingers where e > 0 (docs/theory/contact_dynamics.md).
/// @param normal_force  f_n [N];  @param slip  u, across the normal [m/s] (3)
/// @param spin          w, about the normal [rad/s]
[[nodiscard]] TangentialLoad friction_load(const ContactCompliance& compliance,
                                           const PairFriction& pair, double normal_force,
                                           const Eigen::Vector3d& slip, double spin);

/// @throws InputError if a stiffness or dissipation is negative or not finite, or a length, speed
/// or stiffness that must be above zero is not.
void check_compliance(const ContactCompliance& compliance);

}  // namespace thenar
