#pragma once

/// Solves a step of a press where edges of the object lie over the skin, by springs on the skin.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step by Newton's method with springs on the skin (SkinSprings). Without friction the
/// forces derive from a potential, and a line search shortens steps until it decreases.
[[nodiscard]] PressOutcome press_by_springs(PressIterate& iterate);

/// Returns the slope of the object's wrench by its motion at a state that press_by_springs() found:
/// the forces turn with the object, and the tissue resists.
/// @param iterate  with the tangent of the tissue at the state
/// @return moment and rotation first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> spring_press_stiffness(PressIterate& iterate);

}  // namespace thenar
