#pragma once

/// Moment arms as a page: the tendons in space, arms and lengths over the joints that vary.

#include "api/moment_arms.h"
#include "report/json.h"

namespace thenar {

/// The whole page.
[[nodiscard]] Json page_of(const MomentArmAnswer& answer);

}  // namespace thenar
