#pragma once

/// How large a wrench, from whatever direction, a grasp withstands.

#include "grasp/contact/wrench_set.h"
#include "grasp/quality/support_function.h"

namespace thenar {

struct EpsilonOptions {
  ForceNorm limit = ForceNorm::kL1;
  double gap = 1e-3;        // certified upper - lower is at most this, in units of unit forces [1]
  int max_facets = 500000;  // of the hull before giving up (some 70 MB)
};

/// Signed epsilon quality: the signed distance of the origin from the boundary of the wrench set,
/// positive inside. Force closure if lower > 0.
///
/// `lower` and `upper` enclose the true value, the rounding of every step included; a set with less
/// than full rank (1e-10 of its largest singular value) is first projected onto its span, and its
/// value is then exactly 0 if below 1e-9 of the largest wrench. The search goes on beyond `gap`
/// until the sign is settled, or the value is below 1e-9 of the largest wrench.
struct [[nodiscard]] Epsilon {
  double lower;  // certified: the true value is in [lower, upper]
  double upper;
  int rank;                        // dimension of the affine hull of the wrenches with 0, 0..6
  bool force_closure;              // lower > 0 in all six dimensions
  bool has_missing_direction;      // true without force closure
  ScaledWrench missing_direction;  // unit u: no wrench of the grasp has w'u > upper, which is <= 0
                                   // or, where the sign stayed open, about 0
  ScaledWrench worst_wrench;  // unit: the disturbance withstood least, -argmin h
  bool converged;             // upper - lower <= gap
  int supports;               // support points asked for
  int facets;                 // of the last hull; 0 where none was needed
};

/// epsilon = min over |u| = 1 of h_W(u), h_W the support function of the wrench set W.
///
/// A hull of support points lies inside W, so its nearest facet bounds epsilon from below; the
/// support in any direction bounds it from above. Only the facet nearest to the origin is refined,
/// by the support point in its direction, until both agree. Flat sets are treated in the space they
/// span: their epsilon is 0 (the origin in their relative interior or boundary) or minus the
/// distance of the origin from the set, and the direction they lack is named.
/// For kLinf without force closure the value is that of kL1, as the Minkowski sum always holds 0.
/// @throws InputError if the gap is not positive or a wrench not finite.
/// Source: [Ferrari1992] for epsilon; docs/theory/grasp_quality.md for the bounds.
Epsilon epsilon(const WrenchSet& set, const EpsilonOptions& options = {});

}  // namespace thenar

namespace thenar::internal {

// The point of a wrench set nearest to the origin.

/// Nearest point and what it proves of the distance.
struct [[nodiscard]] MinNorm {
  ScaledWrench x;     // a point of the set, rounding aside: the distance is at most |x|
  ScaledWrench away;  // unit direction with the least support found
  double reach;       // h(away): where negative, the distance is at least -reach
  int supports;       // asked for
};

/// min |x| over the set, by Wolfe's method on support points, until |x| + h(-x/|x|) <= gap or x is
/// 0 to rounding. The gap cannot be met where the origin lies inside: x is then about 0.
/// Source: [Wolfe1976].
MinNorm min_norm(const SupportFunction& support, double gap);

}  // namespace thenar::internal
