#pragma once

/// The skin of a digit as a layer of a 3D picture, seen through, with its nail.

#include "data/io/subject.h"
#include "report/picture/mesh_table.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// A digit whose skin is drawn.
struct SkinnedDigit {
  const Subject& subject;       // subject that the skin belongs to
  const TendonDigit& tendons;   // the digit before a fit: where its segments are
  const TreeState<double>& at;  // state of its links in the picture
};

/// Returns a mesh for each segment of the digit that has flesh, translucent, so that bones are seen
/// within it; skin and nail have their own colours.
///
/// Null where the subject has too few bones for a skin, as find_anatomy() has it.
/// @param meshes  gets those that are drawn
[[nodiscard]] Json skin_layer(const SkinnedDigit& digit, MeshTable& meshes);

/// Adds that layer behind the layers of a picture, if there is one.
void add_skin(const SkinnedDigit& digit, MeshTable& meshes, Json& layers);

}  // namespace thenar
