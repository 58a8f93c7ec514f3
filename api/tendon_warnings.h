#pragma once

/// Warnings about results of tendon tensions on a digit.

#include <string>
#include <vector>

#include "api/tendon_solve.h"

namespace thenar {

/// Returns the angles of the joints that vary: "PIP3=30 deg".
[[nodiscard]] std::string place_of(const LoadedDigit& loaded, const DigitPoint& point);

/// Returns a warning about the force of a pinned tip; may be empty.
[[nodiscard]] std::string tip_note(const TipForce& tip);

/// Returns warnings about the answer at one posture, or over a grid, one sentence each.
[[nodiscard]] std::vector<std::string> tendon_warnings(const LoadedDigit& loaded,
                                                       const DigitPoint& point);
[[nodiscard]] std::vector<std::string> tendon_warnings(const LoadedDigit& loaded,
                                                       const std::vector<DigitPoint>& points);

}  // namespace thenar
