#pragma once

/// Force closures of hands over all objects, and the hand that is significantly best.

#include <string>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Number of force closures of a hand on all objects.
struct ClosureCount {
  int closures = 0, approaches = 0;
  /// Returns closures over approaches [1]; 0 without approaches.
  [[nodiscard]] double success_rate() const;
  /// Returns Wilson's interval of the success rate.
  [[nodiscard]] ConfidenceInterval interval() const;
};
/// Counts the force closures of a hand on all objects of a comparison.
[[nodiscard]] ClosureCount count_closures(const Comparison& comparison, const std::string& hand);

/// Returns the hand whose success rate is significantly larger than that of each other hand:
/// Fisher's exact test, two-sided, p < 0.05. Approaches of all objects are pooled and treated as
/// unpaired, although their directions are the same for all hands: both make the test conservative.
/// Returns "" if there is no such hand, there are fewer than two hands, or the comparison is
/// incomplete, as rates on different objects cannot be compared.
[[nodiscard]] std::string hand_of_most_closures(const Comparison& comparison);

}  // namespace thenar
