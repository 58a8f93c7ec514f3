#pragma once

/// Directions in which a fingertip can move, and how easily.

#include <optional>

#include <Eigen/Core>

namespace thenar {

namespace internal {

/// Singular values below this part of the largest are zero: a finger that straight is straight.
/// Jacobians of hand size carry rounding of about 1e-16 from a few products, so 1e-12 clears it.
inline constexpr double kRankTolerance = 1e-12;

}  // namespace internal

/// Singular values and directions of a tip's position Jacobian.
struct TipManipulability {
  Eigen::Vector3d speed;       // of the tip along each direction, largest first [m/rad] (3)
  Eigen::Matrix3d directions;  // columns, world frame, orthonormal [1] (3, 3)
  int rank;                    // directions in which the tip can move at all [1]
  double condition;            // largest speed / least; infinite if rank < possible [1]
  int possible = 3;            // directions in which joints can move the tip in any posture: 2 in
                               // the plane of parallel axes [1]
};

/// Mobility of a tip:  J = directions diag(speed) V'.  Speeds below 1e-12 of the largest are zero.
/// @param J  tip position Jacobian, world frame, any number of joints   3 x n  [m/rad]
/// @throws InputError if J is empty or not finite.
[[nodiscard]] TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J);

/// Mobility of a tip that also turns. Where all axes are parallel, the tip moves in a plane,
/// whatever the posture, and its condition is that of the two directions in the plane.
/// @param W  tip rotation Jacobian, world frame   3 x n  [1]
[[nodiscard]] TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J,
                                                   const Eigen::Ref<const Eigen::Matrix3Xd>& W);

/// Unit normal of the plane in which a tip moves because all axes that move it are parallel, to
/// 1e-12 rad. No joint feels a force of the tip along it, and the bones carry that alone.
/// @return nothing for axes in space, for joints that slide across the plane, and where no joint
///         turns the tip   world frame (3) [1]
[[nodiscard]] std::optional<Eigen::Vector3d> plane_normal(
    const Eigen::Ref<const Eigen::Matrix3Xd>& J, const Eigen::Ref<const Eigen::Matrix3Xd>& W);

}  // namespace thenar
