#pragma once

/// Record of a search for the distance of a solid from a shape: the best point, and what is
/// excluded.

#include <algorithm>

#include <Eigen/Core>

#include "base/numbers.h"
#include "geometry/collision/empty_space.h"
#include "geometry/collision/signed_distance.h"

namespace thenar::internal {

inline constexpr double kNoBound = -kInfinity;  // bound that excludes nothing [m]
inline constexpr double kEverywhere = 1e29;     // radius of a ball without effect [m]

/// A triangle of A's core or a part of one, with the surface of B nearest to it.
struct TrianglePiece {
  Eigen::Matrix3d corners;  // [m] (3, 3)
  Ball ball;                // bounding ball of the corners, without the rounding radius
  NearestSurface seen;      // nearest surface of B from the ball's centre
  double radius;            // rounding radius of A [m]
  int triangle;             // entry of CollisionTree::triangles
};

/// The point of A nearest to B, of all points that were evaluated.
struct BestPoint {
  double distance = kInfinity;    // [m]
  Eigen::Vector3d core{0, 0, 0};  // point of A's core [m] (3)
  NearestSurface seen{};          // nearest surface of B from that point
  double radius = 0;              // rounding radius there [m]
  int triangle = -1;
};

/// Evaluates the distance of B, and records the number of evaluations, the best point, the space
/// that they prove to be empty, and the smallest bound of pieces that were left out. All in B's
/// frame.
class DistanceRecord {
 public:
  /// @param b, options  must outlive it
  DistanceRecord(const Shape& b, const SignedDistanceOptions& options) : b_(b), options_(options) {}

  /// Returns the distance of B from a point [m].
  double distance(const Eigen::Vector3d& p);
  /// Returns the surface of B nearest to a point, and records its plane if it supports B.
  NearestSurface nearest_surface(const Eigen::Vector3d& p);
  /// Bounds the distance of a piece by a ball lifted off B, which is recorded [m].
  double bound_by_lifted_ball(const TrianglePiece& piece);
  /// Evaluates the distance at a point, and records the empty ball about it.
  void add_empty_ball(const Eigen::Vector3d& p) { empty_.add_ball({p, distance(p)}); }

  /// Records a point of A's core if it is better than the best.
  void update_best(const Eigen::Vector3d& core, const NearestSurface& seen,
                   const TrianglePiece& piece);
  /// Records the bound of a piece that is not searched [m].
  void skip(double bound) { skipped_bound_ = std::min(skipped_bound_, bound); }

  /// Returns the bound from which on no piece need be searched [m].
  [[nodiscard]] double sufficient_bound() const {
    if (best_.distance == kInfinity) return kInfinity;
    return best_.distance - std::max(options_.tolerance, options_.relative * best_.distance);
  }
  [[nodiscard]] bool is_exhausted() const { return evaluations_ >= options_.max_evaluations; }

  [[nodiscard]] const Shape& shape() const { return b_; }
  [[nodiscard]] const SignedDistanceOptions& options() const { return options_; }
  [[nodiscard]] const BestPoint& best() const { return best_; }
  [[nodiscard]] const EmptySpace& empty_space() const { return empty_; }
  [[nodiscard]] double skipped_bound() const { return skipped_bound_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  const Shape& b_;
  const SignedDistanceOptions& options_;
  BestPoint best_;
  EmptySpace empty_;                  // space that holds no part of B
  double skipped_bound_ = kInfinity;  // smallest bound of pieces that were not searched [m]
  int evaluations_ = 0;
};

}  // namespace thenar::internal
