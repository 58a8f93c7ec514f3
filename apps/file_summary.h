#pragma once

#include <string>

namespace thenar {

/// Reads a file of any kind, whole, and says in a line what it is and what it holds:
/// "subject 'an_chao_middle': 5 segments, 4 joints, 6 muscles, 1 digit".
/// Subjects are also built, digit by digit, and bodies as solids; fits are set up again from their
/// own inputs.
/// @throws Error with what is wrong.
[[nodiscard]] std::string summarise_file(const std::string& path);

}  // namespace thenar
