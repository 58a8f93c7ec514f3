#pragma once

/// A digit in motion: its angles, tensions and energy over time, and itself at some instants.

#include "report/blocks.h"
#include "tendons/muscle/simulate.h"

namespace thenar {

/// Sections of a report. @param tendons  what was simulated
[[nodiscard]] Json motion_page(const DigitTendons& tendons, const Trajectory& trajectory);

}  // namespace thenar
