#pragma once

/// Pivots of tilt: the points of joint axes about which a fit tilts the axes.

#include <string>

#include "data/io/subject.h"

namespace thenar {

/// Returns the subject with axis points next to the tendons that cross the axes. Every point of an
/// axis describes the same joint, but a fit tilts the axis about the given point: if it is far
/// away, as in data from motion capture, a tilt would move the axis out of the finger. A point that
/// lies further than 10 mm along its axis from the centre of these tendons is moved to that centre.
/// For joints of the digit that no path crosses, e.g. if moment arms are constants, the centre is
/// replaced by the point nearest to the previous and next axes, or nearest to the tip if these are
/// within 30 degrees of parallel, and points are moved from 15 mm on. Other joints keep their
/// points. No force of the subject changes.
[[nodiscard]] Subject with_points_at_tendons(Subject subject, const std::string& digit);

}  // namespace thenar
