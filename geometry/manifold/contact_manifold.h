#pragma once

/// Contact points of two bodies, as input of a time stepper.

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace thenar {

/// One contact point of two bodies A and B, in world.
struct ManifoldPoint {
  Eigen::Vector3d on_a{0, 0, 0};    // point of A's surface [m] (3)
  Eigen::Vector3d on_b{0, 0, 0};    // point of B's surface [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit, outward of B: direction of the force on A (3)
  double gap = 0;                   // (on_a - on_b) . normal; negative: minus the depth [m]
  std::uint64_t feature = 0;  // key of the features that touch: corners, edges, faces by number
  int id = -1;                // number that is constant while the contact lasts
  int age = 0;                // number of updates since it appeared
};

/// Points where two bodies touch, or are nearer than a margin, sorted by id.
///
/// One contact region (normals within 30 degrees of each other) has at most six points: those of a
/// face span its boundary, an edge has two, a point one. Bodies that meet in several regions (a
/// finger in the corner of a mug) have six for the first and one or more for each other, at most
/// twelve.
struct ContactManifold {
  static constexpr int kMaxPoints = 12;
  std::array<ManifoldPoint, kMaxPoints> points{};
  int count = 0;

  [[nodiscard]] const ManifoldPoint* begin() const { return points.data(); }
  [[nodiscard]] const ManifoldPoint* end() const { return points.data() + count; }
  [[nodiscard]] bool empty() const { return count == 0; }
};

}  // namespace thenar
