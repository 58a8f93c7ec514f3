#pragma once

/// Export of a live picture as glTF 2.0 with an embedded buffer.
/// Source: glTF 2.0 Specification, Khronos Group, registry.khronos.org/glTF.

#include <string>

#include "live/live_picture.h"

namespace thenar {

/// Writes bodies with meshes, and lines as line strips, at an instant. A root node rotates z up to
/// the y up of glTF; lengths are in m. Joints, contacts and arrows are left out.
/// @throws InputError if the buffers exceed 1 GB.
[[nodiscard]] std::string gltf_text(const LiveShape& shape, const LiveInstant& instant);

}  // namespace thenar
