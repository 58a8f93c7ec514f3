#include "tendons/wrapping/path_solver.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "tendons/wrapping/planar_wrap.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kMaxKink = 1e-11;  // largest kink of a taut path [rad]
// Attempts of Newton's method around the equilibrium of the beads
constexpr int kNewtonAttempts = 24;
constexpr double kInsideDepth = 1e-9;  // largest depth of a point in an adjacent surface [m]

bool is_round(const BoneSurface& surface) {
  return surface.shape == SurfaceShape::kSphere || surface.shape == SurfaceShape::kCylinder;
}

/// Computes the depth of a point inside a surface, 0 outside [m].
double depth_of(const BoneSurface& surface, const Vector3d& p) {
  const double r = surface.size[0];
  switch (surface.shape) {
    case SurfaceShape::kCylinder: {
      const double rho2 = p.head<2>().squaredNorm();
      return rho2 >= r * r ? 0 : r - std::sqrt(rho2);
    }
    case SurfaceShape::kSphere: {
      const double rho2 = p.squaredNorm();
      return rho2 >= r * r ? 0 : r - std::sqrt(rho2);
    }
    default:
      return level(surface, p) < 0 ? -probe(surface, p).gap : 0;
  }
}

/// Point of a carrier at the distance `ride` from its insertion.
struct RiddenPoint {
  Vector3d p;
  int span;  // span on which it lies, or before the arc on which it lies
  bool on_arc;
};
RiddenPoint point_along_carrier(const PathSet& set, const TreeState<double>& state,
                                const PathShape& carrier, double ride) {
  // Walk along runs and arcs in turn until the distance is used up.
  auto arc = carrier.arcs.begin();
  const std::size_t spans = carrier.spans.size();
  for (std::size_t s = 0; s < spans; ++s) {
    const double length = carrier.spans[s].length;
    if (ride <= length || s + 1 == spans)  // extend the last run beyond the origin
      return {carrier.spans[s].a + ride * carrier.spans[s].u, static_cast<int>(s), false};
    ride -= length;
    for (; arc != carrier.arcs.end() && arc->after == static_cast<int>(s); ++arc) {
      if (ride <= arc->arc.length) {
        const BoneSurface& surface = set.surfaces[arc->surface];
        const Vector3d p = follow_geodesic(surface, arc->arc.start, ride).ray.p;
        return {moved(state, surface.link, Vector3d(surface.X * p)), static_cast<int>(s), true};
      }
      ride -= arc->arc.length;
    }
  }
  return {carrier.spans.back().b, static_cast<int>(spans) - 1, false};
}

/// Returns the lengths of the runs between two points of one link; negative for other runs.
std::vector<double> rigid_lengths(const WrappedPath& path) {
  std::vector<double> lengths;
  for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
    const WrapPoint &a = path.points[k], &b = path.points[k + 1];
    const bool rides = path.carrier >= 0 && k + 2 == path.points.size();
    const bool rigid = a.link == b.link && path.bends[k].empty() && !rides;
    lengths.push_back(rigid ? (b.p - a.p).norm() : -1);
  }
  return lengths;
}

/// Appends a straight run. @param length  known length; negative: compute it [m]
void add_span(PathShape& shape, int link_a, int link_b, const Vector3d& a, const Vector3d& b,
              double length) {
  if (length < 0) length = (b - a).norm();
  shape.length += length;
  shape.spans.push_back({link_a, link_b, a, b, length, (length > 0 ? 1 / length : 0.0) * (b - a)});
}

/// Perturbs the starts of arcs, differently in every attempt and not at all in the first.
void perturb_starts(std::vector<ChainArc>& chain, int attempt) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double golden = 2.4 * (attempt + static_cast<double>(i)), far = 0.03 * attempt;
    const BoneSurface& surface = *chain[i].surface;
    const bool egg = surface.shape == SurfaceShape::kEllipsoid;
    const double radius = egg ? surface.size.minCoeff() : surface.size[0];
    SurfaceRay& start = chain[i].arc.start;
    const Vector3d across = start.t.cross(surface_curvature(surface, start.p).n);
    start = project_to_surface(
        surface, {start.p + far * radius * (std::cos(golden) * start.t + std::sin(golden) * across),
                  start.t + far * std::sin(2 * golden) * across});
  }
}

}  // namespace

PathSolver::PathSolver(const PathSet& set)
    : set_(&set),
      X_(set.surfaces.size()),
      far_(set.paths.size()),
      carries_(set.paths.size(), false),
      shapes_(set.paths.size()) {
  for (const WrappedPath& path : set.paths) {
    rigid_.push_back(rigid_lengths(path));
    if (path.carrier >= 0) carries_[path.carrier] = true;
  }
  // List the points that can move round an adjacent cylinder, with their reference direction.
  for (std::size_t p = 0; p < set.paths.size(); ++p) {
    const WrappedPath& path = set.paths[p];
    far_[p].resize(path.bends.size());
    for (std::size_t k = 0; k < path.bends.size(); ++k)
      for (const PathWrap& bend : path.bends[k]) {
        const BoneSurface& surface = set.surfaces[bend.surface];
        if (surface.shape != SurfaceShape::kCylinder) continue;
        for (const bool at_b : {false, true}) {
          const WrapPoint& point = path.points[at_b ? k + 1 : k];
          if (point.link == surface.link) continue;  // fixed to the cylinder's link
          const Vector3d at = surface.X.inverse() * point.p;
          far_[p][k].push_back({at_b, bend.surface, at.head<2>(), bend.side_S.head<2>()});
        }
      }
  }
  // Reserve memory once, so that solving allocates none.
  slots_.reserve(kMaxWraps);
  chain_.reserve(kMaxWraps);
  bead_chain_.reserve(kMaxWraps);
  single_.reserve(1);
}

const std::vector<PathShape>& PathSolver::solve(const TreeState<double>& state) {
  return solve(state, /*all=*/true);
}

const std::vector<PathShape>& PathSolver::solve_for_arms(const TreeState<double>& state) {
  return solve(state, /*all=*/false);
}

const std::vector<PathShape>& PathSolver::solve(const TreeState<double>& state, bool all) {
  for (std::size_t i = 0; i < X_.size(); ++i) X_[i] = surface_pose(set_->surfaces[i], state);
  for (std::size_t k = 0; k < shapes_.size(); ++k)
    solve_path(k, state, all || carries_[k] || set_->paths[k].carrier >= 0);
  return shapes_;
}

void PathSolver::solve_path(std::size_t k, const TreeState<double>& state, bool all) {
  const WrappedPath& path = set_->paths[k];
  PathShape& shape = shapes_[k];
  // Start from an empty path.
  shape.status = PathStatus::kTaut;
  shape.error = shape.depth = shape.length = 0;
  shape.iterations = 0;
  shape.ride_span = -1;
  shape.spans.clear();
  shape.arcs.clear();
  crossed_ = false;
  // Solve the runs in turn, from the insertion to the origin.
  PathEnds ends{};
  const auto place = [&](const WrapPoint& point) { return moved(state, point.link, point.p); };
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const WrapPoint &from = path.points[i], &to = path.points[i + 1];
    const bool follows = i > 0 && (all || rigid_[k][i - 1] < 0);  // its start is the end before
    if (!all && rigid_[k][i] >= 0) {
      shape.length += rigid_[k][i];
      continue;
    }
    ends.a = follows ? ends.b : place(from);
    ends.b = place(to);
    ends.link_a = from.link;
    ends.link_b = to.link;
    ends.length = rigid_[k][i];
    ends.far = &far_[k][i];
    // Place a riding origin on its carrier's path, which is solved already.
    if (path.carrier >= 0 && i + 2 == path.points.size()) {
      crossed_ = crossed_ || has_crossed(ends);
      place_riding_origin(k, state, ends, shape);
    }
    add_run(path.bends[i], ends, shape);
  }
  set_directions(shape);
  // Set the status by the worst finding.
  if (!std::isfinite(shape.length)) shape.error = 1;
  if (crossed_) shape.status = PathStatus::kFarSideWrap;
  if (!(shape.error <= kMaxKink)) shape.status = PathStatus::kStalled;
  if (!(shape.depth <= kInsideDepth)) shape.status = PathStatus::kPointInside;
}

/// Gives short runs next to an arc the arc's tangent: a point on the surface over which the tendon
/// bends, or inside it by rounding, has no run that defines the direction of the pull.
void PathSolver::set_directions(PathShape& shape) const {
  for (const PathArc& arc : shape.arcs) {
    const auto i = static_cast<std::size_t>(arc.surface);
    PathSpan& before = shape.spans[arc.after];
    PathSpan& after = shape.spans[static_cast<std::size_t>(arc.after) + 1];
    if (before.length < kShortRun) before.u = X_[i].R * arc.arc.start.t;
    if (after.length < kShortRun)
      after.u = X_[i].R * follow_geodesic(set_->surfaces[i], arc.arc.start, arc.arc.length).ray.t;
  }
}

/// Moves a riding origin onto its carrier.
void PathSolver::place_riding_origin(std::size_t k, const TreeState<double>& state, PathEnds& last,
                                     PathShape& shape) const {
  const WrappedPath& path = set_->paths[k];
  const PathShape& carrier = shapes_[path.carrier];
  const RiddenPoint ridden = point_along_carrier(*set_, state, carrier, path.ride);
  static const std::vector<FarSide> kNone;
  last.b = ridden.p;
  last.link_b = kRiding;
  last.far = &kNone;  // tested already at the fixed point
  shape.ride_span = ridden.span;
  shape.error = std::max(shape.error, carrier.error);  // includes the carrier's error
  shape.depth = std::max(shape.depth, carrier.depth);
  if (ridden.on_arc) shape.status = PathStatus::kRidesOnBend;
  for (const PathArc& arc : carrier.arcs)
    if (arc.after == ridden.span || arc.after + 1 == ridden.span)
      shape.status = PathStatus::kRidesOnBend;
}

/// Returns whether an end of a run went round the far side of an adjacent cylinder. Joints rotate
/// by less than half a turn, so the reference posture defines the way that it came.
bool PathSolver::has_crossed(const PathEnds& ends) const {
  return std::any_of(ends.far->begin(), ends.far->end(), [&](const FarSide& far) {
    const Pose<double>& X = X_[far.surface];
    const Vector3d p = X.R.transpose() * ((far.at_b ? ends.b : ends.a) - X.p);
    return crossed_far_side(far.side, far.reference, p.head<2>());
  });
}

void PathSolver::add_run(const std::vector<PathWrap>& bends, const PathEnds& ends,
                         PathShape& shape) {
  // Solve one round surface in closed form.
  if (bends.size() == 1 && add_round_run(bends[0], ends, shape)) return;
  crossed_ = crossed_ || has_crossed(ends);
  // Measure the depth of ends inside surfaces.
  for (const PathWrap& bend : bends) {
    const auto i = static_cast<std::size_t>(bend.surface);
    const Pose<double> to_S = X_[i].inverse();
    shape.depth = std::max({shape.depth, depth_of(set_->surfaces[i], to_S * ends.a),
                            depth_of(set_->surfaces[i], to_S * ends.b)});
  }
  // Iterate for several surfaces or other shapes.
  if (!bends.empty()) tighten_run(bends, ends.a, ends.b, shape);
  // Append straight spans and arcs in turn.
  int link = ends.link_a;
  Vector3d from = ends.a;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const Slot& slot = slots_[i];
    if (!slot.on) continue;
    const int on = set_->surfaces[bends[i].surface].link;
    add_span(shape, link, on, from, slot.touch_a, -1);
    shape.arcs.push_back(
        {bends[i].surface, static_cast<int>(shape.spans.size()) - 1, slot.link.arc});
    shape.length += slot.link.arc.length;
    from = slot.touch_b;
    link = on;
  }
  add_span(shape, link, ends.link_b, from, ends.b, ends.length);
}

/// Appends a run over one sphere or cylinder, the common case; returns false for other surfaces.
bool PathSolver::add_round_run(const PathWrap& bend, const PathEnds& ends, PathShape& shape) {
  const auto i = static_cast<std::size_t>(bend.surface);
  const BoneSurface& surface = set_->surfaces[i];
  if (!is_round(surface)) return false;
  // Transform the ends into the surface's frame and test them.
  const Pose<double>& X = X_[i];
  const Vector3d a_S = X.R.transpose() * (ends.a - X.p), b_S = X.R.transpose() * (ends.b - X.p);
  shape.depth = std::max({shape.depth, depth_of(surface, a_S), depth_of(surface, b_S)});
  for (const FarSide& far : *ends.far)
    crossed_ =
        crossed_ || crossed_far_side(far.side, far.reference, (far.at_b ? b_S : a_S).head<2>());
  const auto wrap = wrap_round(surface, a_S, b_S, bend.side_S);
  // Append one straight span where the string misses the surface.
  if (!wrap) {
    add_span(shape, ends.link_a, ends.link_b, ends.a, ends.b, -1);
    return true;
  }
  // Append span, arc and span.
  const Vector3d touch_b = X * wrap->end;
  add_span(shape, ends.link_a, surface.link, ends.a, X * wrap->arc.start.p, -1);
  shape.arcs.push_back({bend.surface, static_cast<int>(shape.spans.size()) - 1, wrap->arc});
  shape.length += wrap->arc.length;
  add_span(shape, surface.link, ends.link_b, touch_b, ends.b, -1);
  return true;
}

/// Wraps the string between two points over one surface; `on` is false where the string misses it.
void PathSolver::wrap_surface(std::size_t i, const PathWrap& bend, const Vector3d& a,
                              const Vector3d& b, PathShape& shape) {
  const auto s = static_cast<std::size_t>(bend.surface);
  const BoneSurface& surface = set_->surfaces[s];
  const Pose<double>& X = X_[s];
  const Pose<double> to_S = X.inverse();
  const Vector3d a_S = to_S * a, b_S = to_S * b;
  Slot& slot = slots_[i];
  // Use the closed form for round surfaces.
  if (is_round(surface)) {
    const auto wrap = wrap_round(surface, a_S, b_S, bend.side_S);
    slot.on = wrap.has_value();
    if (slot.on) slot = {true, 0, {&surface, X, wrap->arc}, X * wrap->arc.start.p, X * wrap->end};
    return;
  }
  // Use Newton's method from an initial arc for others.
  const auto arc = initial_arc(surface, a_S, b_S, bend.side_S);
  slot.on = arc.has_value();
  if (!slot.on) return;
  single_.assign(1, {&surface, X, *arc});
  const ChainFit fit = solve_tangency(a, b, single_);
  shape.iterations += fit.iterations;
  slot.error = fit.error;
  slot.link = single_[0];
  slot.on = slot.link.arc.length > 0;
  update_touch_points(slot);
}

void PathSolver::update_touch_points(Slot& slot) {
  const ChainArc& link = slot.link;
  slot.touch_a = link.X * link.arc.start.p;
  slot.touch_b = link.X * follow_geodesic(*link.surface, link.arc.start, link.arc.length).ray.p;
}

/// Solves a run over several surfaces. First each surface in turn, between its neighbours, until no
/// touch point moves: the string becomes shorter each time. Then all surfaces in contact together,
/// by Newton's method. If that does not converge, a string of beads finds which surfaces are in
/// contact, and Newton's method starts near its arcs.
void PathSolver::tighten_run(const std::vector<PathWrap>& bends, const Vector3d& a,
                             const Vector3d& b, PathShape& shape) {
  // Relax the surfaces one at a time, then solve for all of them.
  slots_.assign(bends.size(), Slot{});
  sweep_surfaces(bends, a, b, shape);
  double error = solve_clear_contacts(bends, a, b, shape);
  // Find the surfaces in contact by a contracted string of beads.
  if (!(error <= kMaxKink)) {
    start_chain_at_sides(bends);
    contract_beads(a, b, 400, chain_);
    bead_chain_ = chain_;
  }
  // Repeat Newton's method from slightly different starts.
  for (int attempt = 0; !(error <= kMaxKink) && attempt < kNewtonAttempts; ++attempt) {
    chain_ = bead_chain_;
    perturb_starts(chain_, attempt);
    load_slots(bends);
    error = solve_clear_contacts(bends, a, b, shape);
  }
  shape.error = std::max(shape.error, error);
}

/// Solves the contacts of all slots that are on by Newton's method, and drops surfaces that lift
/// off.
/// @return largest kink [rad]
double PathSolver::solve_contacts(const Vector3d& a, const Vector3d& b, PathShape& shape) {
  for (std::size_t round = 0; round <= slots_.size(); ++round) {
    // Solve all surfaces in contact together.
    chain_.clear();
    for (const Slot& slot : slots_)
      if (slot.on) chain_.push_back(slot.link);
    if (chain_.empty()) return 0;
    const ChainFit fit = solve_tangency(a, b, chain_);
    shape.iterations += fit.iterations;
    // Drop surfaces with a negative arc length: they have lifted off.
    bool lifts = false;
    std::size_t next = 0;
    for (Slot& slot : slots_) {
      if (!slot.on) continue;
      slot.link = chain_[next++];
      slot.on = slot.link.arc.length >= 0;
      lifts = lifts || !slot.on;
      update_touch_points(slot);
    }
    if (!lifts) return fit.error;
  }
  return 1;
}

/// Solves the contacts with solve_contacts(), and returns 1 if a run then passes through a surface
/// that lifted off. For a point that is inside a surface this test is skipped.
/// @return largest kink [rad]
double PathSolver::solve_clear_contacts(const std::vector<PathWrap>& bends, const Vector3d& a,
                                        const Vector3d& b, PathShape& shape) {
  const double error = solve_contacts(a, b, shape);
  return shape.depth > kInsideDepth || runs_clear(bends, a, b) ? error : 1;
}

/// Returns whether the straight runs between surfaces in contact clear all other surfaces.
bool PathSolver::runs_clear(const std::vector<PathWrap>& bends, const Vector3d& a,
                            const Vector3d& b) const {
  Vector3d from = a;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    if (slots_[i].on) {
      from = slots_[i].touch_b;
      continue;
    }
    // Find the end of the run: the next surface in contact.
    Vector3d to = b;
    for (std::size_t k = bends.size(); k-- > i + 1;)
      if (slots_[k].on) to = slots_[k].touch_a;
    const auto s = static_cast<std::size_t>(bends[i].surface);
    const Pose<double> to_S = X_[s].inverse();
    if (!(min_level(set_->surfaces[s], to_S * from, to_S * to) >= -kInsideDepth)) return false;
  }
  return true;
}

/// Starts a chain with every surface of the run, in contact at its side.
void PathSolver::start_chain_at_sides(const std::vector<PathWrap>& bends) {
  chain_.clear();
  for (const PathWrap& bend : bends) {
    const auto i = static_cast<std::size_t>(bend.surface);
    const BoneSurface& surface = set_->surfaces[i];
    // Start in the hole of a torus, not on its wall.
    const SurfaceRay start{bend.side_S, Vector3d::UnitX()};
    const bool ring = surface.shape == SurfaceShape::kTorus;
    chain_.push_back({&surface, X_[i], {ring ? start : project_to_surface(surface, start), 0}});
  }
}

/// Copies the arcs of the chain into the slots of their surfaces.
void PathSolver::load_slots(const std::vector<PathWrap>& bends) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const BoneSurface* surface = &set_->surfaces[bends[i].surface];
    slots_[i].on = next < chain_.size() && chain_[next].surface == surface;
    if (!slots_[i].on) continue;
    slots_[i].link = chain_[next++];
    update_touch_points(slots_[i]);
  }
}

/// Repeats wrap_surface() between the neighbours in contact, or a and b.
/// @return displacement of its touch points [m]; 1 if contact starts or ends
double PathSolver::update_wrap(std::size_t i, const PathWrap& bend, const Vector3d& a,
                               const Vector3d& b, PathShape& shape) {
  Vector3d before = a, after = b;
  for (std::size_t k = 0; k < i; ++k)
    if (slots_[k].on) before = slots_[k].touch_b;
  for (std::size_t k = slots_.size(); k-- > i + 1;)
    if (slots_[k].on) after = slots_[k].touch_a;
  const Slot was = slots_[i];
  wrap_surface(i, bend, before, after, shape);
  if (was.on != slots_[i].on) return 1;
  if (!was.on) return 0;
  return std::max(
      {0.0, (was.touch_a - slots_[i].touch_a).norm(), (was.touch_b - slots_[i].touch_b).norm()});
}

void PathSolver::sweep_surfaces(const std::vector<PathWrap>& bends, const Vector3d& a,
                                const Vector3d& b, PathShape& shape) {
  // Iterate over the surfaces (Gauss-Seidel) until no touch point moves.
  const std::size_t m = bends.size();
  for (int pass = 0; pass < (m == 1 ? 1 : 40); ++pass) {
    double moved_by = 0, error = 0;
    for (std::size_t i = 0; i < m; ++i)
      moved_by = std::max(moved_by, update_wrap(i, bends[i], a, b, shape));
    for (const Slot& slot : slots_)
      if (slot.on) error = std::max(error, slot.error);
    if (moved_by < 1e-6 || !(error <= 1e-3)) return;
  }
}

Eigen::Matrix3Xd path_points(const PathSet& set, const TreeState<double>& state,
                             const PathShape& shape, double spacing) {
  require(spacing > 0, "points along a path need a spacing > 0, got {} m", spacing);
  std::vector<Vector3d> points;
  auto arc = shape.arcs.begin();
  // Collect the ends of each span, and samples of the arcs between spans.
  for (std::size_t s = 0; s < shape.spans.size(); ++s) {
    points.push_back(shape.spans[s].a);
    points.push_back(shape.spans[s].b);
    for (; arc != shape.arcs.end() && arc->after == static_cast<int>(s); ++arc) {
      const BoneSurface& surface = set.surfaces[arc->surface];
      const int steps = static_cast<int>(std::ceil(arc->arc.length / spacing));
      for (int i = 1; i < steps; ++i) {
        const Vector3d p =
            follow_geodesic(surface, arc->arc.start, arc->arc.length * i / steps).ray.p;
        points.push_back(moved(state, surface.link, Vector3d(surface.X * p)));
      }
    }
  }
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = points[i];
  return all;
}

}  // namespace thenar
