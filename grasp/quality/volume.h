#pragma once

/// The volume of a wrench set.

#include "grasp/quality/wrench_set.h"

namespace thenar {

struct VolumeOptions {
  ForceLimit limit = ForceLimit::kL1;
  int edges = 8;             // of the pyramids in and about each cone; even
  int most_facets = 400000;  // of a hull before giving up
};

/// Six-dimensional volume [unit forces^6].
struct [[nodiscard]] Volume {
  double lower;     // of the set with pyramids in the cones, rounding (1e-12 of it) aside
  double upper;     // with pyramids about them; infinite if that hull was given up
  double estimate;  // extrapolated, between the two
  bool complete;    // no hull was given up
  int facets;       // of the last hull
};

/// Volume of conv(caps) (kL1), or of the Minkowski sum of caps joined with 0 (kLinf).
///
/// Hulls are refined facet by facet until no support point lies beyond any. The sets with m edges
/// in and about the cones enclose the true one; the estimate takes the error of those inside as c /
/// m^2, from m and m / 2:  V(m) + (V(m) - V(m/2)) / 3. Without cones (points, segments) all three
/// are the exact volume. Flat sets have volume 0.
/// @throws InputError if edges is odd or below 6, or a wrench is not finite
[[nodiscard]] Volume volume(const WrenchSet& set, const VolumeOptions& options = {});

}  // namespace thenar
