#pragma once

/// The volume of a Minkowski sum of contacts, without its hull.

#include <optional>

#include "base/progress.h"
#include "grasp/quality/wrench_set.h"

namespace thenar::internal {

/// Volume of the sum over contacts of conv({0} + points), for sets of points of which those of one
/// contact (and 0) span three dimensions at most, as the pyramids of hard points do.
///
/// A facet of a sum is a sum of one face of each summand, and in general position their dimensions
/// add up to five. With u a normal to the chosen faces, of the size of their parallelotope, it is
/// one if each is the outermost face of its contact along u; then
///   V = 1/6 sum over facets of (product of sizes) h(u),   h(u) = sum of max(0, u'points).
/// All choices are tried: some (edges)^5 for each five contacts, 0.1 us each. Where faces are
/// parallel or otherwise not in general position (two hard points both have the force along their
/// line) each contact is turned at random by 1e-9, or 1e-7 if that does not do; the volume is exact
/// to that.
/// @return none if a contact spans more, choices are more than `most`, it is uncertain what is a
/// facet, or it was asked to stop.
/// Source: [Schneider2014] (4.1, 5.1.2) for volumes by facets and faces of sums.
[[nodiscard]] std::optional<double> sum_volume(const WrenchSet& set, double most,
                                               const Progress& progress = {});

}  // namespace thenar::internal
