#pragma once

#include <string>
#include <vector>

namespace thenar {

/// Names of links, joints or degrees of freedom, in their order.
template <typename Part>
std::vector<std::string> names(const std::vector<Part>& parts) {
  std::vector<std::string> list;
  for (const Part& part : parts) list.push_back(part.name);
  return list;
}

}  // namespace thenar
