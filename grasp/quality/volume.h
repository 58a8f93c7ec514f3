#pragma once

/// The volume of a wrench set.

#include "base/progress.h"
#include "grasp/contact/wrench_set.h"

namespace thenar {

struct VolumeOptions {
  ForceNorm limit = ForceNorm::kL1;
  int edges = 12;           // of the pyramids in and about each cone
  int max_facets = 250000;  // of a hull before giving up; cones are then cut to half the edges.
                            // Eight times as many without cones
  Progress progress{};      // asked to stop, it gives up as if a hull had too many facets
};

/// Six-dimensional volume [unit forces^6].
struct [[nodiscard]] Volume {
  double lower;     // of the set with pyramids in the cones, rounding (1e-12 of it) aside
  double upper;     // with pyramids about them; infinite if that hull was given up
  double estimate;  // between the two; not a number unless `complete`
  bool complete;    // no hull was given up with the edges asked for, or with 6 and more
  int facets;       // of the last hull
  int edges;        // of the pyramids it has; 0 without cones
};

/// Volume of conv(caps) (kL1), or of the Minkowski sum of caps joined with 0 (kLinf).
///
/// Sets are first stretched to be as wide along all axes, as volume is affine: those pressed flat
/// lose no digits. Hulls are refined facet by facet until no support point lies beyond any; of
/// Minkowski sums of hard points the volume is had without a hull (internal::minkowski_volume()),
/// to 1e-6 at worst. Where a sum needs a hull of more than 100,000 facets, parallel faces may fold
/// it: its bounds are widened by 1e-4, which is measured (1.3e-5 was met) and not proven. The sets
/// with m edges in and about the cones enclose the true one. Of small d = (pi / m)^2 the area of a
/// polygon in a circle lacks 2 d / 3, that of one about it has d / 3 too much, their mean widths d
/// / 6 and d / 3: the estimate lower^(1 - w) upper^w is exact to d^2 with w = 2/3 or 1/3. Wrench
/// sets depend on both; w = 0.56 is within 1 % for 12 edges on random L1 grasps of three to five
/// contacts, within 3 % for 6 (soft fingers: 12 %). Without cones (points, segments) all three are
/// the exact volume. Flat sets have volume 0. L1 never holds 0 by itself: without force closure the
/// volume is that of the hull without the origin.
/// @throws InputError if edges < 3, or a wrench is not finite
[[nodiscard]] Volume volume(const WrenchSet& set, const VolumeOptions& options = {});

}  // namespace thenar
