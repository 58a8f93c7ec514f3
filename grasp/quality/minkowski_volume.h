#pragma once

/// The volume of a Minkowski sum of contacts, without its hull.

#include <array>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "grasp/contact/wrench_set.h"

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
[[nodiscard]] std::optional<double> minkowski_volume(const WrenchSet& set, double most,
                                                     const Progress& progress = {});

// Faces of what one contact can make, for sums of many.

/// A face of dimension 1 to 3; the whole body counts as one, too.
struct ContactFace {
  int dimension;
  std::array<ScaledWrench, 3> span;    // vectors along it, as many as its dimension
  double size;                         // its measure over that of the parallelotope of `span` [1]
  std::array<ScaledWrench, 2> inward;  // from it along the faces next to it
  int inwards;  // how many: a normal u is an outer one if u'inward < 0 for each
};

/// The hull of points and 0, of dimension 3 at most.
struct ContactBody {
  std::vector<ScaledWrench> points;  // its corners, and maybe others of its points
  std::vector<ContactFace> faces;    // of dimension 1 and more
};

/// @return none if the points span more than three dimensions, or are more than 200
[[nodiscard]] std::optional<ContactBody> contact_body(const std::vector<ScaledWrench>& points);

}  // namespace thenar::internal
