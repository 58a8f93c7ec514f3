#pragma once

#include <string>

namespace thenar {

/// Writes a file so that nothing half-written is ever left: first a new file of its own beside
/// `path`, renamed when complete. A full disk leaves an older file at `path` as it was, and
/// nothing beside it. Missing folders are made.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

/// Makes the missing folders of `path`, and checks that a file can be written there: to be called
/// before long work whose result goes to it. Touches no other file.
/// @throws InputError if it cannot.
void require_writable(const std::string& path);

}  // namespace thenar
