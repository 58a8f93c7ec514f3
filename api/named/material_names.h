#pragma once

/// Tables of materials by file, and names of materials held to them.

#include <string>
#include <vector>

#include "api/named/hands.h"
#include "data/io/world/materials.h"

namespace thenar {

/// Returns the materials and friction of a file over the built-in table. @param file  empty: that
/// table
/// @throws InputError if it is a file of another kind, DataError where it is wrong.
[[nodiscard]] Materials materials_of_file(const std::string& file);

/// Returns "hand.toml:7: no material 'plastc', did you mean 'plastic'?", a sentence for each name
/// that the table has not; the line is the first that has the name in quotes.
/// @param file  that uses the names; @param used  names, "" for none
[[nodiscard]] std::vector<std::string> unknown_materials(const std::string& file,
                                                         const std::vector<std::string>& used,
                                                         const Materials& table);

/// Refuses a hand one of whose links has a material that the table has not.
/// @throws InputError with the first sentence of unknown_materials().
void require_materials(const NamedHand& hand, const Materials& table);

}  // namespace thenar
