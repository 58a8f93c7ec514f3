#pragma once

/// Radius of the largest ball of wrenches that forces can exert: epsilon quality with real limits.

#include "grasp/limits/wrench_support.h"

namespace thenar {

/// Settings of inscribed_ball().
struct BallOptions {
  double gap = 1e-2;  // maximum of certified upper - lower, over upper [1]
  /// Limit of the sum of normal forces, which makes the set bounded [N].
  double max_total_force = 1e4;
  int max_programs = 600;  // maximum number of cone programs
};

/// Signed radius of the largest ball about the origin in the wrenches of a force set.
struct [[nodiscard]] InscribedBall {
  /// kSolved; kInfeasible: no force is possible; kLimit: `max_programs` reached; kUnbounded: every
  /// wrench is possible, both bounds are infinite.
  Status status = Status::kStalled;
  double lower = 0;  // lower bound of the radius, within `residual` times 1 N and the largest
                     // wrench found [N]
  double upper = 0;  // upper bound of the radius, within the same [N]
  ScaledWrench worst_load;  // unit load that is resisted least (6)
  int programs = 0;         // number of cone programs solved
  double residual = 0;      // largest of their recomputed KKT conditions [1]
};

/// Computes epsilon = min over |u| = 1 of h(u), h the support function of the set. Each direction
/// is a cone program, whose multipliers bound it from above. The boundary points found span a
/// polytope inside the set; its nearest facet bounds epsilon from below and gives the next
/// direction, as in epsilon(). Zero or negative: some load is not resisted at any magnitude.
/// Infinite: is_unlimited().
/// @throws InputError if a setting is not positive
/// Source: [Krug2017] for wrench sets bounded by actuators.
InscribedBall inscribed_ball(const ForceSet& forces, const BallOptions& options = {});

/// Returns whether forces balance every load along the first axes of a wrench, at any magnitude:
/// the recession cone of the set (all limits at zero) contains both directions of each axis.
[[nodiscard]] bool is_unlimited(ForceSet forces, int axes);

}  // namespace thenar
