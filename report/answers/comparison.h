#pragma once

/// Comparison of hands as text, fields and a table.

#include <string>
#include <vector>

#include "api/compare.h"
#include "report/fields.h"

namespace thenar {

/// Returns the comparison as text: grasps of the objects by each hand, outcomes of approaches where
/// nothing closed, abilities of hands without an object, and warnings. Loads follow the same rule
/// as on the page.
[[nodiscard]] std::string text_of(const CompareResult& result);

/// Returns the fields described in docs/data_format.md; null: not known; "infinite". most_closures:
/// the hand with significantly more closures than every other, null if none.
[[nodiscard]] Fields fields_of(const CompareResult& result);

/// Returns a table with a row for each hand on each object.
[[nodiscard]] Table table_of(const CompareResult& result);

/// Returns a line for each compared version of the human hand: its additions to the previous
/// version.
[[nodiscard]] std::vector<std::string> version_lines(const Comparison& comparison);

/// Returns a sentence on how the loads of several grasps are combined to one number.
[[nodiscard]] std::string load_rule();

/// Returns the number of grasps whose loads are unknown, with the first reason: "epsilon 3 of 12,
/// hold-weight 1 of 3: the programme did not converge"; "all: .." if none is known; "" if all are.
[[nodiscard]] std::string unknown_words(const HandOnObject& cell,
                                        const std::vector<std::string>& tasks);

/// Returns the outcomes of the approaches, the most frequent first: "12 missed, 5 touched without
/// force closure".
[[nodiscard]] std::string describe_outcome(const HandOnObject& cell);

/// Returns a number rounded to the first significant digit of its error.
[[nodiscard]] double rounded_to(double value, double error);

/// Returns a number rounded to two significant digits.
[[nodiscard]] double in_two_digits(double value);

/// Returns a text that explains the numbers, with the settings of the comparison.
[[nodiscard]] std::string reading_words(const Comparison& comparison);

}  // namespace thenar
