#include "grasp/quality/volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/SVD>

#include "base/error.h"
#include "base/numbers.h"
#include "base/stop_scope.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/minkowski_volume.h"
#include "grasp/quality/support_function.h"
#include "solvers/incremental_hull.h"

namespace thenar {
namespace {

// Points beyond a facet by less than this share of the size lie on it [1]
constexpr double kBeyondFacet = 1e-12;
constexpr int kMinEdges = 6;           // Fewest edges of an estimate that is not too rough
constexpr double kUpperWeight = 0.56;  // Weight of the upper bound's logarithm in the estimate [1]

constexpr int kFacetsBeforeSum = 100000;  // Facets of a hull before a method without hull is tried
constexpr double kSharpVolume = 1e-9;     // A volume with a smaller error needs no other method [1]
// Minimum error of a large hull of a sum, which nearly parallel faces fold; 1.3e-5 was observed [1]
constexpr double kFoldError = 1e-4;
constexpr int kMaxInsertions = 20;      // maximum number of insertions of a point into a hull
constexpr double kLostVolume = 0.1;     // A volume with a larger error is not known [1]
constexpr double kExactVolume = 1e-12;  // A volume with a smaller error counts as exact [1]
constexpr double kMaxChoices = 2e7;     // maximum combinations of faces, for some seconds
// Relative error of the volume of a sum that is not in general position [1]
constexpr double kSumError = 1e-6;

/// Volume of a polytope [unit forces^6].
struct PolytopeVolume {
  double volume;
  bool complete;
  int facets;
  double error = 0;  // relative error of the volume [1]
};

/// A set stretched to equal width along all axes; the volume of the original is that of `set` times
/// `shrunk`.
struct Rounded {
  WrenchSet set;
  double shrunk;
};
Rounded rounded(const WrenchSet& set, ForceNorm limit) {
  // Centre of the set; sums of Linf need none.
  WrenchCoordinates middle = WrenchCoordinates::Zero();
  if (limit == ForceNorm::kL1)
    for (const WrenchCap& cap : set.caps)
      middle += cap.c.vector() / static_cast<double>(set.caps.size());
  Eigen::Matrix<double, 6, Eigen::Dynamic> all = wrench_columns(set);
  Eigen::Index column = 0;
  for (const WrenchCap& cap : set.caps) {
    all.col(column) -= middle;
    column += 1 + cap.A.cols();
  }
  // Principal widths of all points.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all, Eigen::ComputeThinU);
  const WrenchCoordinates widths = svd.singularValues();
  const Eigen::Matrix<double, 6, 6> stretch =
      widths.cwiseInverse().asDiagonal() * svd.matrixU().transpose();
  Rounded out{set, widths.prod()};
  for (WrenchCap& cap : out.set.caps) {
    cap.c = ScaledWrench::from_coordinates(stretch * (cap.c.vector() - middle));
    cap.A = stretch * cap.A;
  }
  return out;
}

/// Relative error of a volume whose facets lie up to `off` too far inside: the set lies within a
/// copy of the hull about its middle, 1 + off / inner times as large, inner the least distance of a
/// facet.
double error_of(const internal::Hull& hull, double off) {
  return std::pow(1 + off / hull.inner_radius(), 6) - 1;
}

/// Volume of a set without curved caps by its hull. @param max_facets  of the hull
PolytopeVolume hull_volume(const WrenchSet& set, const VolumeOptions& options, int max_facets) {
  const ForceNorm limit = options.limit;
  const Rounded round = rounded(set, limit);
  const internal::SupportFunction support(round.set, limit);
  const auto simplex = internal::first_simplex(support, internal::kWrenchRankTolerance);
  if (!simplex.found) return {0, true, 0};
  internal::Hull hull(simplex.points);
  double off = 0;
  int facet = 0;
  // A point that seems to lie beyond a facet again mends a plane that rounding has moved; where it
  // does so time and again, the set is as narrow as its points are rounded.
  std::map<std::array<double, 6>, int> times;
  const auto may_come = [&](const WrenchCoordinates& p) {
    std::array<double, 6> key;
    std::copy(p.data(), p.data() + 6, key.begin());
    return ++times[key] <= kMaxInsertions;
  };
  // Refine facets until no support point lies beyond any.
  while ((facet = hull.pop_nearest()) >= 0 && hull.facets() <= max_facets &&
         !options.progress.stop()) {
    end_if_stopped();
    const internal::Hull::Plane plane = hull.plane(facet);
    const internal::SupportPoint reach = support(plane.n);
    if (reach.h > plane.d + kBeyondFacet * support.max_norm() && may_come(reach.p) &&
        hull.insert(reach.p, facet))
      continue;
    off = std::max(off, reach.h - plane.d);
  }
  const double error = error_of(hull, off);
  // For so thin a set the volume is below rounding errors.
  if (!(error <= kLostVolume)) return {0, false, hull.facets(), 1};
  return {hull.volume() * round.shrunk, facet < 0, hull.facets(), error};
}

/// Volume of a Minkowski sum without its hull, where that is possible.
std::optional<PolytopeVolume> volume_of_sum(const WrenchSet& set, const VolumeOptions& options) {
  if (options.limit != ForceNorm::kLinf) return {};
  const Rounded round = rounded(set, options.limit);
  const std::optional<double> sum =
      internal::minkowski_volume(round.set, kMaxChoices, options.progress);
  if (!sum) return {};
  return PolytopeVolume{*sum * round.shrunk, true, 0, kSumError};
}

/// Bounds by polytopes of `edges` edges inside and outside of the caps.
Volume enclosed_volume(const WrenchSet& set, const VolumeOptions& options) {
  const auto find = [&](const WrenchSet& polytopes) {
    const std::optional<PolytopeVolume> sum = volume_of_sum(polytopes, options);
    return sum ? *sum : hull_volume(polytopes, options, options.max_facets);
  };
  // Inner and outer polytopes, each widened by its error.
  PolytopeVolume in = find(inscribed_polytopes(set, options.edges));
  PolytopeVolume about = in.complete ? find(circumscribed_polytopes(set, options.edges))
                                     : PolytopeVolume{0, false, in.facets};
  in.volume *= 1 - in.error;
  about.volume *= 1 + about.error;
  if (!about.complete) return {in.volume, kInfinity, kNaN, false, about.facets, options.edges};
  // Weighted geometric mean as the estimate.
  const double guess = std::pow(in.volume, 1 - kUpperWeight) * std::pow(about.volume, kUpperWeight);
  return {in.volume, about.volume, guess, true, about.facets, options.edges};
}

/// The estimate of the coarser volume, within the bounds of both.
Volume tighter(const Volume& fine, Volume coarse) {
  coarse.lower = std::max(coarse.lower, fine.lower);
  if (coarse.edges < kMinEdges) coarse.complete = false;
  coarse.estimate = coarse.complete ? std::max(coarse.estimate, coarse.lower) : kNaN;
  return coarse;
}

/// Volume of polytopes: by the hull if it is small and sharp, otherwise by the sum without hull if
/// possible, otherwise by a larger hull.
Volume volume_of_points(const WrenchSet& set, const VolumeOptions& options) {
  const WrenchSet points = friction_pyramids(set, options.edges);
  PolytopeVolume v = hull_volume(points, options, std::min(options.max_facets, kFacetsBeforeSum));
  if (!v.complete || v.error > kSharpVolume) {
    if (const std::optional<PolytopeVolume> sum = volume_of_sum(points, options))
      v = *sum;
    else if (!v.complete)
      v = hull_volume(points, options, 8 * std::min(options.max_facets, 100000000));
  }
  // Large hulls of sums may be folded, which costs accuracy.
  const bool folded = options.limit == ForceNorm::kLinf && v.facets > kFacetsBeforeSum;
  if (folded) v.error = std::max(v.error, kFoldError);
  if (v.error < kExactVolume) v.error = 0;
  const double lower = v.volume * (1 - std::min(1.0, v.error));
  if (!v.complete) return {lower, kInfinity, kNaN, false, v.facets, 0};
  return {lower, v.volume * (1 + v.error), v.volume, true, v.facets, 0};
}

}  // namespace

Volume volume(const WrenchSet& set, const VolumeOptions& options) {
  require(options.edges >= 3, "a pyramid has at least 3 edges, got {}", options.edges);
  require(options.max_facets > 0, "the hull may have {} facets, wanted > 0", options.max_facets);
  // Points and segments need no pyramids.
  bool curved = false;
  for (std::size_t i = 0; i < set.caps.size(); ++i) {
    const WrenchCap& cap = set.caps[i];
    require(cap.c.is_finite() && cap.A.allFinite(), "wrenches {} are not finite", i);
    curved = curved || cap.A.cols() > 1;
  }
  if (set.caps.empty() || internal::span_of(set).rank < 6) return {0, 0, 0, true, 0, 0};
  if (!curved) return volume_of_points(set, options);
  // Halve the number of edges until the hulls fit.
  VolumeOptions now = options;
  Volume out = enclosed_volume(set, now);
  while (!std::isfinite(out.upper) && now.edges > 3 && !options.progress.stop()) {
    now.edges = std::max(3, now.edges / 2);
    out = tighter(out, enclosed_volume(set, now));
  }
  return out;
}

}  // namespace thenar
