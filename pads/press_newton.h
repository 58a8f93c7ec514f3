#pragma once

/// Solves a step of a press by Newton's method on the augmented Lagrangian.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step with penalty stiffness at the contacts; each iteration predicts the contact forces
/// of the next. An augmentation leaves a share of the residual anyway, so a tangent that converges
/// as fast is reused.
[[nodiscard]] PressOutcome press_by_newton(PressIterate& iterate);

}  // namespace thenar
