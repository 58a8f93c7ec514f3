#pragma once

/// Task margin: the factor by which a grasp resists the loads of a task.

#include <vector>

#include "grasp/quality/inscribed_ball.h"

namespace thenar {

/// Maximum k for which the grasp resists every load of k T, T the loads of a task.
struct [[nodiscard]] TaskMargin {
  Status status = Status::kStalled;  // of the program that failed, otherwise kSolved
  double lower = 0;                  // lower bound of k, within `residual` of 1 + itself [1]
  double upper = 0;  // upper bound of k, within the same; infinite if the forces are unlimited [1]
  ScaledWrench worst_load;  // load of T or on its boundary that is the first not to be resisted (6)
  double residual = 0;      // largest of the recomputed KKT conditions of its programs [1]
};

/// Computes the margin of a list of loads T: k = min over loads of load_margin(), one program each,
/// between the forces found and the bound of the multipliers. As the wrenches are convex, the grasp
/// resists k T with all loads between these and zero. Without loads k is infinite.
/// Source: [Pollard1994] for task wrench sets.
TaskMargin margin_of_loads(const ForceSet& forces, const std::vector<ScaledWrench>& loads);

/// Computes the margin of a box of loads as that of the list of its corners, at most 64.
/// @throws InputError if a lower bound exceeds its upper or is not finite
TaskMargin margin_of_box(const ForceSet& forces, const ScaledWrench& lower,
                         const ScaledWrench& upper);

/// Computes the margin of an ellipsoid of loads about zero, { Q y : |y| <= 1 }. With six axes k is
/// the radius of the inscribed ball of Q^-1 W. With fewer it is that of the slice of W along Q,
/// computed in the product of the slice with a wider box, which does not change the result.
/// @param Q  semi-axes in columns, independent (6, 1..6) [N]
/// @throws InputError if they are dependent
/// Source: [Li1988].
TaskMargin margin_of_ellipsoid(const ForceSet& forces,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& Q,
                               const BallOptions& options = {});

}  // namespace thenar
