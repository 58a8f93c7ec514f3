#pragma once

/// Exact limit surface of a soft contact: combined tangential friction force and torsion.

#include <Eigen/Core>

#include "pad_laws/soft_patch.h"

namespace thenar {

/// Friction force and torque of a patch in its own plane, per normal force.
struct PatchFriction {
  Eigen::Vector2d f{0, 0};  // along the semi-axes a, b [1] (2)
  double torque = 0;        // about the normal through its centre [m]
};

/// Returns the share of the friction limit that a load uses,  sqrt(|f|^2 / mu^2 + torque^2 /
/// torsion^2)  [1]. The contact sticks up to 1 and slips beyond 1; the share is infinite where a
/// load meets a coefficient of 0.
/// @param friction  mu [1];  @param torsion  SoftPatch::torsion [m]
/// @throws InputError unless both are finite and >= 0.
/// Source: [Howe1996]; docs/theory/grasp_contact.md compares it with slip_friction().
[[nodiscard]] double limit_ellipsoid(const PatchFriction& load, double friction, double torsion);

/// Returns the friction of a patch that slips by rotating anticlockwise about a point of its plane:
///   f = mu int p v dA / N,  torque = mu int p (x x v) dA / N,   v = z x (x - centre), unit.
/// These are points of the exact limit surface. Midpoint sums over 128 rings and 256 rays are
/// accurate to about 1e-4.
/// @param a, b  semi-axes [m];  @param friction  mu [1]
/// @param centre  centre of rotation, from the patch's centre [m] (2)
/// @throws InputError unless a and b are positive, friction >= 0, all finite.
/// Source: [Goyal1991] for the limit surface.
[[nodiscard]] PatchFriction slip_friction(double a, double b, PatchPressure pressure,
                                          double friction, const Eigen::Vector2d& centre);

}  // namespace thenar
