#pragma once

/// Balance of a digit whose load is internal to the hand, as in a pinch.

#include <vector>

#include "tendons/forces/posture_sensitivity.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Returns the statics of a hand that pinches. The forces of thumb and fingers on the held object
/// are opposite, so that joints nearer to the forearm carry no load and must balance tendons alone:
///
///   (J' f + W' m)_j = (R' t + tau_0)_j   at the digit's own joints,
///                 0 = (R' t + tau_0)_j   at `joints`.
///
/// Columns of J and W are zero there. The tendons of the opposing fingers cross the wrist too; the
/// caller decides whether `statics` includes them.
///
/// @param joints  coordinates of the wrist
/// @throws InputError if there is no such coordinate.
[[nodiscard]] TipStatics without_load_on(TipStatics statics, const std::vector<int>& joints);

/// Returns the derivatives of these statics. Since a load internal to the hand turns with the hand,
/// J and W do not change as one of `joints` turns.
[[nodiscard]] std::vector<StaticsDerivative> without_load_on(std::vector<StaticsDerivative> slopes,
                                                             const std::vector<int>& joints);

}  // namespace thenar
