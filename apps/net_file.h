#pragma once

/// Where descriptions of nets come from.

#include <string>
#include <vector>

#include "data/io/net.h"

namespace thenar {

/// "chao_an", "dogadov2017", "winslow": nets that the program carries along.
[[nodiscard]] std::vector<std::string> known_nets();

/// A net by one of these names, or by the path of its file.
/// @throws InputError listing the names; DataError if the file is wrong.
[[nodiscard]] NetDescription find_net(const std::string& name_or_path);

}  // namespace thenar
