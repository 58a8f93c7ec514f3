#pragma once

/// Solves a step of a press by exact friction cones.

#include "pads/press_iterate.h"

namespace thenar {

/// Solves a step in iterations that each bring the body, linear at where it is, to rest under exact
/// cones (ContactCones). Its tangent is kept while iterations go on well.
[[nodiscard]] PressOutcome press_by_cones(PressIterate& at);

}  // namespace thenar
