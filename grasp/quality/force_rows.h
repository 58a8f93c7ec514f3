#pragma once

/// How sets of forces grow: rows of limits, columns of variables.

#include "grasp/quality/force_set.h"

namespace thenar::internal {

/// Adds rows  rows y <= most,  each a cone of its own.
void add_rows(ForceSet& forces, const Eigen::MatrixXd& rows, const Eigen::VectorXd& most);

/// Appends variables that nothing sees yet.
void widen(ForceSet& forces, Eigen::Index by);

}  // namespace thenar::internal
