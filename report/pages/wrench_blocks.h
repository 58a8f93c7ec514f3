#pragma once

/// The wrenches of a grasp: how good, drawn, and with other friction.

#include "api/grasp.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns the signed epsilon with its bounds, the wrench withstood least or the direction that is
/// missing, and epsilon with less and more friction.
[[nodiscard]] Json quality_section(const GraspResult& result);

/// Returns forces and torques of the wrench set in 3D.
[[nodiscard]] Json wrench_section(const GraspResult& result, MeshTable& meshes);

}  // namespace thenar
