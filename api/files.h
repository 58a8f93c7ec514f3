#pragma once

#include <string>

#include "kinematics_fit/fit.h"

namespace thenar {

/// A data file as text with its path. @throws DataError if it cannot be read.
[[nodiscard]] SourceText read_source(const std::string& path);

/// Says on standard error that damage of a binary result could not be noticed, if it could not:
/// files of older versions have no checksum.
void warn_unchecked(const std::string& path);

/// Refuses to write a result over anything that is not a result, and where no file can be made.
/// @throws InputError saying which.
void require_result_path(const std::string& path);

}  // namespace thenar
