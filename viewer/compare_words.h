#pragma once

/// Words of a comparison of hands.

#include <string>
#include <vector>

#include "grasp/compare/comparison.h"

namespace thenar {

/// A line for each version of the human hand that is compared: what it adds to
/// the one before.
[[nodiscard]] std::vector<std::string> version_lines(const Comparison& comparison);

/// What the numbers mean, and with which settings they came about.
[[nodiscard]] std::string reading_words(const Comparison& comparison);

}  // namespace thenar
