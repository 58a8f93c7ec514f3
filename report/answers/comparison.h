#pragma once

/// Words of a comparison of hands.

#include <string>
#include <vector>

#include "grasp/compare/comparison.h"

namespace thenar {

/// A line for each version of the human hand that is compared: what it adds to
/// the one before.
[[nodiscard]] std::vector<std::string> version_lines(const Comparison& comparison);

/// Whether opposition is Kapandji's score of a human thumb; else it is the share of tips that a
/// thumb meets, times 10.
[[nodiscard]] bool is_kapandji(const HandAbilities& abilities);

/// By which rule the loads of several grasps become one number.
[[nodiscard]] std::string load_rule();

/// "epsilon 3 of 12, hold-weight 1 of 3: the programme did not converge": of how many grasps a load
/// is not known, and why, by the first that tells; "all: .." if none is; "" if all are.
[[nodiscard]] std::string unknown_words(const HandOnObject& cell,
                                        const std::vector<std::string>& tasks);

/// "12 missed, 5 touched without force closure": how the approaches ended, the most frequent first.
[[nodiscard]] std::string outcome_words(const HandOnObject& cell);

/// A number as well as it is known: to the place of the first digit of its error.
[[nodiscard]] double rounded_to(double value, double error);

/// A number of which only two digits mean anything.
[[nodiscard]] double in_two_digits(double value);

/// What the numbers mean, and with which settings they came about.
[[nodiscard]] std::string reading_words(const Comparison& comparison);

}  // namespace thenar
