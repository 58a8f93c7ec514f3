#pragma once

/// Where descriptions of nets come from.

#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "kinematics_fit/fit.h"

namespace thenar {

/// "chao_an", "dogadov2017", "winslow": nets that the program carries along.
[[nodiscard]] std::vector<std::string> known_nets();

/// Its text by one of these names, or by the path of its file; that path is returned with it, or
/// "NAME.toml". @throws InputError listing the names; DataError if the file cannot be read.
[[nodiscard]] SourceText net_source(const std::string& name_or_path);

/// A net by the same. @throws as well DataError if the file is wrong.
[[nodiscard]] NetDescription find_net(const std::string& name_or_path);

/// The net that --hood and --net, empty where not given, mean together: a named net means a hood
/// that is a net; such a hood alone means "winslow". Empty: the hood is no net.
/// @throws InputError if a net is named for a hood that is none.
[[nodiscard]] std::string net_meant(const std::string& hood, const std::string& net);

}  // namespace thenar
