#pragma once

/// How much of a task's loads a grasp withstands.

#include <vector>

#include "grasp/quality/inscribed_ball.h"

namespace thenar {

/// The largest k for which every load of k T is withstood, T the loads of a task.
struct [[nodiscard]] TaskMargin {
  ConeStatus status;  // of the programme that failed, else kSolved
  double lower;       // the true k is in [lower, upper], each to within `residual` of 1 + itself
  double upper;       // infinite where nothing limits the forces
  ScaledWrench worst_load;  // of T, or on its boundary: the first that is not withstood (6)
  double residual;  // the largest of its programmes: of their KKT conditions, computed anew [1]
};

/// T a list of loads: k = min over loads of load_margin(), one programme each, between the forces
/// that it found and the bound of its multipliers. As the wrenches
/// are convex, k T is withstood with all that lies between its loads and zero. No load: k infinite.
/// Source: [Pollard1994] for task wrench sets.
TaskMargin margin_of_loads(const ForceSet& forces, const std::vector<ScaledWrench>& loads);

/// T a box of loads, at most 64 corners: that of the list of its corners.
/// @throws InputError if a lower bound exceeds its upper or is not finite
TaskMargin margin_of_box(const ForceSet& forces, const ScaledWrench& lower,
                         const ScaledWrench& upper);

/// T an ellipsoid of loads about zero, { Q y : |y| <= 1 }. With six axes k is the inscribed ball
/// of Q^-1 W; with fewer, that of the slice of W along Q, found in the product of the slice with a
/// box, which is wider than the slice and changes nothing.
/// @param Q  semi-axes in columns, independent (6, 1..6) [N]
/// @throws InputError if they are not
/// Source: [Li1988].
TaskMargin margin_of_ellipsoid(const ForceSet& forces,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& Q,
                               const BallOptions& options = {});

}  // namespace thenar
