#pragma once

#include <string>

namespace thenar {

/// Writes a text file so that nothing half-written is ever left: first `path + ".tmp"`, renamed
/// when complete. Missing folders are made.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

}  // namespace thenar
