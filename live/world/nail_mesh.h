#pragma once

/// Nails as bodies of their own, cut out of the skin of fingertips.

#include "geometry/triangle_mesh.h"
#include "hand/skin/skin_landmarks.h"

namespace thenar {

/// Height of a drawn nail over the skin; it is thinner than a real nail, whose root is in the skin
/// [m].
inline constexpr double kNailHeight = 3e-4;

/// The part of a fingertip's skin that lies on a nail, raised along its normals, with a rim down to
/// the skin. Triangles that the oval cuts are cut at its line, so that the outline is smooth.
/// @param skin   of the link that has the nail, the patch's frame [m]
/// @param patch  of PatchKind::kNail
/// @return  empty where no triangle lies on the patch
[[nodiscard]] TriangleMesh nail_mesh(const TriangleMesh& skin, const SkinPatch& patch);

}  // namespace thenar
