#pragma once

/// Placement and union of shapes.

#include <memory>
#include <vector>

#include "base/spatial.h"
#include "geometry/shape.h"

namespace thenar {

/// A shape in another frame. @param X_BS  the shape's frame in the new one
[[nodiscard]] std::shared_ptr<const Shape> place(std::shared_ptr<const Shape> shape,
                                                 const Pose<double>& X_BS);

/// The union of some shapes, at least one: the least of their distances. Exact outside and on the
/// surface; inside, where parts overlap, the depth is a lower bound (the deepest part counts,
/// though its surface may lie within another). It changes by no more than the way gone everywhere.
[[nodiscard]] std::shared_ptr<const Shape> join(std::vector<std::shared_ptr<const Shape>> parts);

// Smooth unions with a fillet.

/// The union of some shapes with a fillet where they meet. Two distances a <= b that differ by less
/// than the blend k give
///   a - (k - (b - a))^2 / (4 k),
/// and a; further ones are blended in from the least upwards, so that their order does not matter.
///
/// The solid is where this is negative. It holds the union, exceeds it by at most k / 4 where two
/// parts meet and by less than k wherever many do, and equals it where distances differ by k.
/// The value is a lower bound of the distance, and of the depth: it changes by no more than the way
/// gone, as each weight of a part is positive and their sum is 1. Outside it is true within
/// accuracy(); its zero is the surface.
///
/// Blends nest: a smooth union may be part of another, with a blend of its own.
///
/// @param parts  1 to 64 of them
/// @param blend  k > 0 [m]
/// @throws InputError if there are none or too many, or the blend is not positive and finite.
[[nodiscard]] std::shared_ptr<const Shape> build_smooth_union(
    std::vector<std::shared_ptr<const Shape>> parts, double blend);

}  // namespace thenar
