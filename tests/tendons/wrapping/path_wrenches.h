#pragma once

/// Moment arms of wrapped tendons by a second method: the contact forces on the bones.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hand/statics.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar::sample {

/// Riding origin on its carrier.
struct RidingOrigin {
  const PathShape* carrier;
  const PathSpan* span;  // span of the carrier
  Eigen::Vector3d p;     // position of the origin
  Eigen::Vector3d u;     // unit direction of the rider's last run, into the origin
  Eigen::Vector3d v;     // unit direction along the carrier towards its origin
  double share;          // fraction of the span's length
};
inline RidingOrigin riding_origin(const PathSet& set, const std::vector<PathShape>& shapes,
                                  std::size_t path) {
  const PathShape& rider = shapes[path];
  RidingOrigin ride;
  ride.carrier = &shapes[set.paths[path].carrier];
  ride.span = &ride.carrier->spans[rider.ride_span];
  ride.p = rider.spans.back().b;
  ride.u = rider.spans.back().u;
  ride.v = ride.span->u;
  const double length = ride.span->length;
  ride.share = length > 0 ? (ride.p - ride.span->a).dot(ride.v) / length : 0;
  return ride;
}

/// Sum of wrenches by link.
class PathWrenches {
 public:
  void add(int link, const Eigen::Vector3d& at, const Eigen::Vector3d& f) {
    add(link, wrench_of_force(at, f));
  }
  void add(int link, const Wrench& wrench) {
    // Add to the link's sum, or start one.
    for (LinkWrench& sum : all)
      if (sum.link == link) {
        sum.wrench += wrench;
        return;
      }
    all.push_back({link, wrench});
  }
  std::vector<LinkWrench> all;
};

using Spatial = Eigen::Matrix<double, 6, 1>;

/// Integrates the pressure of an arc in frame S between two lengths along it, by five-point Gauss
/// quadrature.
inline Spatial pressure(const BoneSurface& surface, const WrapArc& arc, double from, double to) {
  static constexpr std::array<double, 3> kAt{0.0, 0.538469310105683091, 0.906179845938663993};
  static constexpr std::array<double, 3> kWeight{0.568888888888888889, 0.478628670499366468,
                                                 0.236926885056189088};
  // Sum over Gauss points: the force per length is tension times curvature.
  Spatial sum = Spatial::Zero();
  for (int i = -2; i <= 2; ++i) {
    const auto k = static_cast<std::size_t>(std::abs(i));
    const double s = 0.5 * (from + to) + 0.5 * (to - from) * (i < 0 ? -kAt[k] : kAt[k]);
    const SurfaceRay ray = follow_geodesic(surface, arc.start, s).ray;
    const SurfaceCurvature at = surface_curvature(surface, ray.p);
    const Eigen::Vector3d f = -ray.t.dot(at.S * ray.t) * at.n;
    sum.head<3>() += 0.5 * (to - from) * kWeight[k] * ray.p.cross(f);
    sum.tail<3>() += 0.5 * (to - from) * kWeight[k] * f;
  }
  return sum;
}

/// Integrates the pressure by halving the arc until the quadrature converges: it jumps at the seams
/// of a capsule.
// NOLINTNEXTLINE(misc-no-recursion): at most `depth` deep
inline Spatial whole_pressure(const BoneSurface& surface, const WrapArc& arc, double from,
                              double to, const Spatial& coarse, int depth) {
  // Compare two halves with the whole.
  const double half = 0.5 * (from + to);
  const Spatial left = pressure(surface, arc, from, half), right = pressure(surface, arc, half, to);
  const double change = (left + right - coarse).lpNorm<Eigen::Infinity>();
  if (change < 1e-15 || depth == 0) return left + right;
  return whole_pressure(surface, arc, from, half, left, depth - 1) +
         whole_pressure(surface, arc, half, to, right, depth - 1);
}

/// Adds the wrench of one arc under a tension.
inline void add_arc(const TreeState<double>& state, const PathSet& set, const PathArc& arc,
                    double tension, PathWrenches& wrenches) {
  // Integrate the pressure of the arc, in the frame of its surface.
  const BoneSurface& surface = set.surfaces[arc.surface];
  const double length = arc.arc.length;
  const Spatial w = tension * whole_pressure(surface, arc.arc, 0, length,
                                             pressure(surface, arc.arc, 0, length), 40);
  // Transform it to the world, on the link that carries the surface.
  const Pose<double> X = surface_pose(surface, state);
  const Eigen::Vector3d f = X.R * w.tail<3>();
  wrenches.add(surface.link, Wrench{X.R * w.head<3>() + X.p.cross(f), f});
}

/// First runs of a tendon.
struct PathPart {
  const PathShape& shape;
  std::size_t spans;  // number of runs
  bool cut;           // true: the last of them has a free end
};

/// Adds the wrenches of a part of a tendon under a tension.
inline void add_part(const TreeState<double>& state, const PathSet& set, const PathPart& part,
                     double tension, PathWrenches& wrenches) {
  const auto& [shape, spans, cut] = part;
  const std::vector<PathArc>& arcs = shape.arcs;
  const auto touches = [&](std::size_t span, bool end) {  // true: an arc begins or ends there
    return std::any_of(arcs.begin(), arcs.end(), [&](const PathArc& arc) {
      return arc.after == static_cast<int>(span) - (end ? 0 : 1);
    });
  };
  // Pull the ends of spans that are fixed points along the span.
  for (std::size_t s = 0; s < spans; ++s) {
    const PathSpan& span = shape.spans[s];
    const Eigen::Vector3d pull = tension * span.u;
    if (!touches(s, false)) wrenches.add(span.link_a, span.a, pull);
    if (!(cut && s + 1 == spans) && span.link_b != kRiding && !touches(s, true))
      wrenches.add(span.link_b, span.b, -pull);
  }
  // Add the pressure of arcs within the part.
  for (const PathArc& arc : arcs)
    if (arc.after + 1 < static_cast<int>(spans)) add_arc(state, set, arc, tension, wrenches);
}

/// Computes the wrenches on the bones of a tendon under unit tension: pulls at its ends, kinks at
/// its points, and the normal pressure  T dt/ds  integrated along every arc. They sum to zero.
[[nodiscard]] inline std::vector<LinkWrench> path_wrenches(const TreeState<double>& state,
                                                           const PathSet& set,
                                                           const std::vector<PathShape>& shapes,
                                                           std::size_t path) {
  // Add the wrenches of the tendon itself.
  PathWrenches wrenches;
  add_part(state, set, {shapes[path], shapes[path].spans.size(), /*cut=*/false}, 1, wrenches);
  if (set.paths[path].carrier < 0) return wrenches.all;
  // Apply the rider's pull -u to the carrier: its component along the carrier reduces the
  // tension towards the insertion; the rest acts on the two ends of the run by lever.
  const RidingOrigin ride = riding_origin(set, shapes, path);
  const double along = ride.u.dot(ride.v);
  const Eigen::Vector3d across = ride.u - along * ride.v;
  wrenches.add(ride.span->link_a, ride.span->a, -(1 - ride.share) * across);
  wrenches.add(ride.span->link_b, ride.span->b, -ride.share * across);
  const auto spans = static_cast<std::size_t>(ride.span - ride.carrier->spans.data()) + 1;
  add_part(state, set, {*ride.carrier, spans, /*cut=*/true}, -along, wrenches);
  return wrenches.all;
}

}  // namespace thenar::sample
