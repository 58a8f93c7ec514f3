#pragma once

/// What shapes weigh.

#include <vector>

#include "geometry/mass_properties.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Volume, centroid and inertia of a shape at density 1 kg/m^3, in the frame of its body. Of a
/// mesh, signed_moments() of its solid_parts(); nothing if it bounds no solid, as one with holes.
/// @throws InputError for a tapered capsule.
[[nodiscard]] MassProperties mass_at_unit_density(const ShapeSpec& shape);

/// Several rigidly together.
[[nodiscard]] MassProperties together(const std::vector<MassProperties>& parts);

}  // namespace thenar
