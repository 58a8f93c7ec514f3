#pragma once

/// How large a wrench, from whatever direction, forces can make.

#include "grasp/limits/wrench_support.h"

namespace thenar {

struct BallOptions {
  double gap = 1e-2;  // certified upper - lower, as a part of upper [1]
  double max_total_force =
      1e4;                 // sum of normal forces that nothing exceeds: makes the set finite [N]
  int max_programs = 600;  // cone programmes before giving up
};

/// Signed radius of the largest ball about the origin in the wrenches of a force set.
struct [[nodiscard]] InscribedBall {
  ConeStatus status;  // kSolved, kInfeasible: no force is possible, kStalled: gave up early,
                      // kUnbounded: every wrench can be made, bounds are infinite
  double lower;       // [N]: the radius is in [lower, upper], each to within `residual` times 1 N
  double upper;       // and the largest wrench that was met
  ScaledWrench worst_load;  // unit: the load withstood least (6)
  int programs;             // cone programmes solved
  double residual;          // the largest of them: of their KKT conditions, computed anew [1]
};

/// epsilon = min over |u| = 1 of h(u), h the support function of the set, a cone programme for
/// each direction, whose multipliers bound it from above. Points found by the programmes span a
/// hull inside the set, whose nearest facet bounds it from below and is the next direction to ask:
/// see epsilon(). Zero or negative: some load is not withstood, however small. Infinite:
/// is_unlimited().
/// @throws InputError if a setting is not positive
/// Source: [Krug2017] for wrench sets bounded by actuators.
InscribedBall inscribed_ball(const ForceSet& forces, const BallOptions& options = {});

/// Whether forces bear every load along the first axes of a wrench, however large: their recession
/// cone, all limits at zero, holds both ways along each.
[[nodiscard]] bool is_unlimited(ForceSet forces, int axes);

}  // namespace thenar
