#pragma once

/// Contact points of two bodies, as a time stepper takes them.

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace thenar {

/// One point of contact of two bodies A and B, in world.
struct ManifoldPoint {
  Eigen::Vector3d on_a{0, 0, 0};    // point of A's surface [m] (3)
  Eigen::Vector3d on_b{0, 0, 0};    // point of B's surface [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit, outward of B: A is pushed along it (3)
  double gap = 0;                   // (on_a - on_b) . normal; negative: minus the depth [m]
  std::uint64_t feature = 0;        // the features that touch: corners, edges, faces by number
  int id = -1;                      // the same integer while the contact lasts
  int age = 0;                      // updates since it appeared
};

/// The points where two bodies touch, or are nearer than a margin, by rising id.
///
/// One region of contact (normals within 30 degrees of each other) has at most six points: those of
/// a face span its rim, an edge has two, a point one. Bodies that meet in several regions (a finger
/// in the corner of a mug) have six for the first and one or more for each other, twelve in all.
struct ContactManifold {
  static constexpr int kMaxPoints = 12;
  std::array<ManifoldPoint, kMaxPoints> points{};
  int count = 0;

  [[nodiscard]] const ManifoldPoint* begin() const { return points.data(); }
  [[nodiscard]] const ManifoldPoint* end() const { return points.data() + count; }
  [[nodiscard]] bool empty() const { return count == 0; }
};

}  // namespace thenar
