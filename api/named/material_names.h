#pragma once

/// Tables of materials by file, and checks of material names.

#include <string>
#include <vector>

#include "api/named/hands.h"
#include "data/io/world/materials.h"

namespace thenar {

/// Returns the built-in table of materials and friction with the entries of a file. @param file
/// empty: none
/// @throws InputError if it is a file of another kind, DataError where it is wrong.
[[nodiscard]] Materials materials_of_file(const std::string& file);

/// Returns a sentence for each name that the table lacks: "hand.toml:7: no material 'plastc', did
/// you mean 'plastic'?". The line is the first that contains the name in quotes.
/// @param file  that uses the names; @param used  names, "" for none
[[nodiscard]] std::vector<std::string> unknown_materials(const std::string& file,
                                                         const std::vector<std::string>& used,
                                                         const Materials& table);

/// Checks that the table has the materials of all links of a hand.
/// @throws InputError with the first sentence of unknown_materials().
void require_materials(const NamedHand& hand, const Materials& table);

}  // namespace thenar
