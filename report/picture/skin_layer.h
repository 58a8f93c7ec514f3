#pragma once

/// Skin of a digit as a translucent layer of a 3D picture, with its nail.

#include "data/io/subject.h"
#include "hand/skin/skin_landmarks.h"
#include "report/picture/mesh_table.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Digit whose skin is drawn.
struct SkinnedDigit {
  const Subject& subject;       // subject that the skin belongs to
  const TendonDigit& tendons;   // digit before a fit, with its segments
  const TreeState<double>& at;  // state of its links in the picture
};

/// Returns a colour for every vertex of the skin of a segment: skin, or nail where its patch is;
/// empty if it has no nail.
[[nodiscard]] std::vector<MeshColor> nail_colors(const TriangleMesh& mesh,
                                                 const std::vector<SkinPatch>& patches,
                                                 const std::string& digit, int link);

/// Returns a layer with a translucent mesh for each segment that has flesh; skin and nail have
/// their own colours.
///
/// Null if the subject has too few bones for a skin, see find_anatomy().
/// @param meshes  receives the meshes of the layer
[[nodiscard]] Json skin_layer(const SkinnedDigit& digit, MeshTable& meshes);

/// Appends skin_layer() to the layers of a picture, unless it is null.
void add_skin(const SkinnedDigit& digit, MeshTable& meshes, Json& layers);

}  // namespace thenar
