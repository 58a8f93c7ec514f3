#pragma once

/// How large a wrench, from whatever direction, a grasp withstands.

#include "grasp/quality/wrench_set.h"

namespace thenar {

struct EpsilonOptions {
  ForceLimit limit = ForceLimit::kL1;
  double gap = 1e-3;         // certified upper - lower is at most this, in units of unit forces [1]
  int most_facets = 200000;  // of the hull before giving up
};

/// Signed epsilon quality: the signed distance of the origin from the boundary of the wrench set,
/// positive inside. Force closure if lower > 0.
struct [[nodiscard]] Epsilon {
  double lower;  // certified: the true value is in [lower, upper]
  double upper;
  int rank;            // dimension of the affine hull of the wrenches with 0, 0..6
  bool force_closure;  // lower > 0 in all six dimensions
  bool has_missing_direction;
  Wrench
      missing_direction;  // unit: no wrench resists a disturbance along it; without force closure
  Wrench worst_wrench;    // unit: the disturbance withstood least
  bool converged;         // upper - lower <= gap
  int supports;           // support points asked for
  int facets;             // of the last hull
};

/// epsilon = min over |u| = 1 of h_W(u), h_W the support function of the wrench set W.
///
/// A hull of support points lies inside W, so its nearest facet bounds epsilon from below; the
/// support in any direction bounds it from above. Only the facet nearest to the origin is refined,
/// by the support point in its direction, until both agree. Flat sets are treated in the space they
/// span: their epsilon is 0 (the origin in their relative interior or boundary) or minus the
/// distance of the origin from the set, and the direction they lack is named.
/// For kLinf without force closure the value is that of kL1, as the Minkowski sum always holds 0.
/// Source: [Ferrari1992] for epsilon; docs/theory/grasp_quality.md for the bounds.
Epsilon epsilon(const WrenchSet& set, const EpsilonOptions& options = {});

}  // namespace thenar
