#pragma once

/// Solves a step of a press by Newton's method on the augmented Lagrangian.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step whose contacts are as stiff as their augmentation; forces become what each
/// iteration predicts. An iteration leaves a share of what was left, so a tangent that does as well
/// is kept.
[[nodiscard]] PressOutcome press_by_newton(PressIterate& at);

}  // namespace thenar
