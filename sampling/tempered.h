#pragma once

/// One density out of prior and likelihood.

#include "sampling/target.h"

namespace thenar::internal {

/// log prior + temper * log likelihood at one point.
struct Tempered {
  double value = 0;     // -inf where the density is zero or broken [1]
  bool broken = false;  // NaN or +inf came, where the prior allows the point
};

/// A likelihood of zero, or one that cannot be computed, makes the density zero at every temper,
/// at 0 too: the hottest chain samples the prior where there is a likelihood at all, so that every
/// place of it could be handed down.
/// @param point  column of `at`
[[nodiscard]] Tempered tempered(const Densities& at, Eigen::Index point, double temper);

}  // namespace thenar::internal
