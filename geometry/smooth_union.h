#pragma once

/// Shapes that flow into each other.

#include <memory>
#include <vector>

#include "geometry/shape.h"

namespace thenar {

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
