#pragma once

/// How much torque about its normal a soft contact holds.

namespace thenar {

/// An elliptical patch of contact under a normal force.
struct SoftPatch {
  double a = 0;        // semi-axes [m]
  double b = 0;        // [m]
  double depth = 0;    // of approach of the two bodies [m]
  double torsion = 0;  // most torque per normal force: Contact::torsion [m]
};

/// A layer of independent springs (Winkler) of Young's modulus E and thickness h pressed by a body
/// of relative radii R1, R2:  depth = sqrt(N h / (E pi sqrt(R1 R2))),  a = sqrt(2 depth R1),
/// b = sqrt(2 depth R2);  its pressure is a paraboloid, whose torsion is  8/15 mu sqrt(a b):
/// mu int p r dA / N,  exact for a = b.
/// @param force  [N];  @param young  [Pa];  @param thickness, R1, R2  [m];  @param friction  [1]
/// @throws InputError unless force and friction are >= 0 and the others positive, all finite.
/// Source: [GraspItSoftContact].
[[nodiscard]] SoftPatch winkler_patch(double force, double young, double thickness, double R1,
                                      double R2, double friction);

/// A circle  a = c F^gamma,  gamma 0 to 1/3, under the pressure of Hertz: torsion 3 pi/16 mu a.
/// @param c  radius at 1 N [m];  @param gamma  1/3 for linear elasticity [1]
/// @throws InputError unless force, friction and c are >= 0 and gamma in [0, 1/3].
/// Source: [XydasKao1999] for the law of the radius, [Johnson1985] for the pressure.
[[nodiscard]] SoftPatch power_law_patch(double force, double c, double gamma, double friction);

}  // namespace thenar
