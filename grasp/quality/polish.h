#pragma once

/// Directions of least support, to rounding, from directions near them.

#include "grasp/quality/hull_support.h"

namespace thenar::internal {

/// A direction with the least support near u, found by Newton's method on the sphere; u itself if
/// nothing better was met.
///
///   L1:    minimise t with h_i(u) = t of the caps that take part;
///   Linf:  minimise the sum of positive h_i with h_k(u) = 0 of the contacts about to let go.
/// Which ones take part follows from the signs of multipliers and from what overtakes on the way.
/// Steps are split into those along constraints and those within, where the Hessian's negative
/// curvatures are turned about. Caps with A'u about 0, where h has a kink, are held at A'u = 0 in a
/// second attempt.
/// @param u  unit (6)
[[nodiscard]] Wrench polish(const Support& support, const Wrench& u);

}  // namespace thenar::internal
