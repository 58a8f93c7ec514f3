#pragma once

#include <string>

namespace thenar {

/// Writes a text file so that nothing half-written is ever left: first `path + ".tmp"`, renamed
/// when complete. Missing folders are made.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

/// Makes the missing folders of `path`, and checks that a file can be written there: to be called
/// before long work whose result goes to it.
/// @throws InputError if it cannot.
void require_writable(const std::string& path);

}  // namespace thenar
