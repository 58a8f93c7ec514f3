#pragma once

/// Contacts of two parts, each a primitive or a polyhedron, in the frame of B's part.

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
  Pose<double> X_BA{};            // pose for which `bound` holds
  double bound = 0;               // lower bound of the distance [m]
  bool is_known = false;          // whether `bound` is known
  Eigen::Vector3d n{0, 0, 0};     // last normal, outward of B; 0: none (3)
  bool overlapped = false;        // whether the parts overlapped at the last query
  int axis = -1;                  // two boxes: separating direction
  int reference = -1;             // two boxes: 0 or 1, the box whose face clips the other's
  std::array<double, 2> phase{};  // cylinders: angles of the points around the caps [rad]
  NearFeatures near{};            // polyhedra: features that may touch
};

/// Two parts of a pair of bodies.
struct PartPair {
  int a = 0;  // entry of CollisionBody::parts of A
  int b = 0;  // entry of CollisionBody::parts of B
  PartMemory memory{};
};

/// Appends the points where the parts are nearer than the margin.
/// @return a lower bound of the distance of the parts, or of points that are not in the list [m]
double find_points(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                   double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

/// Returns a bound of the change of distance of two bodies between two poses [m]. Each body is in a
/// ball, in its own frame; the bound is the smaller of the motions of their points, as seen from
/// the other,
///   |X c - X' c| + ||R - R'||_2 r.
[[nodiscard]] double motion_bound(const Ball& a, const Ball& b, const Pose<double>& from_BA,
                                  const Pose<double>& to_BA);

namespace internal {

/// Kinds of features that touch.
enum class FeatureKind : std::uint64_t { kRounds, kBalls, kVertexA, kVertexB, kEdges, kWitness };

/// Returns a key of two features. @param a, b  below 2^24
[[nodiscard]] constexpr std::uint64_t feature_key(FeatureKind kind, int a, int b) {
  return static_cast<std::uint64_t>(kind) << 48U | static_cast<std::uint64_t>(a) << 24U |
         static_cast<std::uint64_t>(b);
}

/// Exchanges the roles of A and B in points, from entry `first` on, and transforms them by X.
void exchange_bodies(std::vector<ManifoldPoint>& points, std::size_t first, const Pose<double>& X);

}  // namespace internal

}  // namespace thenar
