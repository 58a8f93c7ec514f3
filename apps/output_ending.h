#pragma once

/// What kind of file an output is to be, told by its name.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "base/error.h"

namespace thenar {

/// @throws InputError unless `path` is empty or ends in one of `endings`.
inline void require_ending(const std::string& path, const std::vector<std::string>& endings) {
  const std::string ending = std::filesystem::path(path).extension();
  require(path.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end(),
          "wanted an output that ends in {}, got '{}'", fmt::join(endings, " or "), path);
}

}  // namespace thenar
