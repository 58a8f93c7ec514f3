#include "geometry/shape_spec.h"

namespace thenar {

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names{
      "sphere",          "box",       "cylinder",       "capsule",
      "tapered capsule", "ellipsoid", "superellipsoid", "mesh"};
  return names;
}

std::string name_of(ShapeKind kind) { return shape_names()[static_cast<std::size_t>(kind)]; }

}  // namespace thenar
