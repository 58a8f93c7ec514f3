#pragma once

/// Volume of a Minkowski sum of contacts, computed from faces without a convex hull.

#include <optional>

#include "base/progress.h"
#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// Computes the volume of the Minkowski sum over contacts of conv({0} + points) [unit forces^6].
/// The points of one contact and 0 span at most three dimensions, as the pyramids of hard points
/// do.
///
/// A facet of a sum is a sum of one face of each summand; in general position their dimensions add
/// up to five. The chosen faces form a facet if each is the outermost face of its contact along u,
/// their normal with the size of their parallelotope. Then
///   V = 1/6 sum over facets of (product of sizes) h(u),   h(u) = sum of max(0, u'points).
/// All combinations are tried: about (edges)^5 for each five contacts, 0.1 us each. Where faces are
/// parallel or otherwise not in general position (two hard points share the force along their
/// line), each contact is rotated at random by 1e-9, or by 1e-7 if that is not enough; this is the
/// accuracy of the volume.
/// @param max_choices  maximum number of combinations
/// @return nothing if a contact spans more dimensions, there are too many combinations, facets
/// remain uncertain, or `progress` stops the computation
/// Source: [Schneider2014] (4.1, 5.1.2) for volumes by facets and faces of sums.
[[nodiscard]] std::optional<double> minkowski_volume(const WrenchSet& set, double max_choices,
                                                     const Progress& progress = {});

}  // namespace thenar::internal
