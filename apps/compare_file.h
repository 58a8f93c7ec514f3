#pragma once

/// Comparisons of hands as JSON, to be read by others and gone on with.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Everything but how long it took; units are in the names. null: not known; "infinite".
[[nodiscard]] nlohmann::ordered_json comparison_json(const Comparison& comparison);

/// A task with the unit of its load: "hold_weights", "pull_N", "turn_Nm"; "force_closure" has none.
[[nodiscard]] std::string load_key(GraspTask task);

/// SHA-256 of everything in a comparison but this checksum itself, which its member "sha256" keeps.
[[nodiscard]] std::string comparison_checksum(const nlohmann::json& file);

/// Cells as comparison_json() writes them, each number held against its range.
/// @param path  only names the file in messages
/// @throws DataError for what is missing or out of range.
[[nodiscard]] std::vector<HandOnObject> parse_cells(const nlohmann::json& list,
                                                    const std::string& path);

/// Cells that an earlier run left in a file; none if there is no such file.
/// @param inputs  that it must have come from, by name: another value is refused by that name
/// @throws DataError, InputError if the file holds something else, or its checksum does not hold or
/// is missing.
[[nodiscard]] std::vector<HandOnObject> read_cells(const std::string& path,
                                                   const nlohmann::ordered_json& inputs);

}  // namespace thenar
