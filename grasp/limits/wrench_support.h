#pragma once

/// Support of a force set: its extreme wrench, or its maximum load, in one direction, by a cone
/// program.

#include "base/numbers.h"
#include "grasp/limits/force_set.h"

namespace thenar {

/// Extreme wrench of a force set in one direction, with the contact forces that produce it.
struct [[nodiscard]] WrenchSupport {
  Status status = Status::kStalled;  // status of the program, which decides on the members below
  double value = kNaN;               // infinite if unbounded, NaN if infeasible or stalled
  double bound = 0;      // upper bound by the multipliers, >= value; equals value unless solved
  ScaledWrench wrench;   // at the extreme point; zero unless solved
  ContactForces forces;  // contact forces that produce this wrench
  double residual = 0;   // largest of the KKT conditions [1]
};

/// Computes the support function of the wrenches of a force set:  h(u) = max u' w.
/// @param u  direction, not zero (6)
/// @throws InputError if u is zero or not finite.
WrenchSupport wrench_support(const ForceSet& forces, const ScaledWrench& u);

/// Computes the load margin: the maximum k for which the forces balance the disturbance k d, W y =
/// -k d, with resistible_part() of it.
///
/// Without limits on forces k is zero or infinite. A load above 1e4 times the largest limit counts
/// as unlimited: rigid structure supports it except for the rounding errors of its normals.
/// @param d  disturbance at k = 1 (6)
/// @throws InputError if d is zero or not finite.
WrenchSupport load_margin(const ForceSet& forces, const ScaledWrench& d);

/// Computes the maximum k for which  rows w = start + k direction  for a wrench w of the set: the
/// extent of a projection or a slice of the set, from a point in a direction.
/// @param rows   projection of wrenches  (r, 6)
/// @param start  r;  @param direction  r, not zero
/// @throws InputError if shapes disagree or anything is not finite.
WrenchSupport support_along(const ForceSet& forces, const Eigen::MatrixXd& rows,
                            const Eigen::VectorXd& start, const Eigen::VectorXd& direction);

}  // namespace thenar
