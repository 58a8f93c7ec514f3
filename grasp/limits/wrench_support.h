#pragma once

/// How far the wrenches of a force set reach: the questions that one cone programme answers.

#include "grasp/limits/force_set.h"

namespace thenar {

/// The end of a way through a wrench set.
struct [[nodiscard]] WrenchSupport {
  ConeStatus status;     // read this first
  double value;          // infinite where unbounded, NaN where infeasible or stalled
  double bound;          // from above, by the multipliers: >= value; like value unless solved
  ScaledWrench wrench;   // made there, zero unless solved (6)
  ContactForces forces;  // that make it
  double residual;       // of the KKT conditions [1]
};

/// Support function of the wrenches that forces make:  h(u) = max u' w.
/// @param u  direction, not zero (6)
/// @throws InputError if u is zero or not finite.
WrenchSupport wrench_support(const ForceSet& forces, const ScaledWrench& u);

/// Largest k for which the forces balance the disturbance k d:  W y = -k d.
///
/// Without limits on forces k is zero or infinite. A load of more than 1e4 times the largest limit
/// is one without limit: structure bears it but for the rounding of its normals.
/// @param d  disturbance at k = 1 (6)
/// @throws InputError if d is zero or not finite.
WrenchSupport load_margin(const ForceSet& forces, const ScaledWrench& d);

/// Largest k for which  rows w = start + k way  for a wrench w of the set: how far a
/// projection or a slice of it reaches from a point.
/// @param rows   what is seen of a wrench  (r, 6)
/// @param start  r;  @param way  r, not zero
/// @throws InputError if shapes disagree or anything is not finite.
WrenchSupport support_along(const ForceSet& forces, const Eigen::MatrixXd& rows,
                            const Eigen::VectorXd& start, const Eigen::VectorXd& way);

}  // namespace thenar
