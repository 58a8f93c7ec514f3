#pragma once

/// A live picture as glTF 2.0, with its buffer inside.
/// Source: glTF 2.0 Specification, Khronos Group, registry.khronos.org/glTF.

#include <string>

#include "live/live_picture.h"

namespace thenar {

/// Bodies with meshes, and lines as strips, at an instant. A root turns z up into y up, as glTF has
/// it; lengths are in m, angles none. Joints, contacts and arrows are left out.
/// @throws InputError if the buffers exceed 1 GB.
[[nodiscard]] std::string gltf_text(const LiveShape& shape, const LiveInstant& instant);

}  // namespace thenar
