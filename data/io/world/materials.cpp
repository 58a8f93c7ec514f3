#include "data/io/world/materials.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {

const Material& Materials::at(const std::string& name) const {
  std::string names;
  for (const Material& material : materials) {
    if (material.name == name) return material;
    names += (names.empty() ? "" : ", ") + material.name;
  }
  throw InputError(fmt::format("no material '{}'; there are {}", name, names));
}

Friction Materials::between(const std::string& a, const std::string& b) const {
  require(!a.empty() && !b.empty(),
          "no friction between '{}' and '{}': one of these links or bodies has no 'material'", a,
          b);
  const auto found = friction.find(std::minmax(a, b));
  require(found != friction.end(), "no friction between '{}' and '{}'", a, b);
  return found->second;
}

}  // namespace thenar
