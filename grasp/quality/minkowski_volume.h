#pragma once

/// Volume of a Minkowski sum of contacts, without its convex hull.

#include <array>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// Volume of the Minkowski sum over contacts of conv({0} + points) [unit forces^6]. The points of
/// one contact and 0 span three dimensions at most, as the pyramids of hard points do.
///
/// A facet of a sum is a sum of one face of each summand; in general position their dimensions add
/// up to five. The chosen faces form a facet if each is the outermost face of its contact along u,
/// their normal with the size of their parallelotope. Then
///   V = 1/6 sum over facets of (product of sizes) h(u),   h(u) = sum of max(0, u'points).
/// All choices are tried: some (edges)^5 for each five contacts, 0.1 us each. Where faces are
/// parallel or otherwise not in general position (two hard points both have the force along their
/// line), each contact is turned at random by 1e-9, or by 1e-7 if that is not enough; the volume is
/// exact to that.
/// @return nothing if a contact spans more dimensions, there are more than `most` choices, facets
/// remain uncertain, or it was asked to stop.
/// Source: [Schneider2014] (4.1, 5.1.2) for volumes by facets and faces of sums.
[[nodiscard]] std::optional<double> minkowski_volume(const WrenchSet& set, double most,
                                                     const Progress& progress = {});

/// A face of dimension 1 to 3 of the body of one contact; the whole body counts as a face, too.
struct ContactFace {
  int dimension;
  std::array<ScaledWrench, 3> span;    // vectors along it, as many as its dimension
  double size;                         // its measure over that of the parallelotope of `span` [1]
  std::array<ScaledWrench, 2> inward;  // vectors from it along the neighbouring faces
  int inwards;  // their number: u is an outer normal if u'inward < 0 for each
};

/// Convex hull of points and 0, of dimension 3 at most.
struct ContactBody {
  std::vector<ScaledWrench> points;  // its corners, and perhaps other points of it
  std::vector<ContactFace> faces;    // of dimension 1 and higher
};

/// Faces of a contact. @return nothing if the points span more than three dimensions or exceed 200
[[nodiscard]] std::optional<ContactBody> contact_body(const std::vector<ScaledWrench>& points);

}  // namespace thenar::internal
