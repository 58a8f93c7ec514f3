#pragma once

/// Where a chain stands, and what the target says there: what swaps of tempering hand on.

#include <vector>

#include "sampling/target.h"

namespace thenar::internal {

struct Place {
  Eigen::VectorXd x;
  Densities at;  // of this one point
};

/// Appends position, log prior, log likelihood, and gradients if there are any.
void put_place(const Place& place, std::vector<double>& to);

/// Takes one out again. @param from  where it begins; afterwards, where the next one does
[[nodiscard]] Place take_place(const double*& from, Eigen::Index size, WithGradient gradient);

}  // namespace thenar::internal
