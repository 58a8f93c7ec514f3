#pragma once

/// Files that a question reads or writes: their text, and whether they are of the right kind.

#include <string>
#include <vector>

#include "kinematics_fit/fit.h"

namespace thenar {

/// A data file as text with its path. @throws DataError if it cannot be read.
[[nodiscard]] SourceText read_source(const std::string& path);

/// A sentence if damage of a binary result could not be noticed: files of older versions have no
/// checksum. Empty for all others.
[[nodiscard]] std::vector<std::string> checksum_warnings(const std::string& path);

/// Refuses to write a result over anything that is not a result, and where no file can be made.
/// @throws InputError saying which.
void require_result_path(const std::string& path);

}  // namespace thenar
