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

/// Finds the contacts of two bodies again and again as they move.
///
/// Each pair of their parts (CollisionPart) remembers a bound of its distance and the pose for
/// which it holds. A part of A in a ball of centre c and radius r moves in B's frame by at most
///   |X c - X' c| + ||R - R'||_2 r,
/// so that pairs whose bound exceeds this by more than the margin are skipped, without error.
/// Contacts keep their id while the same features touch, or while the point that takes over is
/// where the old one was.
///
/// update() does not use the heap once its buffers have grown to what the contacts need.
class CollisionPair {
 public:
  CollisionPair(std::shared_ptr<const CollisionBody> a, std::shared_ptr<const CollisionBody> b);

  /// The contacts at these poses: all points with gaps up to the margin, reduced to a few. The
  /// reference holds until the next update.
  ///
  /// Where bodies are apart the least gap is their distance: to rounding for spheres, capsules,
  /// tapered capsules, boxes and meshes of any pairing (of a capsule on its side to 0.1 um), for
  /// cylinders on a face of a box and ellipsoids on these; others are tessellated
  /// (polyhedron_contact.h). Where they overlap it is minus a depth along the normal: the least of
  /// all directions for boxes, the deepest ball of a capsule, the deepest corner of a mesh.
  /// @param margin  >= 0 [m]
  /// @throws InputError if a pose or the margin is not finite.
  const ContactManifold& update(const Pose<double>& X_WA, const Pose<double>& X_WB, double margin);

  [[nodiscard]] const ContactManifold& manifold() const { return manifold_; }

  /// Forgets all contacts, bounds and normals: ids start anew, and of directions to separate
  /// overlaps none is preferred.
  void forget();

  /// No point of A is nearer to B than this at the last poses, unless it is in the manifold [m].
  [[nodiscard]] double bound() const { return bound_; }

  [[nodiscard]] const CollisionBody& a() const { return *a_; }
  [[nodiscard]] const CollisionBody& b() const { return *b_; }

 private:
  std::shared_ptr<const CollisionBody> a_, b_;
  std::vector<PartPair> parts_;
  std::vector<ManifoldPoint> candidates_;
  ContactManifold manifold_;
  ManifoldMemory memory_;
  Pose<double> X_BA_{};  // of the last update
  bool seen_ = false;
  double bound_ = 0;  // [m]
};

}  // namespace thenar
