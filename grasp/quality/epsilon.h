#pragma once

/// Epsilon quality: the smallest disturbance that unit contact forces cannot resist.

#include "grasp/contact/wrench_set.h"
#include "grasp/quality/support_function.h"

namespace thenar {

/// Settings of epsilon().
struct EpsilonOptions {
  ForceNorm limit = ForceNorm::kL1;  // norm that limits the contact forces together
  double gap = 1e-3;        // certified upper - lower is at most this, for unit contact forces [1]
  int max_facets = 500000;  // of the hull; the search stops beyond (some 70 MB)
};

/// Signed epsilon quality: the signed distance of the origin from the boundary of the wrench set,
/// positive inside, in N per N of normal force [1].
///
/// `lower` and `upper` enclose the true value, with the rounding of every step. A set of less than
/// full rank (1e-10 of its largest singular value) is first projected onto its span; if the
/// absolute value is then below 1e-9 of the largest wrench, it is reported as exactly 0. The search
/// goes on beyond `gap` until the sign of the value is settled, or the value is below 1e-9 of the
/// largest wrench.
struct [[nodiscard]] Epsilon {
  double lower;                    // certified: the true value is in [lower, upper] [1]
  double upper;                    // [1]
  int rank;                        // dimension of the affine hull of the wrenches and 0, 0..6
  bool force_closure;              // lower > 0 at full rank: 6, of planar_epsilon() 3
  bool has_missing_direction;      // true without force closure
  ScaledWrench missing_direction;  // unit u that the grasp cannot push along: each of its wrenches
                                   // has w'u <= upper, which is <= 0, or about 0 if the sign is
                                   // not settled
  ScaledWrench worst_wrench;       // unit: disturbance that is resisted least, -argmin h
  bool converged;                  // upper - lower <= gap
  int supports;                    // number of support points computed
  int facets;                      // of the last hull; 0 if none was needed
};

/// Computes epsilon = min over |u| = 1 of h_W(u), h_W the support function of the wrench set W.
///
/// A hull of support points lies inside W, so its nearest facet bounds epsilon from below; the
/// support in any direction bounds it from above. Only the facet nearest to the origin is refined,
/// by the support point in its direction, until both bounds agree. Flat sets are treated in their
/// span: their epsilon is 0 (the origin in their relative interior or boundary) or minus the
/// distance of the origin from the set, with a missing direction.
/// For kLinf without force closure the value is that of kL1, as the Minkowski sum always contains
/// 0.
/// @throws InputError if the gap is not positive or a wrench not finite.
/// Source: [Ferrari1992] for epsilon; docs/theory/grasp_quality.md for the bounds.
Epsilon epsilon(const WrenchSet& set, const EpsilonOptions& options = {});

}  // namespace thenar

namespace thenar::internal {

/// Nearest point of a wrench set to the origin, with the bounds of its distance.
struct [[nodiscard]] MinNorm {
  WrenchCoordinates x;     // a point of the set, up to rounding: the distance is at most |x| [1]
  WrenchCoordinates away;  // unit direction with the smallest support found
  double reach;            // h(away): if negative, the distance is at least -reach [1]
  int supports;            // number of support points computed
};

/// Finds min |x| over the set by Wolfe's method on support points, until |x| + h(-x/|x|) <= gap or
/// x is 0 to rounding. If the origin lies inside, the gap cannot be met and x is about 0. Source:
/// [Wolfe1976].
MinNorm min_norm(const SupportFunction& support, double gap);

}  // namespace thenar::internal
