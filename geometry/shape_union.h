#pragma once

/// Placement and union of shapes.

#include <memory>
#include <vector>

#include "base/spatial.h"
#include "geometry/shape.h"

namespace thenar {

/// Returns a shape in another frame. @param X_BS  the shape's frame in the new one
[[nodiscard]] std::shared_ptr<const Shape> place(std::shared_ptr<const Shape> shape,
                                                 const Pose<double>& X_BS);

/// Builds the union of at least one shape: the minimum of their distances. Exact outside and on the
/// surface; inside, where parts overlap, the depth is a lower bound (the deepest part counts,
/// though its surface may be inside another). It changes by at most the distance moved everywhere.
[[nodiscard]] std::shared_ptr<const Shape> join(std::vector<std::shared_ptr<const Shape>> parts);

}  // namespace thenar
