#pragma once

/// Broad phase: pairs of bodies of a world that may touch.

#include <vector>

#include <Eigen/Geometry>

namespace thenar {

/// Two bodies by number, a < b.
struct BodyPair {
  int a = 0, b = 0;

  bool operator==(const BodyPair& other) const { return a == other.a && b == other.b; }
  bool operator<(const BodyPair& other) const { return a != other.a ? a < other.a : b < other.b; }
};

/// Finds overlaps of boxes by sweep and prune: boxes in the order of their lower ends along one
/// axis, an order that hardly changes from step to step, are compared while their ranges overlap.
/// The axis is the one along which the boxes' centres vary most. The heap is left alone once there
/// have been as many pairs as ever.
class BroadPhase {
 public:
  /// @param bodies  how many there are
  explicit BroadPhase(int bodies);

  /// Leaves out a pair from now on, in either order. @throws InputError if there is no such body.
  void exclude(int a, int b);
  [[nodiscard]] bool excluded(int a, int b) const;

  /// The pairs whose boxes meet, touching included, by rising (a, b) whatever the motion was.
  /// @param boxes  of all bodies, with margins, in world [m]
  /// @throws InputError if there are not as many as bodies, or one is empty or not finite.
  const std::vector<BodyPair>& update(const std::vector<Eigen::AlignedBox3d>& boxes);

 private:
  std::size_t bodies_;
  std::vector<bool> excluded_;  // (bodies x bodies)
  std::vector<int> order_;      // of bodies along the axis
  std::vector<BodyPair> pairs_;
};

}  // namespace thenar
