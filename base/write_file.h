#pragma once

#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Writes a file so that nothing half-written is ever left: first a new file of its own beside
/// `path`, renamed when complete. A full disk leaves an older file at `path` as it was, and
/// nothing beside it. Missing folders are made. Where `path` is a symbolic link, what it points to
/// is written, and the link stays.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

/// Writes files that belong together: all are complete on the disk before the first is renamed, so
/// that a full disk leaves none of them. They appear in their order.
/// @param files  path and content of each
/// @throws InputError if one of them cannot be written.
void write_files(const std::vector<std::pair<std::string, std::string>>& files);

/// Makes the missing folders of `path`, and checks that a file can be written there: to be called
/// before long work whose result goes to it. Touches no other file.
/// @throws InputError if it cannot.
void require_writable(const std::string& path);

}  // namespace thenar
