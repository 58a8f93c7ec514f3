#pragma once

/// Solves a step of a press where edges lie over the skin, by springs spread over it.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step by Newton's method with springs on the skin (SkinSprings). Without friction forces
/// are slopes of one potential, and a step is shortened until that falls.
[[nodiscard]] PressOutcome press_by_springs(PressIterate& at);

/// Slope of the push at a state that was solved by springs: the object moves, and forces turn with
/// it, while tissue resists.
/// @param at  with the tangent of tissue there
/// @return moment and turn first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> spring_press_stiffness(PressIterate& at);

}  // namespace thenar
