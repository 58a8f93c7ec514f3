#pragma once

/// What a search for the distance of a solid from a shape has seen so far, and what that excludes.

#include <algorithm>

#include <Eigen/Core>

#include "base/numbers.h"
#include "geometry/collision/empty_space.h"
#include "geometry/collision/signed_distance.h"

namespace thenar::internal {

inline constexpr double kNoBound = -kInfinity;  // bound that excludes nothing [m]
inline constexpr double kEverywhere = 1e29;     // radius of a ball that restricts nothing [m]

/// A triangle of A's core or a part of one, seen from B.
struct TrianglePiece {
  Eigen::Matrix3d corners;  // [m] (3, 3)
  Ball ball;                // around them, without the rounding
  NearestSurface seen;      // of B from the ball's centre
  double radius;            // of the rounding [m]
  int triangle;
};

/// The point of A that is nearest to B, of all that were seen.
struct BestPoint {
  double distance = kInfinity;    // [m]
  Eigen::Vector3d core{0, 0, 0};  // where it was seen: a point of A's core [m] (3)
  NearestSurface seen{};          // of B from there
  double radius = 0;              // of the rounding there [m]
  int triangle = -1;
};

/// Looks at the distance of B, and keeps count of them, the best point, the space that they show to
/// be empty, and the least bound of what was left out. All in B's frame.
class DistanceRecord {
 public:
  /// @param b, options  must outlive it
  DistanceRecord(const Shape& b, const SignedDistanceOptions& options) : b_(b), options_(options) {}

  /// Returns the distance of B from a point [m].
  double distance(const Eigen::Vector3d& p);
  /// Returns the surface of B as it is seen from a point; planes that support B are kept.
  NearestSurface see(const Eigen::Vector3d& p);
  /// Bounds the distance of a piece by a ball lifted off B, which is kept [m].
  double look_lifted(const TrianglePiece& piece);
  /// Looks at the distance about a point and keeps the ball without a part of B.
  void keep_ball_about(const Eigen::Vector3d& p) { empty_.add_ball({p, distance(p)}); }

  /// Keeps a point of A's core if it is the best.
  void offer(const Eigen::Vector3d& core, const NearestSurface& seen, const TrianglePiece& piece);
  /// Notes the bound of something that is not searched [m].
  void drop(double bound) { dropped_ = std::min(dropped_, bound); }

  /// Returns the bound from which on nothing need be searched [m].
  [[nodiscard]] double enough() const {
    if (best_.distance == kInfinity) return kInfinity;
    return best_.distance - std::max(options_.tolerance, options_.relative * best_.distance);
  }
  [[nodiscard]] bool is_spent() const { return evaluations_ >= options_.max_evaluations; }

  [[nodiscard]] const Shape& shape() const { return b_; }
  [[nodiscard]] const SignedDistanceOptions& options() const { return options_; }
  [[nodiscard]] const BestPoint& best() const { return best_; }
  [[nodiscard]] const EmptySpace& empty() const { return empty_; }
  [[nodiscard]] double dropped() const { return dropped_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  const Shape& b_;
  const SignedDistanceOptions& options_;
  BestPoint best_;
  EmptySpace empty_;            // of B
  double dropped_ = kInfinity;  // least bound of what was not searched [m]
  int evaluations_ = 0;
};

}  // namespace thenar::internal
