#pragma once

/// Files that data files name.

#include <string>

#include "data/io/toml_table.h"

namespace thenar {

/// Returns the path of the file that a key of a table names.
/// @param name    what the key says;  @param folder  that it is relative to
/// @param kind    what it is to be, for the message: "mesh"
/// @throws DataError at the key, if linked_path() refuses the name or no file is there.
[[nodiscard]] std::string linked_file(const TomlTable& table, const std::string& key,
                                      const std::string& name, const std::string& folder,
                                      const std::string& kind = "file");

}  // namespace thenar
