#pragma once

/// Which files parsers of others may open.

#include <string>

namespace thenar {

/// From now on this process opens no file, but by read_one(): parsers, and the libraries below
/// them, find none of the textures, fonts and files that a mesh may name.
void open_nothing();

/// The bytes of a file of at most as many as a mesh may have, also after open_nothing().
/// @throws DataError
[[nodiscard]] std::string read_one(const std::string& path);

/// Whether `file` is a regular file in the folder of `path` or below it, wherever links lead.
[[nodiscard]] bool is_file_beside(const std::string& path, const std::string& file);

}  // namespace thenar
