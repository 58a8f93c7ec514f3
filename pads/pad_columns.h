#pragma once

/// Springs over the skin of a finger pad.

#include "pads/laws/foundation_bed.h"
#include "pads/pad_shape.h"

namespace thenar {

/// Columns of a pad on `rings` rings of its disc, about 3 rings^2 in all, each as thick as the soft
/// tissue along its ray from the bone.
/// @throws InputError unless rings > 0, and as PadChart.
[[nodiscard]] FoundationColumns pad_columns(const PadShape& shape, int rings);

}  // namespace thenar
