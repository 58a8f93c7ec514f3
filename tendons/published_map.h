#pragma once

/// The published tip maps of a subject, as statics that any question can be put to.

#include <string>

#include "data/io/subject.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// One of the subject's maps. @param name  empty: the first map of the digit
/// @throws InputError naming the maps there are.
[[nodiscard]] const TipMap& find_tip_map(const Subject& subject, const std::string& digit,
                                         const std::string& name = "");

/// Statics of a map; rows in the order Fx, Fy, Fz, then its moments. See statics_of_map().
/// @throws InputError if the map lacks a force row.
[[nodiscard]] TipStatics map_statics(const Subject& subject, const TipMap& map);

/// Names of the moment rows, in the order of the columns of W of map_statics(): "tx".
[[nodiscard]] std::vector<std::string> moment_rows(const TipMap& map);

}  // namespace thenar
