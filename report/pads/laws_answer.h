#pragma once

/// Calibrated reduced laws of a pad, as text, fields, a table and a page.

#include <string>

#include "api/pads/calibrate_pad.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with errors of each law, presses with the forces of the laws, and the end of the
/// calibration.
[[nodiscard]] std::string text_of(const PadLaws& found);
/// Returns fields of the calibration, with the constants of the laws.
[[nodiscard]] Fields fields_of(const PadLaws& found);
/// Returns a table with two rows for each law: root mean square and largest error [%]; without rows
/// if there are no laws.
[[nodiscard]] Table table_of(const PadLaws& found);
/// Returns the page of a calibration: its tables, and the force of laws over that of the elements.
/// Defined in laws_page.cpp.
[[nodiscard]] Json page_of(const PadLaws& found);
[[nodiscard]] FileDigests files_of(const PadLaws& found);

/// Returns the title: "index_pad: laws fitted to presses (20), checked on others (12)".
[[nodiscard]] std::string title_of(const PadLaws& found);
/// Returns a line on the calibration: "pressed to 0.5, 1, 1.5, 2 mm; solved; presses 190.2 s,
/// fits 3.1 s".
[[nodiscard]] std::string conditions_of(const PadLaws& found);
/// Returns a table with a row for each press: elements, laws beside them.
[[nodiscard]] Table press_table(const PadLaws& found);
/// Returns the meaning of the columns of table_of(). Lines end with '\n'.
[[nodiscard]] std::string errors_note();

}  // namespace thenar
