#pragma once

/// Recovery of a thumb from simulated forces and muscle activity.

#include <cstddef>
#include <string>

#include "report/blocks.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the section about the recovery of a thumb: the simulated data, and the values found by
/// least squares and chains beside the truth: axes, every tilt and shift with its 95 % interval,
/// the agreement of both methods, undetermined numbers, and the axes in space.
[[nodiscard]] Json thumb_recovery_section(const ThumbRecovery& recovery);

/// Count of simulated numbers: three force components of each trial and each task, and an
/// activation of each measured muscle of a task [1].
struct MadeUpNumbers {
  std::size_t forces = 0, activations = 0;
};
[[nodiscard]] MadeUpNumbers made_up_numbers(const ThumbRecovery& of);

/// Returns sentences on methods that did not converge, each after a space; "" if both did.
[[nodiscard]] std::string recovery_doubts(const ThumbRecovery& recovery);

/// Smallest and largest ratio of the draws' sd of an axis to its prior sd [1].
struct KeptAxes {
  double least, most;
};
[[nodiscard]] KeptAxes kept_axes(const ThumbRecovery& recovery);

/// Returns a parameter of an axis in words: "CMC1_AA tilt 2" for "axis/CMC1_AA/direction/2", "IP1
/// shift 1" for "axis/IP1/point/1".
[[nodiscard]] std::string words_of_axis_parameter(const std::string& name);

}  // namespace thenar
