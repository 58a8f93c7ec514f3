#pragma once

/// A solid and all that is near it.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// All points within `radius` of a solid:  distance(p) = distance of the core(p) - radius.  Edges
/// and corners of the core become parts of cylinders and balls. Deeper inside than the radius the
/// distance is a lower bound of the depth, as that of the core's faces moved out.
/// @param core    not null
/// @param radius  >= 0 [m]
/// @throws InputError otherwise.
[[nodiscard]] std::shared_ptr<const Shape> build_rounded(std::shared_ptr<const Shape> core,
                                                         double radius);

}  // namespace thenar
