#pragma once

/// Deepest point and gap between an undeformed pad and an object, for point contact laws.

#include <memory>
#include <optional>

#include "geometry/collision/curvature.h"
#include "pads/pad_shape.h"

namespace thenar {

/// Returns the skin as a solid in the pad's frame.
[[nodiscard]] std::shared_ptr<const Shape> skin_solid(const PadShape& shape);

/// Returns a distance from the pad's origin that no point of its skin exceeds [m].
[[nodiscard]] double reach_of(const PadShape& shape);

/// Point where a pad's undeformed skin lies deepest in an object.
struct DeepestSkin {
  double overlap = 0;              // depth in the object; below 0: apart [m]
  double thickness = 0;            // thickness of the soft tissue there [m]
  Eigen::Vector3d place{0, 0, 0};  // position in the pad's frame [m] (3)
  Eigen::Vector2d disc{0, 0};      // position on the disc of PadChart [1] (2)
  double lead = 0;  // overlap less the largest one beyond a quarter of the disc's radius; 0 if the
                    // search began at a nearby point [m]
};

/// Finds the deepest point by a search over the whole skin, on a grid first, to 1e-7 of the pad's
/// size. With `near` it finds the local maximum around that point, which is the deepest of all as
/// long as the object has moved by less than half of the lead.
/// @param near  point on the disc [1] (2)
[[nodiscard]] DeepestSkin deepest_skin(const PadChart& chart, const Shape& object,
                                       const Pose<double>& X_PO,
                                       const std::optional<Eigen::Vector2d>& near = {});

/// Returns the curvatures of the gap between skin and object near a point, by curvatures() over
/// 1 mm for pads of any size.
/// @param p  point in the pad's frame [m] (3)
[[nodiscard]] RelativeCurvatures skin_gap(const Shape& skin, const Shape& object,
                                          const Pose<double>& X_PO, const Eigen::Vector3d& p);

}  // namespace thenar
