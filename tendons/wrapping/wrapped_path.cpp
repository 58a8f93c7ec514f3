#include "tendons/wrapping/wrapped_path.h"

#include <algorithm>
#include <limits>
#include <set>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "tendons/wrapping/path_solver.h"
#include "tendons/wrapping/planar_wrap.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// largest distance of an origin from the strand on which it rides [m]
constexpr double kRideReach = 1e-3;
constexpr double kPointInside = 1e-9;  // largest depth of a point in an adjacent surface [m]

/// Checks that a point does not lie inside a surface.
void check_outside(const WrappedPath& path, std::size_t point, const BoneSurface& surface) {
  const Vector3d p = surface.X.inverse() * path.points[point].p;
  const double depth = level(surface, p) < 0 ? -probe(surface, p).gap : 0;
  require(depth <= kPointInside, "point {} of strand '{}' lies {:.3g} mm inside surface '{}'",
          point + 1, path.name, 1e3 * depth, surface.name);
}

/// Checks that no point reaches a cylinder's half plane opposite to the path's side, where the
/// length jumps, at the ends and middles of the ranges of the joints between them. Joints without a
/// range stay at 0.
void check_sides(const WrappedPath& path, std::size_t k, const PathWrap& bend,
                 const BoneSurface& surface, const Skeleton& skeleton) {
  if (surface.shape != SurfaceShape::kCylinder) return;
  for (const std::size_t end : {k, k + 1}) {
    // List the joints between the point and the cylinder.
    const WrapPoint& point = path.points[end];
    const Vector3d was = surface.X.inverse() * point.p;
    std::set<int> joints;
    for_each_hinge_between(skeleton.tree, point.link, surface.link, [&](int i, bool /*on_b*/) {
      joints.insert(skeleton.tree[i].coordinate);
    });
    int postures = 1;
    for (std::size_t i = 0; i < joints.size(); ++i) postures *= 3;
    // Try every combination of lower limit, middle and upper limit.
    Eigen::VectorXd q = Eigen::VectorXd::Zero(skeleton.coordinates());
    for (int n = 0; n < postures; ++n) {
      int rest = n;
      for (int j : joints) {
        const auto& limit = skeleton.limits[j];
        const bool ranges = limit.upper - limit.lower < 2 * kPi - 1e-9;
        q[j] = ranges ? limit.lower + 0.5 * (rest % 3) * (limit.upper - limit.lower) : 0;
        rest /= 3;
      }
      // Test the point in the cylinder's frame.
      const TreeState<double> state = pose_tree(skeleton.tree, q);
      const Vector3d is =
          surface_pose(surface, state).inverse() * moved(state, point.link, point.p);
      require(
          !crossed_far_side(bend.side_S.head<2>(), was.head<2>(), is.head<2>()),
          "point {} of strand '{}' goes round the far side of surface '{}' within the ranges of "
          "its joints, where its length jumps: choose another side, or narrower ranges",
          end + 1, path.name, surface.name);
    }
  }
}

/// Checks the runs of a path and its points near surfaces.
void check_path(const WrappedPath& path, const PathSet& set, const Skeleton& skeleton) {
  // Check that runs across a joint have a length and not too many surfaces.
  for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
    const WrapPoint &a = path.points[k], &b = path.points[k + 1];
    require(a.link == b.link || (a.p - b.p).norm() > 1e-9,
            "path of strand '{}' has a zero-length run across a joint at point {}", path.name,
            k + 1);
    require(path.bends[k].size() <= static_cast<std::size_t>(kMaxWraps),
            "strand '{}' bends over {} surfaces after point {}; the most is {}", path.name,
            path.bends[k].size(), k + 1, kMaxWraps);
    // Check that points next to a surface stay outside it and on its near side.
    for (const PathWrap& bend : path.bends[k]) {
      check_outside(path, k, set.surfaces[bend.surface]);
      check_outside(path, k + 1, set.surfaces[bend.surface]);
      check_sides(path, k, bend, set.surfaces[bend.surface], skeleton);
    }
  }
}

bool crosses_a_joint(const WrappedPath& path) {
  return any_of(path.points,
                [&](const WrapPoint& point) { return point.link != path.points.front().link; });
}

/// Collects points and surfaces on the kept links; those on dropped segments are left out.
WrappedPath kept_path(const Strand& strand, const Skeleton& skeleton, const PathSet& set) {
  WrappedPath path;
  path.name = strand.name;
  std::vector<PathWrap> bends;  // surfaces since the last point
  // Visit the elements of the strand that lie on kept links.
  for (const PathPoint& element : strand.path) {
    const auto link = skeleton.link_of_segment.find(element.segment);
    if (link == skeleton.link_of_segment.end()) continue;
    // Pose the element at the reference posture.
    const Vector3d p = skeleton.segment_at.at(element.segment) * element.p;
    // Add a surface to the run that follows the last point.
    if (!element.surface.empty()) {
      const int surface = place_named(set.surfaces, element.surface);
      const Pose<double>& X = set.surfaces[surface].X;
      if (!path.points.empty()) bends.push_back({surface, X.inverse() * p});
      continue;
    }
    // End that run at a point.
    if (!path.points.empty()) path.bends.push_back(bends);
    bends.clear();
    path.points.push_back({link->second, p});
  }
  return path;
}

/// Point of a posed path nearest to a given one: its distance from that, and from the insertion
/// along the path [m].
struct PathPlace {
  double off, along;
};
PathPlace nearest_place(const PathShape& shape, const Vector3d& p) {
  PathPlace nearest{std::numeric_limits<double>::infinity(), 0};
  double before = 0;
  auto arc = shape.arcs.begin();
  // Compare the nearest points of all straight runs.
  for (std::size_t s = 0; s < shape.spans.size(); ++s) {
    const PathSpan& span = shape.spans[s];
    const Vector3d u = span.u;
    const double length = span.length, along = std::clamp((p - span.a).dot(u), 0.0, length);
    const double off = (span.a + along * u - p).norm();
    if (off < nearest.off) nearest = {off, before + along};
    before += length;
    for (; arc != shape.arcs.end() && arc->after == static_cast<int>(s); ++arc)
      before += arc->arc.length;
  }
  return nearest;
}

/// Attaches the origin to its carrier, if the set has it.
void set_ride(WrappedPath& path, const PathPoint& origin, const Subject& subject, Skeleton skeleton,
              const PathSet& set) {
  path.carrier = place_named(set.paths, origin.rides_on);
  if (path.carrier < 0) return;
  // Solve the carrier at the reference posture, where no joint is turned, the frozen ones included.
  for (auto& [segment, at] : skeleton.segment_at) at = {};
  PathSet alone{place_surfaces(subject, skeleton), {}};
  alone.paths = {kept_path(*find_named(subject.strands, origin.rides_on), skeleton, alone)};
  PathSolver solver(alone);
  const auto& shapes = solver.solve(TreeState<double>(skeleton.tree.size()));
  // Find its point nearest to the origin, which must be close.
  const PathPlace place = nearest_place(shapes.front(), origin.p);
  require(place.off <= kRideReach,
          "the origin of strand '{}' rides on '{}' but lies {:.3g} mm from it, more than {:.3g} mm",
          path.name, origin.rides_on, 1e3 * place.off, 1e3 * kRideReach);
  path.ride = place.along;
}

/// Builds the paths of all strands, or of the named ones with their carriers.
PathSet build(const Subject& subject, const Skeleton& skeleton,
              const std::vector<std::string>* only) {
  // Select a strand if it is named or carries a named one.
  PathSet set;
  set.surfaces = place_surfaces(subject, skeleton);
  const auto wanted = [&](const Strand& strand) {
    const auto carries = [&](const std::string& name) {
      return any_of(subject.strands, [&](const Strand& other) {
        return other.name == name && !other.path.empty() &&
               other.path.back().rides_on == strand.name;
      });
    };
    return only == nullptr || contains(*only, strand.name) || any_of(*only, carries);
  };
  // Build the paths in file order; a rider follows its carrier.
  for (const Strand& strand : subject.strands) {
    if (!wanted(strand)) continue;
    WrappedPath path = kept_path(strand, skeleton, set);
    if (path.points.size() < 2 || !crosses_a_joint(path)) continue;
    check_path(path, set, skeleton);
    const PathPoint& origin = strand.path.back();
    if (!origin.rides_on.empty() && skeleton.link_of_segment.count(origin.segment) > 0)
      set_ride(path, origin, subject, skeleton, set);
    set.paths.push_back(std::move(path));
  }
  return set;
}

}  // namespace

std::vector<BoneSurface> place_surfaces(const Subject& subject, const Skeleton& skeleton) {
  std::vector<BoneSurface> placed;
  for (const Surface& surface : subject.surfaces) {
    const auto link = skeleton.link_of_segment.find(surface.segment);
    if (link == skeleton.link_of_segment.end()) continue;
    placed.push_back(
        {surface.name, link->second, surface.shape, surface.size,
         skeleton.segment_at.at(surface.segment) * Pose<double>{surface.axes, surface.center}});
  }
  return placed;
}

PathSet build_paths(const Subject& subject, const Skeleton& skeleton) {
  return build(subject, skeleton, nullptr);
}

PathSet build_paths(const Subject& subject, const Skeleton& skeleton,
                    const std::vector<std::string>& strands) {
  return build(subject, skeleton, &strands);
}

}  // namespace thenar
