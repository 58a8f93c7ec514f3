#pragma once

/// Geoms of MJCF: shapes and what they weigh.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/io/robot/mjcf_source.h"
#include "geometry/shape_mass.h"
#include "geometry/shape_spec.h"

namespace thenar::internal {

struct MjcfGeom {
  std::optional<ShapeSpec> shape;  // none: a plane, or a mesh that is missing
  bool collides = true;
  MassProperties mass;
};

/// The meshes of <asset>, by name.
using MjcfMeshes = std::map<std::string, pugi::xml_node>;
[[nodiscard]] MjcfMeshes find_meshes(const MjcfSource& source);

/// Settings of contact that a material does not tell (friction, condim, solref ..) are noted.
/// @param X_BF       frame that the geom is given in
/// @param warnings   gets what is missing
/// @throws DataError
[[nodiscard]] MjcfGeom read_geom(const MjcfSource& source, const MjcfMeshes& meshes,
                                 const pugi::xml_node& node, const std::string& childclass,
                                 const Pose<double>& X_BF, const std::string& body,
                                 std::vector<std::string>& warnings);

}  // namespace thenar::internal
