#pragma once

/// Volume of a wrench set.

#include "base/numbers.h"
#include "base/progress.h"
#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Settings of volume().
struct VolumeOptions {
  ForceNorm limit = ForceNorm::kL1;
  int edges = 12;           // number of edges of the pyramids inside and outside of each cone
  int max_facets = 250000;  // maximum of a hull; above it cones are cut to half the edges. Eight
                            // times as many without cones
  Progress progress{};      // if it stops, the search ends as with too many facets
};

/// Six-dimensional volume [unit forces^6].
struct [[nodiscard]] Volume {
  double lower = 0;        // volume with pyramids inside the cones, up to rounding (1e-12 of it)
  double upper = 0;        // volume with pyramids outside; infinite if that hull is incomplete
  double estimate = kNaN;  // estimate between the two; NaN unless `complete`
  /// True: the hulls are complete with the requested edges, or with at least 6.
  bool complete = false;
  int facets = 0;  // number of facets of the last hull
  int edges = 0;   // number of edges of its pyramids; 0 without cones
};

/// Computes the volume of conv(caps) (kL1), or of the Minkowski sum of caps joined with 0 (kLinf).
///
/// Sets are first stretched to equal width along all axes, as volume is affine: thin ones lose no
/// digits. Hulls are refined facet by facet until no support point lies beyond any. The volume of
/// Minkowski sums of hard points needs no hull (internal::minkowski_volume()) and is accurate to
/// 1e-6 at worst. If a sum needs a hull of more than 100,000 facets, parallel faces may fold it:
/// its bounds are widened by 1e-4, which is measured (1.3e-5 was observed) and not proven.
///
/// Polytopes with m edges inside and outside of the cones enclose the true set. For small d = (pi /
/// m)^2 the area of a polygon in a circle is too small by 2 d / 3, that of a polygon around it too
/// large by d / 3, their mean widths by d / 6 and d / 3: the estimate lower^(1 - w) upper^w is
/// exact to d^2 with w = 2/3 or 1/3. Wrench sets depend on both; w = 0.56 is within 1 % for 12
/// edges on random L1 grasps of three to five contacts, within 3 % for 6 (soft fingers: 12 %).
///
/// Without cones (points, segments) all three are the exact volume. Flat sets have volume 0. An L1
/// set need not contain 0: without force closure the volume is that of the hull without the origin.
/// @throws InputError if edges < 3, or a wrench is not finite
[[nodiscard]] Volume volume(const WrenchSet& set, const VolumeOptions& options = {});

}  // namespace thenar
