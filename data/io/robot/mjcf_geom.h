#pragma once

/// Geoms of MJCF: shapes and what they weigh.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/shapes/shape_spec.h"
#include "data/io/robot/mjcf_source.h"
#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Mass of a body about its own centre.
struct MassOfBody {
  double mass = 0;                                    // [kg]
  Eigen::Vector3d com{0, 0, 0};                       // [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about com [kg m^2] (3, 3)
};

/// Volume, centroid and inertia at density 1 of a shape in the frame of its body.
[[nodiscard]] MassOfBody mass_at_unit_density(const ShapeSpec& shape);

/// Several rigidly together.
[[nodiscard]] MassOfBody together(const std::vector<MassOfBody>& parts);

struct MjcfGeom {
  std::optional<ShapeSpec> shape;  // none: a plane, or a mesh that is missing
  bool collides = true;
  MassOfBody mass;
};

/// The meshes of <asset>, by name.
using MjcfMeshes = std::map<std::string, pugi::xml_node>;
[[nodiscard]] MjcfMeshes find_meshes(const MjcfSource& source);

/// @param X_BF       frame that the geom is given in
/// @param warnings   gets what is missing
/// @throws DataError
[[nodiscard]] MjcfGeom read_geom(const MjcfSource& source, const MjcfMeshes& meshes,
                                 const MjcfElement& geom, const Pose<double>& X_BF,
                                 const std::string& body, std::vector<std::string>& warnings);

}  // namespace thenar::internal
