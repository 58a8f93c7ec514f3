#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The triangles of a VRML 1.0, VRML 2.0 or Inventor file, in single precision, placed by its own
/// transforms; spheres, cones and cylinders tessellated. Where it holds nothing but whole spheres,
/// boxes and cylinders that place_primitive() places, they are its exact shapes as well, with sizes
/// and transforms as they were written (rotations in single precision). To be called once in a
/// program, which opens nothing from then on.
/// @throws DataError if the file is none of these, or broken; or if thenar was built without Coin.
[[nodiscard]] TriangleSoup read_inventor_mesh(const std::string& path);

}  // namespace thenar
