#include "grasp/quality/volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "grasp/quality/epsilon_start.h"
#include "grasp/quality/hull.h"
#include "grasp/quality/pyramid.h"
#include "grasp/quality/sum_volume.h"

namespace thenar {
namespace {

constexpr double kFlat = 1e-10;  // widths below this part of the size count as 0 [1]
constexpr double kBeyond =
    1e-13;  // a point this far beyond a facet, in parts of the size, is on it

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kLeastEdges = 6;    // with fewer than asked for an estimate to mean much
constexpr double kWeight = 0.56;  // of the upper bound's logarithm in the estimate [1]

constexpr double kMostChoices = 2e7;  // of faces of a sum: some seconds
constexpr double kSumError = 1e-6;    // of the volume of a sum that is not in general position [1]

struct PolytopeVolume {
  double volume;
  bool complete;
  int facets;
};

/// Of a set without curved caps.
PolytopeVolume polytope_volume(const WrenchSet& set, const VolumeOptions& options) {
  const internal::Support support(set, options.limit);
  const auto simplex = internal::first_simplex(support, kFlat);
  if (!simplex.found) return {0, true, 0};
  internal::Hull hull(simplex.points);
  for (;;) {
    const int facet = hull.pop_nearest();
    if (facet < 0) return {hull.volume(), true, hull.facets()};
    if (hull.facets() > options.most_facets) return {hull.volume(), false, hull.facets()};
    const internal::Hull::Plane plane = hull.plane(facet);
    const internal::Reach reach = support(plane.n);
    if (reach.h > plane.d + kBeyond * support.size()) hull.insert(reach.p, facet);
  }
}

/// Of a Minkowski sum without its hull, where that can be, else by the hull.
PolytopeVolume volume_of_sum(const WrenchSet& set, const VolumeOptions& options) {
  if (options.limit == ForceLimit::kLinf)
    if (const std::optional<double> sum = internal::sum_volume(set, kMostChoices))
      return {*sum, true, 0};
  return polytope_volume(set, options);
}

/// With polytopes of so many edges in and about the caps.
Volume enclosed_volume(const WrenchSet& set, const VolumeOptions& options) {
  PolytopeVolume in = volume_of_sum(polytopes_in(set, options.edges), options);
  PolytopeVolume about = in.complete ? volume_of_sum(polytopes_about(set, options.edges), options)
                                     : PolytopeVolume{0, false, in.facets};
  if (in.complete && in.facets == 0) in.volume *= 1 - kSumError;
  if (about.complete && about.facets == 0) about.volume *= 1 + kSumError;
  if (!about.complete) return {in.volume, kInfinity, kNone, false, about.facets, options.edges};
  const double guess = std::pow(in.volume, 1 - kWeight) * std::pow(about.volume, kWeight);
  return {in.volume, about.volume, guess, true, about.facets, options.edges};
}

/// The estimate of the coarser, within the bounds of both.
Volume tighter(const Volume& fine, Volume coarse) {
  coarse.lower = std::max(coarse.lower, fine.lower);
  if (coarse.edges < kLeastEdges) coarse.complete = false;
  coarse.estimate = coarse.complete ? std::max(coarse.estimate, coarse.lower) : kNone;
  return coarse;
}

/// The hull, if it is small; else the sum without it, if that can be; else the hull with patience.
Volume volume_of_points(const WrenchSet& set, const VolumeOptions& options) {
  const WrenchSet points = pyramids(set, options.edges);
  PolytopeVolume v = polytope_volume(points, options);
  if (!v.complete && options.limit == ForceLimit::kLinf)
    if (const std::optional<double> sum = internal::sum_volume(points, kMostChoices))
      return {*sum * (1 - kSumError), *sum * (1 + kSumError), *sum, true, 0, 0};
  if (!v.complete) {
    VolumeOptions patient = options;
    patient.most_facets = 8 * std::min(options.most_facets, 100000000);
    v = polytope_volume(points, patient);
  }
  if (!v.complete) return {v.volume, kInfinity, kNone, false, v.facets, 0};
  return {v.volume, v.volume, v.volume, true, v.facets, 0};
}

}  // namespace

Volume volume(const WrenchSet& set, const VolumeOptions& options) {
  require(options.edges >= 3, "a pyramid has at least 3 edges, got {}", options.edges);
  require(options.most_facets > 0, "the hull may have {} facets, wanted > 0", options.most_facets);
  bool curved = false;
  for (std::size_t i = 0; i < set.caps.size(); ++i) {
    const WrenchCap& cap = set.caps[i];
    require(cap.c.allFinite() && cap.A.allFinite(), "wrenches {} are not finite", i);
    curved = curved || cap.A.cols() > 1;
  }
  if (set.caps.empty() || internal::span_of(set).rank < 6) return {0, 0, 0, true, 0, 0};
  if (!curved) return volume_of_points(set, options);
  VolumeOptions now = options;
  Volume out = enclosed_volume(set, now);
  while (!std::isfinite(out.upper) && now.edges > 3) {
    now.edges = std::max(3, now.edges / 2);
    out = tighter(out, enclosed_volume(set, now));
  }
  return out;
}

}  // namespace thenar
