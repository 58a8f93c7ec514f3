#pragma once

/// A comparison of hands as words, fields and a table.

#include <string>
#include <vector>

#include "api/compare.h"
#include "report/fields.h"

namespace thenar {

/// Returns the comparison as text: grasps of the objects by each hand, outcomes of approaches where
/// nothing closed, abilities of hands without an object, and warnings. Loads follow the same rule
/// as on the page.
[[nodiscard]] std::string text_of(const CompareResult& result);

/// Returns fields: members as docs/data_format.md has them; null: not known; "infinite".
/// most_closures: the hand that has more than each other beyond chance, null if none.
[[nodiscard]] Fields fields_of(const CompareResult& result);

/// Returns a table with a row for each hand on each object.
[[nodiscard]] Table table_of(const CompareResult& result);

/// Returns a line for each version of the human hand that is compared: what it adds to
/// the one before.
[[nodiscard]] std::vector<std::string> version_lines(const Comparison& comparison);

/// Returns the rule by which the loads of several grasps become one number.
[[nodiscard]] std::string load_rule();

/// Returns "epsilon 3 of 12, hold-weight 1 of 3: the programme did not converge": of how many
/// grasps a load is not known, and why, by the first that tells; "all: .." if none is; "" if all
/// are.
[[nodiscard]] std::string unknown_words(const HandOnObject& cell,
                                        const std::vector<std::string>& tasks);

/// Returns "12 missed, 5 touched without force closure": how the approaches ended, the most
/// frequent first.
[[nodiscard]] std::string outcome_words(const HandOnObject& cell);

/// Returns a number as well as it is known: to the place of the first digit of its error.
[[nodiscard]] double rounded_to(double value, double error);

/// Returns a number of which only two digits mean anything.
[[nodiscard]] double in_two_digits(double value);

/// Returns an explanation of the numbers, with the settings of the comparison.
[[nodiscard]] std::string reading_words(const Comparison& comparison);

}  // namespace thenar
