#pragma once

/// Mobility of a fingertip: the directions in which it can move, and its speed in each.

#include <optional>

#include <Eigen/Core>

namespace thenar {

namespace internal {

/// Relative threshold of singular values below which they count as zero [1]. Jacobians of hand size
/// carry rounding errors of about 1e-16 from a few products, so 1e-12 is well above them.
inline constexpr double kRankTolerance = 1e-12;

}  // namespace internal

/// Singular values and directions of a tip's position Jacobian.
struct TipManipulability {
  Eigen::Vector3d speed;       // speed of the tip along each direction, largest first [m/rad] (3)
  Eigen::Matrix3d directions;  // columns, world frame, orthonormal [1] (3, 3)
  int rank;                    // number of directions in which the tip can move [1]
  double condition;            // largest speed over smallest; infinite if rank < possible [1]
  int possible = 3;  // number of directions in which joints can move the tip in any posture: 2 in
                     // the plane of parallel axes [1]
};

/// Computes the mobility of a tip:  J = directions diag(speed) V'.  Speeds below 1e-12 of the
/// largest are zero.
/// @param J  tip position Jacobian, world frame, any number of joints   3 x n  [m/rad]
/// @throws InputError if J is empty or not finite.
[[nodiscard]] TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J);

/// Computes the mobility of a tip that also rotates. Where all axes are parallel, the tip moves in
/// a plane, whatever the posture, and its condition is that of the two directions in the plane.
/// @param W  tip rotation Jacobian, world frame   3 x n  [1]
[[nodiscard]] TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J,
                                                   const Eigen::Ref<const Eigen::Matrix3Xd>& W);

/// Computes the unit normal of the plane in which a tip moves because all axes that move it are
/// parallel, to 1e-12 rad. No joint feels a force of the tip along it; the bones carry that alone.
/// @return nothing for axes in space, for joints that slide across the plane, and where no joint
/// rotates the tip   world frame (3) [1]
[[nodiscard]] std::optional<Eigen::Vector3d> plane_normal(
    const Eigen::Ref<const Eigen::Matrix3Xd>& J, const Eigen::Ref<const Eigen::Matrix3Xd>& W);

}  // namespace thenar
