#pragma once

/// All bodies of a world in motion, and their contacts.

#include <memory>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/broad_phase.h"
#include "geometry/manifold/collision_pair.h"

namespace thenar {

/// Contacts of two bodies.
struct BodyContact {
  int a = 0, b = 0;  // numbers of the bodies, a < b; normals are outward of b
  const ContactManifold* manifold = nullptr;  // not empty; valid until the next update
};

/// Finds the contacts between all bodies that are not excluded, step by step. A pair keeps its
/// memory from its first approach on; heap memory is allocated at first approaches only.
class CollisionWorld {
 public:
  /// @throws InputError if a body is null.
  explicit CollisionWorld(std::vector<std::shared_ptr<const CollisionBody>> bodies);

  /// Excludes a pair from now on, such as two links that a joint connects, or two obstacles.
  void exclude(int a, int b) { broad_.exclude(a, b); }

  /// Returns the pairs with points nearer than the margin, sorted by (a, b). The result depends on
  /// the motion only, and not on the machine.
  /// @param X_WB    pose of each body in world
  /// @param margin  >= 0 [m]
  /// @throws InputError if there are not as many poses as bodies, or one is not finite.
  const std::vector<BodyContact>& update(const std::vector<Pose<double>>& X_WB, double margin);

  [[nodiscard]] const std::vector<std::shared_ptr<const CollisionBody>>& bodies() const {
    return bodies_;
  }

  /// Returns the number of pairs whose boxes overlapped at the last update.
  [[nodiscard]] int near_pairs() const { return near_pairs_; }

 private:
  CollisionPair& pair_of(const BodyPair& bodies);

  std::vector<std::shared_ptr<const CollisionBody>> bodies_;
  BroadPhase broad_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::unique_ptr<CollisionPair>> pairs_;  // (bodies x bodies), null: never near
  std::vector<BodyContact> contacts_;
  int near_pairs_ = 0;
};

}  // namespace thenar
