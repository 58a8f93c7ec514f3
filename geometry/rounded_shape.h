#pragma once

/// Solids with a rounding radius.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// Builds the solid of all points within `radius` of a core:  distance(p) = distance of the core(p)
/// - radius.  Edges and corners of the core become parts of cylinders and balls. Deeper inside than
/// the radius the distance is a lower bound of the depth, as that of the core's faces moved out.
/// @param core    not null
/// @param radius  >= 0 [m]
/// @throws InputError if they are not.
[[nodiscard]] std::shared_ptr<const Shape> build_rounded(std::shared_ptr<const Shape> core,
                                                         double radius);

}  // namespace thenar
