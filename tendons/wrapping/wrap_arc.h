#pragma once

/// Contact of a string between two points with one surface.

#include <optional>

#include "tendons/wrapping/geodesic.h"

namespace thenar {

/// Arc of a string on a surface, frame S.
struct WrapArc {
  SurfaceRay start;   // point and direction where it meets the surface
  double length = 0;  // length of the geodesic [m]
};

/// Arc on a sphere or cylinder, with its end.
struct RoundArc {
  WrapArc arc;
  Eigen::Vector3d end;  // point where it leaves the surface, frame S [m] (3)
};

/// Computes the arc of a string from a to b over a sphere or a cylinder, in closed form; nothing if
/// the string is straight.
///
/// On a cylinder the string stays on its side: seen along the axis it never crosses the half line
/// opposite to `side`, even if the other way is shorter. On a sphere, from which a string would
/// slip, it takes the shorter way, and `side` decides between ways of equal length.
/// A point inside the surface counts as lying on it.
[[nodiscard]] std::optional<RoundArc> wrap_round(const BoneSurface& surface,
                                                 const Eigen::Vector3d& a_S,
                                                 const Eigen::Vector3d& b_S,
                                                 const Eigen::Vector3d& side_S);

/// Computes the smallest level() on the straight run from a to b: negative where it passes through
/// the surface [m].
[[nodiscard]] double min_level(const BoneSurface& surface, const Eigen::Vector3d& a_S,
                               const Eigen::Vector3d& b_S);

/// Computes an initial guess for Newton's method on any other surface; nothing if the string is
/// straight.
///
/// Capsule and ellipsoid: the taut string in the plane of a, b and the point `side`, held on its
/// side as on a cylinder. Torus: the taut string through the hole, in the half plane of the axis in
/// which the straight line crosses the ring.
[[nodiscard]] std::optional<WrapArc> initial_arc(const BoneSurface& surface,
                                                 const Eigen::Vector3d& a_S,
                                                 const Eigen::Vector3d& b_S,
                                                 const Eigen::Vector3d& side_S);

}  // namespace thenar
