#pragma once

/// Two bodies in motion, with the memory of their contacts.

#include <memory>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/collision_body.h"
#include "geometry/manifold/contact_manifold.h"
#include "geometry/manifold/manifold_memory.h"
#include "geometry/manifold/part_pair.h"

namespace thenar {

/// Finds the contacts of two bodies repeatedly as they move.
///
/// Each pair of their parts (CollisionPart) stores a bound of its distance and the pose for which
/// it holds. A part of A in a ball of centre c and radius r moves in B's frame by at most
///   |X c - X' c| + ||R - R'||_2 r,
/// so that pairs whose bound exceeds this by more than the margin are skipped, without error.
/// Contacts keep their id while the same features touch, or while a new point replaces the old one
/// at the same position.
///
/// update() does not allocate heap memory once its buffers have reached their maximum sizes.
class CollisionPair {
 public:
  CollisionPair(std::shared_ptr<const CollisionBody> a, std::shared_ptr<const CollisionBody> b);

  /// Computes the contacts at these poses: all points with gaps up to the margin, reduced to a few.
  /// The reference is valid until the next update.
  ///
  /// If the bodies are apart, the smallest gap is their distance: exact to rounding for spheres,
  /// capsules, tapered capsules, boxes and meshes in any combination (for a capsule on its side to
  /// 0.1 um), for cylinders on a face of a box and ellipsoids on these; others are tessellated
  /// (polyhedron_contact.h). If they overlap it is minus a depth along the normal: the minimum over
  /// all directions for boxes, the deepest ball of a capsule, the deepest corner of a mesh.
  /// @param margin  >= 0 [m]
  /// @throws InputError if a pose or the margin is not finite.
  const ContactManifold& update(const Pose<double>& X_WA, const Pose<double>& X_WB, double margin);

  [[nodiscard]] const ContactManifold& manifold() const { return manifold_; }

  /// Clears all contacts, bounds and normals: ids start again, and no direction that separates
  /// overlaps is preferred.
  void clear_memory();

  /// Returns a lower bound of the distance of points of A from B at the last poses, except for
  /// those in the manifold [m].
  [[nodiscard]] double distance_bound() const { return bound_; }

  [[nodiscard]] const CollisionBody& a() const { return *a_; }
  [[nodiscard]] const CollisionBody& b() const { return *b_; }

 private:
  std::shared_ptr<const CollisionBody> a_, b_;
  std::vector<PartPair> parts_;
  std::vector<ManifoldPoint> candidates_;
  ContactManifold manifold_;
  ManifoldMemory memory_;
  Pose<double> X_BA_{};      // pose at the last update
  bool is_updated_ = false;  // whether there was an update
  double bound_ = 0;         // distance_bound() [m]
};

}  // namespace thenar
