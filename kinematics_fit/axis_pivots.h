#pragma once

/// Pivots of tilt: the points of joint axes about which a fit tilts the axes.

#include <string>

#include "data/io/subject.h"

namespace thenar {

/// The subject with points of its axes beside the tendons that cross them. Any point of an axis
/// states the same joint, but a fit tilts the axis about it: about one far away, as a motion
/// capture gives it, a tilt would move the axis out of the finger. A point that lies further than
/// 10 mm along its axis from the middle of these tendons is moved to that middle. Joints of the
/// digit that no path crosses, as where moment arms are constants, have the place nearest to the
/// axes before and after them in its stead, or nearest to the tip where these are within 30 degrees
/// of parallel, and are moved from 15 mm on; other joints keep their points. No force of the
/// subject changes.
[[nodiscard]] Subject with_points_at_tendons(Subject subject, const std::string& digit);

}  // namespace thenar
