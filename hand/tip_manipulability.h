#pragma once

/// Directions in which a fingertip can move, and how easily.

#include <Eigen/Core>

namespace thenar {

namespace internal {

/// Singular values below this part of the largest are zero: a finger that straight is straight.
/// Jacobians of hand size carry rounding of about 1e-16 from a few products, so 1e-12 clears it.
inline constexpr double kRankTolerance = 1e-12;

}  // namespace internal

/// Singular values and directions of a tip's position Jacobian.
struct TipManipulability {
  Eigen::Vector3d speed;       // of the tip along each direction, largest first  [m/rad] (3)
  Eigen::Matrix3d directions;  // columns, world frame, orthonormal               [1] (3, 3)
  int rank;                    // directions in which the tip can move at all     [1]
  double condition;            // largest speed / least; infinite if rank < 3     [1]
};

/// Mobility of a tip:  J = directions diag(speed) V'.  Speeds below 1e-12 of the largest are zero.
/// @param J  tip position Jacobian, world frame, any number of joints   3 x n  [m/rad]
/// @throws InputError if J is empty or not finite.
[[nodiscard]] TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J);

}  // namespace thenar
