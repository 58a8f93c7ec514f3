#pragma once

/// The page of types of thumbs.

#include "api/study.h"
#include "report/json.h"

namespace thenar {

/// Shares of the types, their Denavit-Hartenberg parameters, and the distribution drawn from.
[[nodiscard]] Json page_of(const ThumbTypesResult& result);

}  // namespace thenar
