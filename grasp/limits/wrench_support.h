#pragma once

/// Support of a force set: its extreme wrench, or its largest load, in one direction (a cone
/// program).

#include "grasp/limits/force_set.h"

namespace thenar {

/// Extreme wrench of a force set in one direction, with the contact forces that make it.
struct [[nodiscard]] WrenchSupport {
  Status status;         // read this first
  double value;          // infinite where unbounded, NaN where infeasible or stalled
  double bound;          // upper bound by the multipliers, >= value; equals value unless solved
  ScaledWrench wrench;   // at the extreme point; zero unless solved
  ContactForces forces;  // that make this wrench
  double residual;       // largest of the KKT conditions [1]
};

/// Support function of the wrenches of a force set:  h(u) = max u' w.
/// @param u  direction, not zero (6)
/// @throws InputError if u is zero or not finite.
WrenchSupport wrench_support(const ForceSet& forces, const ScaledWrench& u);

/// Load margin: the largest k for which the forces balance the disturbance k d,  W y = -k d, of
/// which bearable_part() counts.
///
/// Without limits on forces k is zero or infinite. A load of more than 1e4 times the largest limit
/// counts as unlimited: rigid structure supports it except for the rounding of its normals.
/// @param d  disturbance at k = 1 (6)
/// @throws InputError if d is zero or not finite.
WrenchSupport load_margin(const ForceSet& forces, const ScaledWrench& d);

/// Largest k for which  rows w = start + k direction  for a wrench w of the set: the extent of a
/// projection or a slice of the set, from a point in a direction.
/// @param rows   projection of wrenches  (r, 6)
/// @param start  r;  @param direction  r, not zero
/// @throws InputError if shapes disagree or anything is not finite.
WrenchSupport support_along(const ForceSet& forces, const Eigen::MatrixXd& rows,
                            const Eigen::VectorXd& start, const Eigen::VectorXd& direction);

}  // namespace thenar
