#pragma once

/// Limit surface of a soft contact: tangential friction force and torsion that act together.

#include <Eigen/Core>

#include "pad_laws/soft_patch.h"

namespace thenar {

/// Friction force and torque of a patch in its own plane, per normal force.
struct PatchFriction {
  Eigen::Vector2d f{0, 0};  // along the semi-axes a, b [1] (2)
  double torque = 0;        // about the normal through its centre [m]
};

/// Share of the friction limit that a load uses:  sqrt(|f|^2 / mu^2 + torque^2 / torsion^2).  The
/// contact holds up to 1 and slips beyond 1; infinite where a load meets a coefficient of 0.
/// @param friction  mu [1];  @param torsion  of SoftPatch [m]
/// @throws InputError unless both are finite and >= 0.
/// Source: [Howe1996]; docs/theory/grasp_contact.md compares it with slip_friction().
[[nodiscard]] double limit_ellipsoid(const PatchFriction& load, double friction, double torsion);

/// Friction of a patch that slips by turning anticlockwise about a point of its plane:
///   f = mu int p v dA / N,  torque = mu int p (x x v) dA / N,   v = z x (x - centre), unit.
/// Points of the true limit surface; midpoint sums over 128 rings and 256 rays, to about 1e-4.
/// @param a, b  semi-axes [m];  @param friction  mu [1]
/// @param centre  of turning, from the patch's centre [m] (2)
/// @throws InputError unless a and b are positive, friction >= 0, all finite.
/// Source: [Goyal1991] for the limit surface.
[[nodiscard]] PatchFriction slip_friction(double a, double b, PatchPressure pressure,
                                          double friction, const Eigen::Vector2d& centre);

}  // namespace thenar
