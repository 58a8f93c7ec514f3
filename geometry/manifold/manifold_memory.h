#pragma once

/// Reduction of many points of contact to the few that are kept, with ids that last.

#include <array>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/contact_manifold.h"

namespace thenar {

/// Reduces points of contact and knows them again.
///
/// The nearest point is kept (the last one, while none is nearer by 1 um), then again and again the
/// one farthest from those kept,
///   min over kept j of  |x_i - x_j|^2 + e^2 (1 - n_i . n_j),   e the extent of all points,
/// x on A or on B, whichever are nearer to each other (two balls on one corner are one point),
/// weighted from 1 for the nearest point down to 0.2 at the margin, so that points come and go
/// without weight. After six only directions count that differ from all kept by 30 degrees. Points
/// kept the last time count 1.3 times as far, so that among equals nothing changes. Points within
/// 1 um of each other are one.
///
/// A point takes over the id of the last point of the same feature; else of the nearest last point
/// that is left, if as seen from one of the bodies it is within twice the motion and 0.1 mm of it
/// and their normals are within 20 degrees of each other.
class ManifoldMemory {
 public:
  /// @param points  with gaps up to the margin, in world; they are reordered
  /// @param motion  way that points of A may have gone in B's frame since the last call [m]
  void keep(std::vector<ManifoldPoint>& points, const Pose<double>& X_WA, const Pose<double>& X_WB,
            double motion, double margin, ContactManifold& manifold);

  void forget() { count_ = 0; }

 private:
  struct Remembered {
    Eigen::Vector3d on_a, on_b;  // in the frames of A and B [m] (3)
    Eigen::Vector3d n;           // the normal, in B's frame (3)
    std::uint64_t feature;
    int id, age;
  };

  [[nodiscard]] bool was_kept(std::uint64_t feature) const;
  void reduce(std::vector<ManifoldPoint>& points, double margin, ContactManifold& manifold);
  void name(const Pose<double>& X_WA, const Pose<double>& X_WB, double motion,
            ContactManifold& manifold);

  std::array<Remembered, ContactManifold::kMaxPoints> last_{};
  int count_ = 0;
  int next_id_ = 0;
  std::vector<double> apart_;  // of each point from those kept, squared [m^2]
};

}  // namespace thenar
