#pragma once

/// Passive moment of a joint: the effect of capsule, ligaments and skin without any muscle.

#include "hand/skeleton.h"

namespace thenar {

/// Distance beyond rest, in widths of the exponential, from which an end continues as a straight
/// line, so that nothing overflows [1]. No joint moves as far.
inline constexpr double kMaxExponent = 12;

/// Computes the passive moment of a coordinate, positive flexes [N m]:
///
///   M = -stiffness (q - rest)  +  sum over its hinges of  ratio m(ratio q + offset - rest),
///   m(x) = -flexing.moment (exp(x / flexing.width) - 1)
///          + extending.moment (exp(-x / extending.width) - 1).
///
/// It is a function of q alone, 0 at rest, and decreases everywhere: it stores energy and
/// dissipates none. Source: [EstekiMansour1996] for the two exponentials, in a form whose rest is a
/// given angle.
[[nodiscard]] double passive_moment(const CoordinateLimits& limits, double q);

/// Computes d passive_moment / dq, never positive [N m/rad].
[[nodiscard]] double passive_moment_slope(const CoordinateLimits& limits, double q);

/// Computes the stored energy, 0 at rest, whose derivative is minus the moment [J].
[[nodiscard]] double passive_energy(const CoordinateLimits& limits, double q);

/// Returns whether a coordinate of the skeleton has a passive moment.
[[nodiscard]] bool has_passive(const Skeleton& skeleton);

}  // namespace thenar
