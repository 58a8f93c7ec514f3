#include "tendons/wrapping/wrap_arc.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/units.h"
#include "tendons/wrapping/planar_wrap.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Computes the signed area of the parallelogram of a and b.
double signed_area(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Plane through o, with unit vectors x towards the side and y across it.
struct PlaneSection {
  Vector3d o, x, y;
  [[nodiscard]] Vector2d flat(const Vector3d& p) const { return {x.dot(p - o), y.dot(p - o)}; }
  [[nodiscard]] Vector3d at(const Vector2d& p) const { return o + p.x() * x + p.y() * y; }
};

/// Computes the point of the surface's core (the centre, or the axis of a capsule) nearest to a
/// plane.
Vector3d core_near(const BoneSurface& surface, const Vector3d& in_plane, const Vector3d& normal) {
  if (surface.shape != SurfaceShape::kCapsule || std::abs(normal.z()) < 1e-9)
    return Vector3d(0, 0,
                    surface.shape == SurfaceShape::kCapsule
                        ? std::clamp(in_plane.z(), -surface.size[1], surface.size[1])
                        : 0);
  const double z = in_plane.dot(normal) / normal.z();
  return {0, 0, std::clamp(z, -surface.size[1], surface.size[1])};
}

/// Computes the plane of a, b and `third`, centred on the surface's section with it; nothing if
/// those points are collinear or the plane misses the surface.
std::optional<PlaneSection> section_through(const BoneSurface& surface, const Vector3d& a,
                                            const Vector3d& b, const Vector3d& third,
                                            const Vector3d& side) {
  // Compute the normal of the plane; none if the three points are collinear.
  const Vector3d m = (b - a).cross(third - a);
  if (m.norm() <= 1e-9 * (b - a).norm() * (third - a).norm()) return std::nullopt;
  // Centre the section on the core's point nearest to the plane.
  const Vector3d normal = m.normalized(), core = core_near(surface, third, normal);
  const Vector3d o = core - normal * normal.dot(core - a);
  if (level(surface, o) >= 0) return std::nullopt;
  // Set the axes of the section: towards the side, and across.
  const Vector3d up = side - o, x = up - normal * normal.dot(up);
  if (x.norm() <= 1e-9 * up.norm()) return std::nullopt;
  return PlaneSection{o, x.normalized(), normal.cross(x.normalized())};
}

/// Minimum of the level function on a straight run, found by sampling and ternary search.
struct Deepest {
  double level;
  Vector3d p;
};
Deepest deepest(const BoneSurface& surface, const Vector3d& a, const Vector3d& b, int samples) {
  const auto at = [&](double along) { return Vector3d(a + along * (b - a)); };
  int least = 0;
  for (int i = 1; i <= samples; ++i)
    if (level(surface, at(double(i) / samples)) < level(surface, at(double(least) / samples)))
      least = i;
  double low = std::max(least - 1, 0) / double(samples);
  double high = std::min(least + 1, samples) / double(samples);
  for (int i = 0; i < 80; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (level(surface, at(left)) < level(surface, at(right)))
      high = right;
    else
      low = left;
  }
  const Vector3d p = at(0.5 * (low + high));
  return {level(surface, p), p};
}

/// Returns the scales of the axes that turn an ellipsoid into a unit sphere, or a cylinder into a
/// circle across its axis [1/m] or [1].
Vector3d rounding_scale(const BoneSurface& surface) {
  if (surface.shape == SurfaceShape::kEllipsoid) return surface.size.cwiseInverse();
  return {1, 1, surface.shape == SurfaceShape::kCylinder ? 0.0 : 1.0};
}

/// Computes the point where the ray from the centre of the section leaves the surface.
Vector2d section_edge(const BoneSurface& surface, const PlaneSection& section,
                      const Vector2d& direction) {
  if (surface.shape == SurfaceShape::kEllipsoid) {  // |u + s d| = 1, all over the semi-axes
    const Vector3d u = section.o.cwiseQuotient(surface.size);
    const Vector3d d = (section.at(direction) - section.o).cwiseQuotient(surface.size);
    const double half = u.dot(d), d2 = d.squaredNorm();
    return (std::sqrt(half * half + d2 * (1 - u.squaredNorm())) - half) / d2 * direction;
  }
  double inside = 0, outside = 2 * surface.size.sum();
  for (int i = 0; i < 30; ++i) {
    const double half = 0.5 * (inside + outside);
    (level(surface, section.at(half * direction)) < 0 ? inside : outside) = half;
  }
  return outside * direction;
}

/// Taut string over a convex section, from samples of its edge. @param way  sense in which it
/// passes
struct FlatArc {
  Vector2d start, towards;
  double length;
};
FlatArc taut_arc(const BoneSurface& surface, const PlaneSection& section, const Vector2d& a,
                 const Vector2d& b, double way) {
  // Sample the section's edge, from the side onwards in the sense `way`.
  constexpr int kArcSamples = 64;
  std::array<Vector2d, kArcSamples> rim;
  for (int i = 0; i < kArcSamples; ++i) {
    const double angle = 2 * kPi * i / kArcSamples;
    rim[i] = section_edge(surface, section, {std::cos(angle), way * std::sin(angle)});
  }
  // Find the tangent points from a and from b: the whole rim lies on one side of each tangent.
  std::size_t on = 0, off = 0;
  for (std::size_t i = 1; i < kArcSamples; ++i) {
    if (way * signed_area(rim[on] - a, rim[i] - a) < 0) on = i;
    if (way * signed_area(rim[off] - b, rim[i] - b) > 0) off = i;
  }
  // Sum the length of the polygon between the two touch points.
  double length = 0;
  const std::size_t steps = (off + kArcSamples - on) % kArcSamples;
  if (steps > 3 * kArcSamples / 4) return {rim[on], b - a, 0};  // touches between two samples
  for (std::size_t i = on; i != off; i = (i + 1) % kArcSamples)
    length += (rim[(i + 1) % kArcSamples] - rim[i]).norm();
  return {rim[on], rim[on] - a, length};
}

/// Computes the taut string over a capsule or ellipsoid in a plane section.
std::optional<WrapArc> over_convex(const BoneSurface& surface, const Vector3d& a, const Vector3d& b,
                                   const Vector3d& side) {
  // Choose the plane through the side; failing that, through the centre.
  auto section = section_through(surface, a, b, side, side);
  if (!section) section = section_through(surface, a, b, Vector3d::Zero(), side);
  const bool clear = min_level(surface, a, b) >= 0;
  if (!section) return std::nullopt;
  // Test whether the straight line passes on the wrong side, or through the surface.
  const Vector2d flat_a = section->flat(a), flat_b = section->flat(b);
  const bool parted = (flat_a.y() > 0) != (flat_b.y() > 0);
  const bool barred =
      parted && (flat_a.x() * flat_b.y() - flat_b.x() * flat_a.y()) * (flat_b.y() - flat_a.y()) < 0;
  if (clear && !barred) return std::nullopt;
  // Compute the taut string over the section and project it onto the surface.
  const double way = (parted ? flat_b.y() > 0 : signed_area(flat_a, flat_b) > 0) ? 1 : -1;
  const FlatArc flat = taut_arc(surface, *section, flat_a, flat_b, way);
  const Vector3d start = section->at(flat.start);
  return WrapArc{
      project_to_surface(surface, {start, section->at(flat.start + flat.towards) - start}),
      flat.length};
}

/// Computes the arc over a capsule where the string touches its cylindrical part only.
std::optional<WrapArc> over_middle(const BoneSurface& capsule, const Vector3d& a, const Vector3d& b,
                                   const Vector3d& side) {
  // Wrap the cylinder; the result holds if it stays between the caps.
  BoneSurface cylinder = capsule;
  cylinder.shape = SurfaceShape::kCylinder;
  const auto wrap = wrap_round(cylinder, a, b, side);
  if (!wrap) return std::nullopt;
  const double reach = std::max(std::abs(wrap->arc.start.p.z()), std::abs(wrap->end.z()));
  return reach <= capsule.size[1] ? std::optional<WrapArc>(wrap->arc) : std::nullopt;
}

/// Computes the arc over the inside of a torus, in the half plane of the axis in which the straight
/// line crosses the plane of the ring.
std::optional<WrapArc> through_ring(const BoneSurface& surface, const Vector3d& a,
                                    const Vector3d& b, const Vector3d& side) {
  // Find the half plane in which the straight line crosses the plane of the ring.
  const double tube = surface.size[0], ring = surface.size[1];
  const bool crosses = (a.z() > 0) != (b.z() > 0);
  const Vector3d at = crosses ? Vector3d(a + (b - a) * (a.z() / (a.z() - b.z()))) : side;
  const double off = at.head<2>().norm();
  const Vector3d out =
      off > 1e-9 * ring ? Vector3d(at.x() / off, at.y() / off, 0) : Vector3d(Vector3d::UnitX());
  const Vector3d round = Vector3d::UnitZ().cross(out);
  // Wrap the circle of the tube in this half plane.
  const Vector2d flat_a(out.dot(a) - ring, a.z()), flat_b(out.dot(b) - ring, b.z());
  const auto flat = wrap_circle(tube, flat_a, flat_b, {-1, 0});
  const Deepest low = deepest(surface, a, b, 32);
  if (low.level >= 0 && (!crosses || off < ring)) return std::nullopt;
  if (!flat) return WrapArc{project_to_surface(surface, {low.p, b - a}), 0};
  // Distribute the motion round the axis evenly along the string.
  const double way = flat->free_a + tube * flat->angle + flat->free_b;
  const double from = round.dot(a), to = round.dot(b), share = flat->free_a / way;
  const Vector2d run = (flat->touch_a - flat_a).normalized();
  const double near = out.dot(at) > 0 ? ring - tube : ring;
  const double turn = (from + (to - from) * share) / near;
  const Vector3d here = std::cos(turn) * out + std::sin(turn) * round;
  const SurfaceRay start{
      (ring + flat->touch_a.x()) * here + Vector3d(0, 0, flat->touch_a.y()),
      run.x() * here + Vector3d(0, 0, run.y()) + (to - from) / way * Vector3d::UnitZ().cross(here)};
  return WrapArc{project_to_surface(surface, start), tube * flat->angle};
}

}  // namespace

double min_level(const BoneSurface& surface, const Vector3d& a_S, const Vector3d& b_S) {
  if (surface.shape == SurfaceShape::kTorus) return deepest(surface, a_S, b_S, 32).level;
  if (surface.shape == SurfaceShape::kCapsule) return deepest(surface, a_S, b_S, 2).level;
  // Scale the surface to a unit sphere or cylinder, and find the nearest point of the line.
  const Vector3d scale = rounding_scale(surface), u = scale.cwiseProduct(a_S);
  const Vector3d d = scale.cwiseProduct(b_S) - u;
  const double along = std::clamp(-u.dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return level(surface, a_S + along * (b_S - a_S));
}

std::optional<WrapArc> initial_arc(const BoneSurface& surface, const Vector3d& a_S,
                                   const Vector3d& b_S, const Vector3d& side_S) {
  if (surface.shape == SurfaceShape::kTorus) return through_ring(surface, a_S, b_S, side_S);
  if (surface.shape == SurfaceShape::kCapsule)
    if (auto arc = over_middle(surface, a_S, b_S, side_S)) return arc;
  return over_convex(surface, a_S, b_S, side_S);
}

namespace {

/// Computes the string over a cylinder. Unrolled, it is a straight line: z grows in proportion to
/// the length run across the axis.
std::optional<RoundArc> over_cylinder(double r, const Vector3d& a, const Vector3d& b,
                                      const Vector3d& side) {
  // Wrap the circle in the plane across the axis.
  const auto flat = wrap_circle(r, a.head<2>(), b.head<2>(), side.head<2>());
  if (!flat) return std::nullopt;
  // Distribute the climb evenly over the unrolled length.
  const double way = flat->free_a + r * flat->angle + flat->free_b, climb = b.z() - a.z();
  const double length = std::sqrt(way * way + climb * climb),
               z = a.z() + climb * flat->free_a / way;
  // Compute the direction at the start and the height of the end.
  const Vector2d round = flat->sense / r * Vector2d(-flat->touch_a.y(), flat->touch_a.x());
  const Vector3d t(way / length * round.x(), way / length * round.y(), climb / length);
  const double end_z = b.z() - climb * flat->free_b / way;
  return RoundArc{{{{flat->touch_a.x(), flat->touch_a.y(), z}, t}, r * flat->angle * length / way},
                  {flat->touch_b.x(), flat->touch_b.y(), end_z}};
}

/// Computes the normal of the plane of a, b and the centre; if they are collinear, of the plane
/// that contains `side`.
Vector3d plane_normal(const Vector3d& a, const Vector3d& b, const Vector3d& side) {
  const Vector3d m = a.cross(b);
  if (m.norm() > 1e-14 * a.norm() * b.norm()) return m.normalized();
  const Vector3d held = a.cross(side);
  if (held.norm() > 1e-14 * a.norm() * side.norm()) return held.normalized();
  return a.unitOrthogonal();
}

/// Computes the string over a sphere, the shorter arc of a great circle.
std::optional<RoundArc> over_sphere(double r, const Vector3d& a, const Vector3d& b,
                                    const Vector3d& side) {
  const double rho_a = a.norm(), rho_b = b.norm();
  if (rho_a == 0 || rho_b == 0) return std::nullopt;
  // Set the axes of the plane: towards a, and across.
  const Vector3d m = plane_normal(a, b, side), x = a / rho_a, y = m.cross(x);
  const Vector2d flat_a(rho_a, 0), flat_b(b.dot(x), std::abs(b.dot(y)));
  // Use the bisector of a and b as side, in a form valid for a quarter and for half a turn.
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
