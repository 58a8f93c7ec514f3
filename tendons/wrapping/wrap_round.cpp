#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "tendons/wrapping/flat_wrap.h"
#include "tendons/wrapping/wrap_arc.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Unrolled, the string is a straight line: z grows in step with the way run across the axis.
std::optional<RoundArc> over_cylinder(double r, const Vector3d& a, const Vector3d& b,
                                      const Vector3d& side) {
  const auto flat = wrap_circle(r, a.head<2>(), b.head<2>(), side.head<2>());
  if (!flat) return std::nullopt;
  const double way = flat->free_a + r * flat->angle + flat->free_b, climb = b.z() - a.z();
  const double length = std::sqrt(way * way + climb * climb),
               z = a.z() + climb * flat->free_a / way;
  const Vector2d round = flat->way / r * Vector2d(-flat->touch_a.y(), flat->touch_a.x());
  const Vector3d t(way / length * round.x(), way / length * round.y(), climb / length);
  const double end_z = b.z() - climb * flat->free_b / way;
  return RoundArc{{{{flat->touch_a.x(), flat->touch_a.y(), z}, t}, r * flat->angle * length / way},
                  {flat->touch_b.x(), flat->touch_b.y(), end_z}};
}

/// Normal of the plane of a, b and the centre; if they are in line, of the one that holds `side`.
Vector3d plane_normal(const Vector3d& a, const Vector3d& b, const Vector3d& side) {
  const Vector3d m = a.cross(b);
  if (m.norm() > 1e-14 * a.norm() * b.norm()) return m.normalized();
  const Vector3d held = a.cross(side);
  if (held.norm() > 1e-14 * a.norm() * side.norm()) return held.normalized();
  return a.unitOrthogonal();
}

/// A great circle, the shorter way: in its plane the side is between a and b.
std::optional<RoundArc> over_sphere(double r, const Vector3d& a, const Vector3d& b,
                                    const Vector3d& side) {
  const double rho_a = a.norm(), rho_b = b.norm();
  if (rho_a == 0 || rho_b == 0) return std::nullopt;
  const Vector3d m = plane_normal(a, b, side), x = a / rho_a, y = m.cross(x);
  const Vector2d flat_a(rho_a, 0), flat_b(b.dot(x), std::abs(b.dot(y)));
  // The bisector of a and b, in a form that holds for a quarter and for half a turn.
  const double c = flat_b.x() / rho_b, f = flat_b.y() / rho_b;
  const Vector2d between(1 + c + f, 1 - c + f);
  const auto flat = wrap_circle(r, flat_a, flat_b, between);
  if (!flat) return std::nullopt;
  const Vector2d& touch = flat->touch_a;
  return RoundArc{
      {{touch.x() * x + touch.y() * y, (touch.x() * y - touch.y() * x) / r}, r * flat->angle},
      flat->touch_b.x() * x + flat->touch_b.y() * y};
}

}  // namespace

std::optional<RoundArc> wrap_round(const BoneSurface& surface, const Vector3d& a_S,
                                   const Vector3d& b_S, const Vector3d& side_S) {
  if (surface.shape == SurfaceShape::kCylinder)
    return over_cylinder(surface.size[0], a_S, b_S, side_S);
  require(surface.shape == SurfaceShape::kSphere, "surface '{}' is neither sphere nor cylinder",
          surface.name);
  return over_sphere(surface.size[0], a_S, b_S, side_S);
}

}  // namespace thenar
