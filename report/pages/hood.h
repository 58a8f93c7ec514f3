#pragma once

#include <vector>

#include "kinematics_fit/hood_comparison.h"
#include "report/pages/tendons.h"

namespace thenar {

/// The extensor mechanism on every rung: the net in space and its slips over a sweep, and the
/// errors of predicted tip forces of every specimen beside the time that a posture takes.
[[nodiscard]] Json hood_page(const TendonSweep& sweep,
                             const std::vector<HoodComparison>& comparisons);

}  // namespace thenar
