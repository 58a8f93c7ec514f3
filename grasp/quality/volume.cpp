#include "grasp/quality/volume.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "grasp/quality/epsilon_start.h"
#include "grasp/quality/hull.h"
#include "grasp/quality/pyramid.h"

namespace thenar {
namespace {

constexpr double kFlat = 1e-10;  // widths below this part of the size count as 0 [1]
constexpr double kBeyond =
    1e-13;  // a point this far beyond a facet, in parts of the size, is on it

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

}  // namespace

Volume volume(const WrenchSet& set, const VolumeOptions& options) {
  require(options.edges >= 6 && options.edges % 2 == 0,
          "volume wants an even 6 edges or more, got {}", options.edges);
  bool curved = false;
  for (std::size_t i = 0; i < set.caps.size(); ++i) {
    const WrenchCap& cap = set.caps[i];
    require(cap.c.allFinite() && cap.A.allFinite(), "wrenches {} are not finite", i);
    curved = curved || cap.A.cols() > 1;
  }
  if (set.caps.empty() || internal::span_of(set).rank < 6) return {0, 0, 0, true, 0};

  const PolytopeVolume in = polytope_volume(pyramids(set, options.edges), options);
  if (!curved) {
    const double upper = in.complete ? in.volume : std::numeric_limits<double>::infinity();
    return {in.volume, upper, in.volume, in.complete, in.facets};
  }
  const PolytopeVolume coarse = polytope_volume(pyramids(set, options.edges / 2), options);
  const PolytopeVolume about = polytope_volume(pyramids_about(set, options.edges), options);
  const double upper = about.complete ? about.volume : std::numeric_limits<double>::infinity();
  const double guess = in.volume + (in.volume - coarse.volume) / 3;
  return {in.volume, upper, std::clamp(guess, in.volume, upper),
          in.complete && coarse.complete && about.complete, about.facets};
}

}  // namespace thenar
