#pragma once

/// Links of GraspIt! robots, as their XML describes them; meshes are not read.

#include <optional>
#include <string>
#include <vector>

#include "base/spatial.h"

namespace thenar {

/// A link; parts may be missing. Lengths are in m, whatever the file has.
struct GraspitLink {
  std::string geometry_file;               // path beside the body; empty: none
  double geometry_scale = 1e-3;            // [m] per unit of that file
  Pose<double> X_LG;                       // pose of the scaled geometry in the link
  std::string material;                    // empty: not stated
  double mass = 0;                         // [kg]; 0: not stated
  Eigen::Vector3d com{0, 0, 0};            // [m] (3)
  std::optional<Eigen::Matrix3d> inertia;  // inertia about com [kg m^2] (3, 3)
  std::vector<std::string> warnings;       // elements that were not understood
};

/// Reads <geometryFile> (with `Units` mm, cm, m or in, and `scale`), <geometryScaling>,
/// <geometryOffset> (three lengths in mm, or a <transform>), <material>, <mass> (g), <cog> (mm)
/// and <inertia_matrix> (mm^2, per mass). An inertia that is not nine numbers, or has no mass, is
/// left out with a warning. A mesh file itself is a body that is all geometry, in mm.
/// @throws DataError if the file cannot be read, is no XML, or a number is malformed.
/// Source: [GraspIt] for the format.
[[nodiscard]] GraspitLink read_graspit_link(const std::string& path);

}  // namespace thenar
