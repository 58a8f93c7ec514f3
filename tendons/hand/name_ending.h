#pragma once

/// Kinds of joints by the endings of their names: "_AA" abducts, "_PS" pronates.

#include <string>

namespace thenar {

[[nodiscard]] inline bool ends_with(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace thenar
