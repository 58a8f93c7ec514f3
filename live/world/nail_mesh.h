#pragma once

/// Fingernails as separate bodies, cut out of the skin of fingertips.

#include "geometry/triangle_mesh.h"
#include "hand/skin/skin_landmarks.h"

namespace thenar {

/// Height of a drawn nail above the skin; a real nail is thicker, but partly lies in the skin [m].
inline constexpr double kNailHeight = 3e-4;

/// Builds the mesh of a nail: the part of the skin on the patch, raised along its normals, with a
/// rim down to the skin. Triangles across the outline of the patch are cut along it, so that the
/// outline is smooth.
/// @param skin   skin of the link that has the nail, in the patch's frame [m]
/// @param patch  patch of PatchKind::kNail
/// @return empty if no triangle lies on the patch
[[nodiscard]] TriangleMesh nail_mesh(const TriangleMesh& skin, const SkinPatch& patch);

}  // namespace thenar
