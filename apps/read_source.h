#pragma once

#include <string>

#include "kinematics_fit/fit.h"

namespace thenar {

/// A data file as text with its path. @throws DataError if it cannot be read.
[[nodiscard]] SourceText read_source(const std::string& path);

}  // namespace thenar
