#pragma once

/// Nails as bodies of their own, cut out of the skin of fingertips.

#include "geometry/triangle_mesh.h"
#include "hand/skin/skin_landmarks.h"

namespace thenar {

/// How far a nail stands out of the skin: drawn so, thinner than it is, as its root is in the skin
/// [m].
inline constexpr double kNailHeight = 3e-4;

/// The part of a fingertip's skin that lies on a nail, raised along its normals, with a rim down to
/// the skin. Triangles that the oval cuts are cut at its line, so that the outline is smooth.
/// @param skin   of the link that has the nail, the patch's frame [m]
/// @param patch  of PatchKind::kNail
/// @return  empty where no triangle lies on the patch
[[nodiscard]] TriangleMesh nail_mesh(const TriangleMesh& skin, const SkinPatch& patch);

}  // namespace thenar
