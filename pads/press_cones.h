#pragma once

/// Solves a step of a press by exact friction cones.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step by linearizing the body at each iteration and solving for its equilibrium under
/// exact friction cones (ContactCones). The tangent is reused while iterations converge well.
[[nodiscard]] PressOutcome press_by_cones(PressIterate& iterate);

}  // namespace thenar
