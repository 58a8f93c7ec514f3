#pragma once

/// Friction pyramids: polytopes that replace friction cones, as in most of the literature.

#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Replaces each cap by the polytope of its vertices. The result is a polytope, for which epsilon()
/// and volume() are exact to rounding.
///   disc, axes a1, a2:          c + cos(2 pi k / m) a1 + sin(2 pi k / m) a2,  k = 0..m-1
///   ellipsoid of a soft finger: these, and the poles c +- a3 (twist alone)
///   segment:                    its two ends
///   point, explicit wrench:     unchanged
/// The vertices of a cap share its contact's limit. The first edge of contacts made by wrench_set()
/// is along the first of tangents(n).
/// @param edges  number m >= 3 of edges of each pyramid
/// @throws InputError if edges < 3. Source: [Ferrari1992].
[[nodiscard]] WrenchSet friction_pyramids(const WrenchSet& set, int edges);

/// Replaces each cap by an inscribed polytope. Ellipsoids are cut by m meridians and m / 2
/// bands of latitude, so that they converge as fast as discs. @throws InputError if edges < 3
[[nodiscard]] WrenchSet inscribed_polytopes(const WrenchSet& set, int edges);

/// Replaces each cap by a circumscribed polytope: that of inscribed_polytopes(), scaled for discs
/// by 1 / cos(pi / m), for ellipsoids also by 1 / cos(pi / (2 bands)). @throws InputError if edges
/// < 3
[[nodiscard]] WrenchSet circumscribed_polytopes(const WrenchSet& set, int edges);

}  // namespace thenar
