#pragma once

/// Reduction of contact points to a few, with persistent ids.

#include <array>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/contact_manifold.h"

namespace thenar {

/// Reduces contact points, and identifies them with those of the last step.
///
/// The nearest point is kept (the last one, unless another is nearer by 1 um), then repeatedly the
/// one farthest from those kept,
///   min over kept j of  |x_i - x_j|^2 + e^2 (1 - n_i . n_j),   e the extent of all points,
/// x on A or on B, whichever are nearer to each other (two balls on one corner are one point),
/// weighted from 1 for the nearest point down to 0.2 at the margin, so that points appear and
/// disappear without weight. After six points only directions count that differ from all kept ones
/// by 30 degrees. Distances of points kept the last time are multiplied by 1.3, so that the choice
/// among equals is stable. Points within 1 um of each other are one.
///
/// A point inherits the id of the last point of the same feature; otherwise of the nearest
/// unassigned last point, if it is within twice the motion and 0.1 mm of it in the frame of one of
/// the bodies, and their normals are within 20 degrees of each other.
class ManifoldMemory {
 public:
  /// Reduces the points to the manifold, with ids.
  /// @param points  points with gaps up to the margin, in world; they are reordered
  /// @param motion  bound of the motion of A's points in B's frame since the last call [m]
  void update(std::vector<ManifoldPoint>& points, const Pose<double>& X_WA,
              const Pose<double>& X_WB, double motion, double margin, ContactManifold& manifold);

  void clear() { count_ = 0; }

 private:
  struct Remembered {
    Eigen::Vector3d on_a, on_b;  // in the frames of A and B [m] (3)
    Eigen::Vector3d n;           // normal, in B's frame (3)
    std::uint64_t feature;
    int id, age;
  };

  [[nodiscard]] bool was_kept(std::uint64_t feature) const;
  void reduce(std::vector<ManifoldPoint>& points, double margin, ContactManifold& manifold);
  void assign_ids(const Pose<double>& X_WA, const Pose<double>& X_WB, double motion,
                  ContactManifold& manifold);

  std::array<Remembered, ContactManifold::kMaxPoints> last_{};
  int count_ = 0;
  int next_id_ = 0;
  std::vector<double> squared_distances_;  // of each point from those kept [m^2]
};

}  // namespace thenar
