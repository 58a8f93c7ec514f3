#pragma once

/// The contacts of two solids: patches, each reduced to a few points.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/collision/patch_search.h"
#include "geometry/collision/signed_distance.h"
#include "grasp/contact/contact.h"

namespace thenar {

/// One connected region of contact.
struct ContactPatch {
  std::vector<HandContact> contacts;  // in B's frame; surface, patch -1, torsion 0: for the caller
  double gap;                         // least distance in it, negative: overlap [m]
  double loss;  // no touching point is farther from the hull of the contacts; it changes a wrench
                // of unit normal force by at most loss sqrt(1 + friction^2) of torque [m]
  Eigen::Vector3d normal;  // at its nearest point, into B, unit (3)
};

struct ContactPatchOptions {
  double tolerance = 2e-4;       // regions farther from B do not touch [m]
  double band = 5e-6;            // of a region those points touch that are farther than its
                                 // nearest by no more; at least twice B's accuracy [m]
  double resolution = 1e-3;      // of the rim of a region [m]
  double merge = 1.5e-3;         // smaller regions are one point, narrower ones two [m]
  int max_points = 8;            // a patch, 3 or more
  int max_evaluations = 50'000;  // of B's distance, in each search
};

struct [[nodiscard]] ContactPatches {
  std::vector<ContactPatch> patches;  // nearest first
  bool complete;                      // no search was cut short
};

/// Where A touches B.
///
/// Pieces of A within the tolerance are joined to regions where they are neighbours and press in
/// directions that turn by less than 30 degrees. Of each region the points within a thin band of
/// its nearest point are kept: bodies touch where they are nearest, and a ball on a plane would
/// else touch in a disc of radius sqrt(2 R tolerance), 2 mm for a ball of 10 mm. Their convex hull,
/// reduced by reduce_points(), gives the contacts: a face on a face the corners of the overlap, an
/// edge two points, a ball one. The loss includes the resolution where the rim was found by
/// halving. Positions are on B's surface, normals those of contact_normal()
/// (grasp/contact/contact_patch.h).
///
/// @param friction  of the two materials [1]
/// @throws InputError if friction is negative or not finite, or an option is not positive.
ContactPatches contact_patches(const CollisionTree& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, double friction,
                               const ContactPatchOptions& options = {});

/// One region in place of two of one body that meet on B: with normals within 30 degrees, and less
/// than the resolution apart, as parts of a body do that lie flat upon or beside each other. The
/// points of both are reduced anew. @returns none if they do not meet
[[nodiscard]] std::optional<ContactPatch> joined(const ContactPatch& x, const ContactPatch& y,
                                                 const ContactPatchOptions& options = {});

/// All contacts of all patches, marked with the number of their patch.
[[nodiscard]] std::vector<HandContact> contacts_of(const std::vector<ContactPatch>& patches);

// Which way two bodies press each other where one or both are sharp.

/// The direction of a contact, into B.
///
///   A rounded there:         the inward normal of B as A's core sees it; it is A's as well
///   B smooth there:          B's inward normal
///   B sharp, A smooth:       A's normal, whichever of both signs points into B
///   B sharp, A sharp too:    A's normal on a face that lies on one of B, within 10 degrees; else
///                            B's inward normal on one that looks the same way; without such a
///                            pair the inward middle of B's normals there
///
/// B is sharp where normals at points 0.1 mm around turn away from each other by more than 30
/// degrees; A is where its triangles within 0.1 mm do.
/// @return  unit, in B's frame (3)
[[nodiscard]] Eigen::Vector3d contact_normal(const PatchPoint& point, const CollisionTree& a,
                                             const Pose<double>& X_BA, const Shape& b);

}  // namespace thenar
