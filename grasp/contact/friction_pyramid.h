#pragma once

/// Friction pyramids in place of cones, as most of the literature has them.

#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Caps cut to polytopes with their vertices on the cap; what comes out is a polytope, on which
/// epsilon() and volume() are exact to rounding.
///   disc, axes a1, a2:          c + cos(2 pi k / m) a1 + sin(2 pi k / m) a2,  k = 0..m-1
///   ellipsoid of a soft finger: that, and the poles c +- a3 (twist alone)
///   segment:                    its two ends
///   point, explicit wrench:     as it is
/// The vertices of a cap share its contact's limit. The first edge of contacts made by wrench_set()
/// is along the first of tangents(n).
/// @param edges  m >= 3 of each pyramid
/// @throws InputError if edges < 3. Source: [Ferrari1992].
[[nodiscard]] WrenchSet pyramids(const WrenchSet& set, int edges);

/// The same with ellipsoids cut by m meridians and m / 2 bands of latitude, so that more edges come
/// as near to them as to discs. @throws InputError if edges < 3
[[nodiscard]] WrenchSet polytopes_in(const WrenchSet& set, int edges);

/// These grown until they hold the caps: discs by 1 / cos(pi / m), ellipsoids also by
/// 1 / cos(pi / (2 bands)). @throws InputError if edges < 3
[[nodiscard]] WrenchSet polytopes_about(const WrenchSet& set, int edges);

}  // namespace thenar
