#pragma once

/// A thumb found again from made-up forces and muscle activity.

#include <cstddef>
#include <string>

#include "report/blocks.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the section about the recovery of a thumb: the made-up data, and the values found by
/// least squares and chains beside the truth: axes, every tilt and shift with its 95 % interval,
/// the agreement of both methods, what could not be told, and the axes in space.
[[nodiscard]] Json thumb_recovery_section(const ThumbRecovery& recovery);

/// Numbers that were made up: three components of the force of each trial and each task, and an
/// activation of each muscle that a task read [1].
struct MadeUpNumbers {
  std::size_t forces = 0, activations = 0;
};
[[nodiscard]] MadeUpNumbers made_up_numbers(const ThumbRecovery& of);

/// Returns sentences on what did not converge, each after a space; "" if both methods did.
[[nodiscard]] std::string recovery_doubts(const ThumbRecovery& recovery);

/// Shares of the prior's sd that made-up data leave of an axis, by the draws: least and most [1].
struct KeptAxes {
  double least, most;
};
[[nodiscard]] KeptAxes kept_axes(const ThumbRecovery& recovery);

/// Returns "CMC1_AA tilt 2" of "axis/CMC1_AA/direction/2", "IP1 shift 1" of "axis/IP1/point/1".
[[nodiscard]] std::string words_of_axis_parameter(const std::string& name);

}  // namespace thenar
