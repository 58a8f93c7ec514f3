#pragma once

/// Balance of a digit whose load ends within the hand, as in a pinch.

#include <vector>

#include "tendons/forces/posture_sensitivity.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// The statics of a hand that pinches. What the thumb does to the held thing, the fingers do the
/// other way round, so that joints nearer to the forearm feel no load and must balance tendons
/// alone:
///
///   (J' f + W' m)_j = (R' t + tau_0)_j   at the digit's own joints,
///                 0 = (R' t + tau_0)_j   at `joints`.
///
/// Columns of J and W are zero there. The tendons of the fingers that press back cross the wrist
/// too; whoever asks says whether they are among `statics`.
///
/// @param joints  coordinates of the wrist
/// @throws InputError if there is no such coordinate.
[[nodiscard]] TipStatics without_load_on(TipStatics statics, const std::vector<int>& joints);

/// Derivatives of the same. As a load within the hand turns with the hand, nothing of J and W
/// changes as one of `joints` turns.
[[nodiscard]] std::vector<StaticsDerivative> without_load_on(std::vector<StaticsDerivative> slopes,
                                                             const std::vector<int>& joints);

}  // namespace thenar
