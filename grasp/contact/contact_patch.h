#pragma once

/// Contact patches of two solids: connected regions of contact, each reduced to a few points.

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
  std::vector<HandContact>
      contacts;         // in B's frame; surface, patch -1 and torsion 0 are left to the caller
  double distance = 0;  // minimum in the patch; negative: overlap [m]
  /// Maximum distance of a touching point from the hull of the contacts; it changes the wrench of
  /// unit normal force by a torque of at most loss sqrt(1 + friction^2) [m]
  double loss = 0;
  Eigen::Vector3d normal{0, 0, 0};  // normal at its nearest point, into B, unit (3)
};

/// Settings of contact_patches().
struct ContactPatchOptions {
  double tolerance = 2e-4;  // maximum distance of contact regions from B [m]
  double band = 5e-6;  // maximum distance from B of points in a region, less that of its nearest
                       // point; at least twice B's accuracy [m]
  double resolution = 1e-3;  // resolution of the boundary of a region [m]
  double merge = 1.5e-3;  // extent below which a region becomes one point, and width below which it
                          // becomes two [m]
  int max_points = 8;     // maximum number of points of a patch, >= 3
  int max_evaluations = 50'000;  // maximum number of distance evaluations of B in each search
};

/// Result of contact_patches().
struct [[nodiscard]] ContactPatches {
  std::vector<ContactPatch> patches;  // patches, nearest first
  bool complete;                      // true: no search reached max_evaluations
};

/// Finds the patches where body A touches body B.
///
/// Neighbouring pieces of A within the tolerance form one region while their directions of contact
/// turn by less than 30 degrees. A region keeps the points within a thin band of its nearest point,
/// because bodies touch where they are nearest: with the whole tolerance a ball on a plane would
/// touch in a disc of radius sqrt(2 R tolerance), 2 mm for a ball of 10 mm. The contacts are the
/// corners of the convex hull of these points, reduced by reduce_points(): a face on a face gives
/// the corners of the overlap, an edge two points, a ball one. The loss includes the resolution
/// where the boundary was found by halving. Positions lie on B's surface; normals are those of
/// contact_normal().
///
/// @param friction  coefficient of the two materials [1]
/// @throws InputError if friction is negative or not finite, or an option is not positive.
ContactPatches contact_patches(const CollisionTree& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, double friction,
                               const ContactPatchOptions& options = {});

/// Merges two patches of one body if their normals are within 30 degrees and the patches are less
/// than the resolution apart, as those of adjacent parts of a body are. The points of both are
/// reduced together. @returns nothing if the patches are apart
[[nodiscard]] std::optional<ContactPatch> merge_patches(const ContactPatch& x,
                                                        const ContactPatch& y,
                                                        const ContactPatchOptions& options = {});

/// Returns all contacts of all patches; `patch` is the number of their patch.
[[nodiscard]] std::vector<HandContact> number_patch_contacts(
    const std::vector<ContactPatch>& patches);

/// Returns the direction of a contact of two bodies, into B, also where one or both have a sharp
/// edge.
///
///   A rounded there:      the inward normal of B as seen from A's core, which is A's as well
///   B smooth there:       B's inward normal
///   B sharp, A smooth:    A's normal, with the sign that points into B
///   both sharp:           the normal of a face of A that lies on a face of B, within 10 degrees;
///                         otherwise the inward normal of a face of B that faces the same way as a
///                         face of A; without such a pair the normal of two edges that cross, or,
///                         at corners, the mean inward normal of B there
///
/// B is sharp where its normals at points 0.1 mm around turn away from each other by more than 30
/// degrees; A is sharp where the normals of its triangles within 0.1 mm do.
/// @return  unit, in B's frame (3)
[[nodiscard]] Eigen::Vector3d contact_normal(const PatchPoint& point, const CollisionTree& a,
                                             const Pose<double>& X_BA, const Shape& b);

}  // namespace thenar
