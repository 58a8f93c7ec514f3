#pragma once

/// Wrenches of a grasp: quality, picture, and quality with other friction.

#include "api/grasp.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns a section with the signed epsilon and its bounds, the weakest or missing direction, and
/// epsilon with less and more friction.
[[nodiscard]] Json quality_section(const GraspResult& result);

/// Returns a section with forces and torques of the wrench set in 3D.
[[nodiscard]] Json wrench_section(const GraspResult& result, MeshTable& meshes);

}  // namespace thenar
