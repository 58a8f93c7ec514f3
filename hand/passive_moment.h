#pragma once

/// The passive moment of a joint: what capsule, ligaments and skin do to it without any muscle.

#include "hand/skeleton.h"

namespace thenar {

/// Widths of an end past its rest from where on it goes straight, so that nothing overflows: no
/// joint ranges as far.
inline constexpr double kStraightPast = 12;

/// Passive moment of a coordinate, positive flexes [N m]:
///
///   M = -stiffness (q - rest)  +  sum over its hinges of  ratio m(ratio q + offset - rest),
///   m(x) = -flexing.moment (exp(x / flexing.width) - 1)
///          + extending.moment (exp(-x / extending.width) - 1).
///
/// It is a function of q alone, 0 at rest, and falls everywhere: it stores energy and loses none.
/// Source: [EstekiMansour1996] for the two exponentials, in a form that rests at a stated angle.
[[nodiscard]] double passive_moment(const CoordinateLimits& limits, double q);

/// d passive_moment / dq, never positive [N m/rad].
[[nodiscard]] double passive_moment_slope(const CoordinateLimits& limits, double q);

/// Energy stored, 0 at rest, whose derivative is minus the moment [J].
[[nodiscard]] double passive_energy(const CoordinateLimits& limits, double q);

/// Returns whether a coordinate of the skeleton has a passive moment.
[[nodiscard]] bool has_passive(const Skeleton& skeleton);

}  // namespace thenar
