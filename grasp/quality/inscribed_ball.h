#pragma once

/// Radius of the largest ball of wrenches that forces can make: epsilon quality with real limits.

#include "grasp/limits/wrench_support.h"

namespace thenar {

/// Settings of inscribed_ball().
struct BallOptions {
  double gap = 1e-2;             // certified upper - lower, as a part of upper [1]
  double max_total_force = 1e4;  // limit of the sum of normal forces: makes the set finite [N]
  int max_programs = 600;        // cone programs to solve at most
};

/// Signed radius of the largest ball about the origin in the wrenches of a force set.
struct [[nodiscard]] InscribedBall {
  Status status;  // kSolved; kInfeasible: no force is possible; kLimit: `max_programs`;
                  // kUnbounded: every wrench can be made, bounds are infinite
  double lower;   // [N]: the radius is in [lower, upper], each to within `residual` times 1 N
  double upper;   // and the largest wrench met
  ScaledWrench worst_load;  // unit: load that is resisted least (6)
  int programs;             // cone programs solved
  double residual;          // largest of their KKT conditions, recomputed [1]
};

/// Computes epsilon = min over |u| = 1 of h(u), h the support function of the set. Each direction
/// is a cone program, whose multipliers bound it from above. The boundary points found span a
/// polytope inside the set; its nearest facet bounds epsilon from below and gives the next
/// direction, as in epsilon(). Zero or negative: some load is not resisted, however small.
/// Infinite: is_unlimited().
/// @throws InputError if a setting is not positive
/// Source: [Krug2017] for wrench sets bounded by actuators.
InscribedBall inscribed_ball(const ForceSet& forces, const BallOptions& options = {});

/// Returns whether forces balance every load along the first axes of a wrench, however large: the
/// recession cone of the set (all limits at zero) contains both directions of each axis.
[[nodiscard]] bool is_unlimited(ForceSet forces, int axes);

}  // namespace thenar
