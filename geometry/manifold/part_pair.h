#pragma once

/// Contacts of two parts, each a primitive or a polyhedron; in the frame of B's part.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/manifold/collision_body.h"
#include "geometry/manifold/contact_manifold.h"
#include "geometry/manifold/near_features.h"

namespace thenar {

/// State of a pair of parts, kept from the last query.
struct PartMemory {
  Pose<double> X_BA{};            // for which `bound` holds
  double bound = 0;               // of the distance [m]
  bool seen = false;              // false: nothing is known
  Eigen::Vector3d n{0, 0, 0};     // the last normal, outward of B; 0: none (3)
  bool overlapped = false;        // whether the parts overlapped then
  int axis = -1;                  // of two boxes: the separating direction
  int reference = -1;             // of two boxes: 0 or 1, whose face the other's is cut with
  std::array<double, 2> phase{};  // of cylinders: where around the caps points are [rad]
  NearFeatures near{};            // of polyhedra: what may touch
};

/// Two parts of a pair of bodies.
struct PartPair {
  int a = 0;  // of CollisionBody::parts of A
  int b = 0;  // of B
  PartMemory memory{};
};

/// Appends the points where the parts are nearer than the margin.
/// @return a lower bound of the distance of the parts, or of what is not in the points [m]
double find_points(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                   double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

/// The distance of two bodies within balls, each in its own frame, changes by no more than this
/// between two poses [m]: by the least of the ways that their points go, seen from the other,
///   |X c - X' c| + ||R - R'||_2 r.
[[nodiscard]] double motion_bound(const Ball& a, const Ball& b, const Pose<double>& from_BA,
                                  const Pose<double>& to_BA);

namespace internal {

/// Kinds of features that touch.
enum class FeatureKind : std::uint64_t { kRounds, kBalls, kVertexA, kVertexB, kEdges, kWitness };

/// A number for two features. @param a, b  below 2^24
[[nodiscard]] constexpr std::uint64_t feature_key(FeatureKind kind, int a, int b) {
  return static_cast<std::uint64_t>(kind) << 48U | static_cast<std::uint64_t>(a) << 24U |
         static_cast<std::uint64_t>(b);
}

/// Points as they are when A and B change places, from entry `first` on; in the frame to which
/// `X` leads from the present one.
void flip_points(std::vector<ManifoldPoint>& points, std::size_t first, const Pose<double>& X);

}  // namespace internal

}  // namespace thenar
