#pragma once

/// A force on a pad, sought by depths.

#include <functional>

#include "pads/press_step.h"

namespace thenar {

/// One step of a press: press_step() of a body, a surface and an object.
using PressStepper = std::function<PressOutcome(const PressGoal& goal, PressState& state)>;

/// Reaches the force of a goal where Newton's method does not by itself: the object goes deeper, or
/// back, also to before where it touched, by depths until they enclose the force, and these come
/// nearer and nearer until Newton's method ends it. Each trial has the past of `state`, so the
/// answer is that of one step.
/// @param goal   with a force
/// @param first  of the ways between depths [m], which become longer and shorter as they must
/// @param state  on kSolved the new state, otherwise as it was
/// @return of the last trial, its iterations those of all
[[nodiscard]] PressOutcome seek_force(const PressStepper& step, const PressGoal& goal, double first,
                                      PressState& state);

}  // namespace thenar
