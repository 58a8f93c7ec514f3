#pragma once

/// Worlds whose hands and objects may be given by name.

#include <string>
#include <vector>

#include "data/io/world/world.h"

namespace thenar {

/// Reads a world, as the functions of the same names without places. A `file` without a folder and
/// an ending that is not there is one of a place: "parallel_jaw" is PLACE/robots/parallel_jaw.toml
/// or PLACE/subjects/parallel_jaw.toml, "mug" is PLACE/objects/mug.toml.
/// @param places  in the order of search
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] WorldSpec read_world(const std::string& path, const std::vector<std::string>& places);
[[nodiscard]] WorldSpec parse_world(const std::string& text, const std::string& path,
                                    const std::vector<std::string>& places);

}  // namespace thenar
