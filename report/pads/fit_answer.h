#pragma once

/// Pad fitted to measured presses, as text, fields, a table and a page.

#include <string>

#include "api/pads/fit_pad.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with constants, data beside predictions, correlations, and the end of the search.
[[nodiscard]] std::string text_of(const FittedPad& fitted);
/// Returns fields of the fit, with curves of the fitted pad and the meaning of citation keys.
/// Constants and data state their units.
[[nodiscard]] Fields fields_of(const FittedPad& fitted);
/// Returns a table with a row for each constant.
[[nodiscard]] Table table_of(const FittedPad& fitted);
/// Returns the page of a fit: its tables, force by depth and area by force of the fitted pad with
/// the data on them, and sources. Defined in fit_page.cpp.
[[nodiscard]] Json page_of(const FittedPad& fitted);
[[nodiscard]] FileDigests files_of(const FittedPad& fitted);

/// Returns the title: "index_fitted fitted to flat presses: 2 constants, 3 data".
[[nodiscard]] std::string title_of(const FittedPad& fitted);
/// Returns a line on the search: "search converged after 21 evaluations; misfit 0.77 with 2 degrees
/// of freedom".
[[nodiscard]] std::string conditions_of(const FittedPad& fitted);
/// Returns a table with a row for each datum: measured, predicted, difference in sds, source.
[[nodiscard]] Table data_table(const FittedPad& fitted);
/// Returns a table with a row for each constant; without rows if there is only one, or one is
/// undetermined.
[[nodiscard]] Table correlation_table(const FittedPad& fitted);
/// Returns the meaning of the columns of table_of(). Lines end with '\n'.
[[nodiscard]] std::string constants_note(const FittedPad& fitted);

/// Returns the unit of a measured number; "" for a dimensionless one.
[[nodiscard]] DisplayUnit display_unit(const PressDatum& datum);

}  // namespace thenar
