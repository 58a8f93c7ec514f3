#pragma once

/// Command that wrote a result, in words.

#include <string>

#include "api/named/recorded_run.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with the command line, then folder, date, commit and changed inputs.
[[nodiscard]] std::string text_of(const RecordedRun& recorded);
[[nodiscard]] Fields fields_of(const RecordedRun& recorded);

}  // namespace thenar
