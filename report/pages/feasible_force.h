#pragma once

/// The largest forces of a fingertip as a page: in space, what limits them, over joints that vary.

#include "api/feasible_force.h"
#include "report/json.h"

namespace thenar {

/// The whole page.
[[nodiscard]] Json page_of(const FeasibleForceAnswer& answer);

}  // namespace thenar
