#pragma once

/// Contact patch and torsional friction of an elastic contact.

#include <Eigen/Core>

namespace thenar {

/// Elliptical contact patch under a normal force.
struct SoftPatch {
  double a = 0;        // first semi-axis [m]
  double b = 0;        // second semi-axis [m]
  double depth = 0;    // approach of the two bodies [m]
  double torsion = 0;  // largest torque per normal force: Contact::torsion [m]
};

/// Pressure distribution over an elliptical patch, s = 0..1 from its centre to its rim.
enum class PatchPressure {
  kUniform,    // p: a soft skin over fluid
  kHertz,      // p sqrt(1 - s^2): elastic half spaces [Johnson1985]
  kParaboloid  // p (1 - s^2): a layer of springs
};

/// Returns the torsional friction of an elliptical patch, the torque about its normal per normal
/// force [m],
///   mu int p r dA / int p dA = c mu r_m,   c = 2/3 uniform, 3 pi/16 Hertz, 8/15 paraboloid,
/// r_m = mean_radius(a, b). Exact; docs/theory/grasp_contact.md derives it.
/// @param a, b  semi-axes [m];  @param friction  [1]
/// @throws InputError unless all are finite and >= 0.
[[nodiscard]] double patch_torsion(double a, double b, PatchPressure pressure, double friction);

/// Returns the mean radius of an ellipse, perimeter / (2 pi) [m]:  (2 / pi) a E(e),  e^2 = 1 - b^2
/// / a^2,  b <= a, with the complete elliptic integral of the second kind E.
/// @throws InputError as patch_torsion().
[[nodiscard]] double mean_radius(double a, double b);

/// Returns the patch of a Winkler layer (independent springs) of Young's modulus E and thickness h,
/// pressed by a body of relative radii R1, R2:  depth = sqrt(N h / (E pi sqrt(R1 R2))),  a = sqrt(2
/// depth R1), b = sqrt(2 depth R2);  its pressure is a paraboloid. [GraspItSoftContact] takes
/// sqrt(a b) for the mean radius. This is exact for a = b only and too small otherwise: by 8 % at a
/// / b = 2, 19 % at 3, 33 % at 5.
/// @param force  N [N];  @param young  [Pa];  @param thickness, R1, R2  [m];  @param friction  [1]
/// @throws InputError unless force and friction are >= 0 and the others positive, all finite.
/// Source: [GraspItSoftContact] for the patch, patch_torsion() for the torque.
[[nodiscard]] SoftPatch winkler_patch(double force, double young, double thickness, double R1,
                                      double R2, double friction);

/// Returns the patch of a Hertz contact of two linearly elastic balls:  a = (3 N R / (4 E*))^(1/3),
/// depth = a^2 / R.
/// @param modulus  E*, contact_modulus() [Pa];  @param radius  R relative, 1/R = 1/R1 + 1/R2 [m]
/// @throws InputError unless force and friction are >= 0 and the others positive, all finite.
/// Source: [Johnson1985], section 4.2.
[[nodiscard]] SoftPatch hertz_patch(double force, double modulus, double radius, double friction);

/// Returns the contact modulus E* of two elastic bodies:  1/E* = (1 - nu_a^2) / E_a + (1 - nu_b^2)
/// / E_b  [Pa].
/// @param E_a, E_b  Young's moduli; infinite: rigid [Pa];  @param nu_a, nu_b  Poisson's ratios
/// @throws InputError unless the moduli are positive, one finite, and the ratios in [0, 1/2].
/// Source: [Johnson1985], section 4.2.
[[nodiscard]] double contact_modulus(double E_a, double nu_a, double E_b, double nu_b);

/// Returns the modulus of a thin layer that cannot expand sideways,
/// E (1 - nu) / ((1 + nu) (1 - 2 nu))  [Pa]: the `young` of winkler_patch() for a layer bonded to
/// bone and much thinner than the width of the patch. It diverges as nu tends to 1/2: springs do
/// not describe an incompressible layer.
/// @param young  [Pa];  @param nu  Poisson's ratio, in [0, 1/2)
/// @throws InputError unless young is positive and finite, and nu in [0, 1/2).
/// Source: [Johnson1985], section 5.8.
[[nodiscard]] double confined_modulus(double young, double nu);

/// Returns the circular patch  a = c F^gamma,  gamma 0 to 1/3, with Hertz pressure: torsion 3 pi/16
/// mu a.
/// @param c  radius at 1 N [m];  @param gamma  1/3 for linear elasticity [1]
/// @throws InputError unless force, friction and c are >= 0 and gamma in [0, 1/3].
/// Source: [XydasKao1999] for the law of the radius, [Johnson1985] for the pressure.
[[nodiscard]] SoftPatch power_law_patch(double force, double c, double gamma, double friction);

/// Moments of parallel forces.
struct PressureMoments {
  double force = 0;                 // sum of the forces [N]
  Eigen::Vector3d centre{0, 0, 0};  // centre of the forces [m] (3)
  double arm = 0;     // mean distance from the centre, perpendicular to the forces [m]
  double aspect = 1;  // root of the ratio of the principal second moments, >= 1; 1 also for
                      // forces on a line or at a point [1]
};

/// Computes the moments of forces along a normal.
/// @param points  points of action [m] (3, n);  @param forces  >= 0 [N] (n)
/// @param normal  direction of the forces, unit (3)
[[nodiscard]] PressureMoments pressure_moments(const Eigen::Matrix3Xd& points,
                                               const Eigen::VectorXd& forces,
                                               const Eigen::Vector3d& normal);

}  // namespace thenar
