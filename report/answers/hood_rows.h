#pragma once

/// Errors of the extensor hood's rows, muscle by muscle: a fit with a net compared with the same
/// fit with fractions.

#include <string>

#include "api/fit.h"
#include "report/fields.h"

namespace thenar {

/// Returns a table with a row for each experiment and way of predicting: relative errors of all
/// trials of the hood's muscles, then of each muscle alone, with the net and with fractions.
/// Without rows if nothing was left out, or the digit has no hood.
[[nodiscard]] Table hood_row_table(const FitResult& result);

/// Returns hood_row_table() as lines of text, with the count of free numbers; "" without rows.
[[nodiscard]] std::string hood_row_text(const FitResult& result);

/// Returns the numbers of free and of determined coordinates of a fit: "fixed fractions: 519
/// coordinates move, 23 of them of the hood; the data determine 76.0 parameters, 3.8 of them of the
/// hood".
[[nodiscard]] std::string hood_count_words(const Fit& fit);

/// Returns hood_row_table() complete and with unrounded numbers; no fields without rows.
[[nodiscard]] Fields hood_row_fields(const FitResult& result);

}  // namespace thenar
