#pragma once

/// The force of a fingertip as a page: in space, in rows, over the joints that vary.

#include "api/tip_force.h"
#include "report/json.h"

namespace thenar {

/// The whole page.
[[nodiscard]] Json page_of(const TipForceAnswer& answer);

}  // namespace thenar
