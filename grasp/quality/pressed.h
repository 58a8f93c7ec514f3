#pragma once

/// No squeeze without effort: what limits the forces of contacts that stops and structure bear.

#include "grasp/quality/carried.h"
#include "grasp/quality/force_set.h"

namespace thenar::internal {

/// Adds variables s and the limits of hand_forces() on what stops and structure push back.
/// @param forces  of (x, p, v, r), torques in balance
[[nodiscard]] ForceSet limit_pressing(ForceSet forces, const Felt& felt,
                                      const Actuation& actuation);

}  // namespace thenar::internal
