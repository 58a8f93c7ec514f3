#pragma once

/// Epsilon quality: the smallest disturbance that unit contact forces cannot resist.

#include "grasp/contact/wrench_set.h"
#include "grasp/quality/support_function.h"

namespace thenar {

/// Settings of epsilon().
struct EpsilonOptions {
  ForceNorm limit = ForceNorm::kL1;  // norm that limits the contact forces together
  double gap = 1e-3;        // maximum of certified upper - lower, for unit contact forces [1]
  int max_facets = 500000;  // maximum number of facets of the hull (about 70 MB)
};

/// Signed epsilon quality: the signed distance of the origin from the boundary of the wrench set,
/// positive inside, in N per N of normal force [1].
///
/// `lower` and `upper` enclose the true value, including the rounding errors of every step. A set
/// of less than full rank (1e-10 of its largest singular value) is first projected onto its span;
/// if the absolute value is then below 1e-9 of the largest wrench, it is reported as exactly 0. The
/// search continues beyond `gap` until the sign of the value is certain, or the value is below 1e-9
/// of the largest wrench.
struct [[nodiscard]] Epsilon {
  double lower = 0;                    // certified lower bound of the true value [1]
  double upper = 0;                    // certified upper bound [1]
  int rank = 0;                        // dimension of the affine hull of the wrenches and 0, 0..6
  bool force_closure = false;          // lower > 0 at full rank: 6, for planar_epsilon() 3
  bool has_missing_direction = false;  // true without force closure
  ScaledWrench
      missing_direction;  // unit u along which the grasp cannot push: each of its wrenches has w'u
                          // <= upper, which is <= 0, or about 0 if the sign is uncertain
  ScaledWrench worst_wrench;  // unit disturbance that is resisted least, -argmin h
  bool converged = false;     // true: upper - lower <= gap
  int supports = 0;           // number of support points computed
  int facets = 0;             // number of facets of the last hull; 0 if none was needed
};

/// Computes epsilon = min over |u| = 1 of h_W(u), h_W the support function of the wrench set W.
///
/// A hull of support points lies inside W, so its nearest facet bounds epsilon from below; the
/// support in any direction bounds it from above. Only the facet nearest to the origin is refined,
/// by the support point in its direction, until both bounds agree. Flat sets are treated in their
/// span: their epsilon is 0 (the origin is in their relative interior or boundary) or minus the
/// distance of the origin from the set, with a missing direction. For kLinf without force closure
/// the value is that of kL1, as the Minkowski sum always contains 0.
/// @throws InputError if the gap is not positive or a wrench not finite.
/// Source: [Ferrari1992] for epsilon; docs/theory/grasp_quality.md for the bounds.
Epsilon epsilon(const WrenchSet& set, const EpsilonOptions& options = {});

/// Returns the smallest gap that bounds of a curved set can reach: a proof for a gap g leaves the
/// bounds apart by 0.9 g and the rounding r of a support, so that  g >= 10 r  [1].
[[nodiscard]] double min_gap(const WrenchSet& set, ForceNorm limit);

}  // namespace thenar

namespace thenar::internal {

/// Point of a wrench set nearest to the origin, with bounds of its distance.
struct [[nodiscard]] MinNorm {
  WrenchCoordinates x;          // point of the set, up to rounding: the distance is at most |x| [1]
  WrenchCoordinates direction;  // unit direction with the smallest support found
  double support = 0;           // h(direction): if negative, the distance is at least -support [1]
  int supports = 0;             // number of support points computed
};

/// Finds min |x| over the set by Wolfe's method on support points, until |x| + h(-x/|x|) <= gap or
/// x is 0 to rounding. If the origin lies inside, the gap cannot be reached and x is about 0.
/// Source: [Wolfe1976].
MinNorm min_norm(const SupportFunction& support, double gap);

}  // namespace thenar::internal
