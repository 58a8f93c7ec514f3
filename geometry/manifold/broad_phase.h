#pragma once

/// Broad phase: pairs of bodies of a world that may touch.

#include <vector>

#include <Eigen/Geometry>

namespace thenar {

/// Numbers of two bodies, a < b.
struct BodyPair {
  int a = 0, b = 0;

  bool operator==(const BodyPair& other) const { return a == other.a && b == other.b; }
  bool operator<(const BodyPair& other) const { return a != other.a ? a < other.a : b < other.b; }
};

/// Finds overlaps of boxes by sweep and prune: boxes, sorted by their lower ends along one axis, an
/// order that hardly changes from step to step, are compared while their ranges overlap. The axis
/// is the one along which the centres of the boxes vary most. No heap memory is allocated once the
/// number of pairs has reached its maximum.
class BroadPhase {
 public:
  /// @param bodies  number of bodies
  explicit BroadPhase(int bodies);

  /// Excludes a pair from now on, in either order. @throws InputError if there is no such body.
  void exclude(int a, int b);
  [[nodiscard]] bool excluded(int a, int b) const;

  /// Returns the pairs whose boxes overlap or touch, sorted by (a, b) for any motion.
  /// @param boxes  boxes of all bodies, with margins, in world [m]
  /// @throws InputError if there are not as many as bodies, or one is empty or not finite.
  const std::vector<BodyPair>& update(const std::vector<Eigen::AlignedBox3d>& boxes);

 private:
  std::size_t bodies_;
  std::vector<bool> excluded_;  // whether each pair is excluded (bodies x bodies)
  std::vector<int> order_;      // bodies, sorted along the axis
  std::vector<BodyPair> pairs_;
};

}  // namespace thenar
