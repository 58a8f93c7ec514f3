#pragma once

/// The page of types of thumbs.

#include "report/json.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns a page with shares of the types, their Denavit-Hartenberg parameters, and the
/// distribution drawn from.
[[nodiscard]] Json page_of(const ThumbTypesResult& result);

}  // namespace thenar
