#pragma once

/// Search for a force on a pad by depths.

#include <functional>

#include "pads/press_step.h"

namespace thenar {

/// One step of a press: press_step() of a body, a surface and an object.
using PressStepper = std::function<PressOutcome(const PressGoal& goal, PressState& state)>;

/// Reaches the force of a goal where Newton's method alone fails. The object moves by depths,
/// deeper or back, even to before the touch, until two depths bracket the force. The bracket then
/// shrinks until Newton's method converges from one of its ends. Each trial starts from the history
/// of `state`, so the solution is that of one step.
/// @param goal        goal with a force
/// @param first_step  first step in depth, which adapts to success and failure [m]
/// @param state       new state on kSolved, otherwise unchanged
/// @return outcome of the last trial with the iterations of all trials
[[nodiscard]] PressOutcome seek_force(const PressStepper& step, const PressGoal& goal,
                                      double first_step, PressState& state);

}  // namespace thenar
