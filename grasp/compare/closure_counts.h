#pragma once

/// Force closures of hands over all objects, and whether one hand has more beyond chance.

#include <string>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Force closures of a hand on all objects.
struct ClosureCount {
  int closures = 0, approaches = 0;
  [[nodiscard]] double share() const;  // [1]; 0 without approaches
  [[nodiscard]] ConfidenceInterval interval() const;
};
[[nodiscard]] ClosureCount count_closures(const Comparison& comparison, const std::string& hand);

/// The hand whose share of force closures is larger than that of each other hand beyond chance:
/// Fisher's exact test, two-sided, p < 0.05. Approaches of several objects are taken together, and
/// not in pairs though their directions are the same: both make the test strict. "" if there is
/// none, fewer than two hands, or the comparison is not complete: shares of different objects say
/// nothing.
[[nodiscard]] std::string hand_of_most_closures(const Comparison& comparison);

}  // namespace thenar
