#pragma once

/// Law of a joint capsule: generalized forces on the six coordinates of one bone relative to
/// another.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "dynamics/ligament/ligament_law.h"

namespace thenar {

/// Coordinates of a bushing, in this order. Frame A is fixed to the proximal body: z is the flexion
/// axis, y the direction of the distal bone perpendicular to z, and x completes the frame. The pose
/// of frame B of the distal body is
///   p_AB = (across, along, axial),  R_AB = Rz(flexion) Rx(abduction) Ry(twist).
/// Flexion is about an axis of the proximal bone, twist about an axis of the distal bone, and
/// abduction about the floating axis perpendicular to both. Source: [GroodSuntay1983].
enum class BushingCoordinate { kAcross, kAlong, kAxial, kFlexion, kAbduction, kTwist };
inline constexpr int kBushingCoordinates = 6;
/// Returns "across", "along", "axial", "flexion", "abduction", "twist".
[[nodiscard]] const std::vector<std::string>& bushing_coordinate_names();

using BushingVector = Eigen::Matrix<double, kBushingCoordinates, 1>;
using BushingMatrix = Eigen::Matrix<double, kBushingCoordinates, kBushingCoordinates>;

/// Capsule laws of the six coordinates. The rest position of a coordinate may be proportional to
/// the flexion angle:
///   force_i = law_i(x_i - ratio_i flexion),
/// and flexion feels the corresponding reaction, so that the forces derive from the energy
///   V = sum law_i.energy(x_i - ratio_i flexion).
/// A metacarpal that twists inwards as it flexes has such a ratio for its twist.
struct BushingLaw {
  std::array<CapsuleLaw, kBushingCoordinates> laws;
  std::array<double, kBushingCoordinates> flexion_ratios{};  // d rest / d flexion, 0 for flexion
                                                             // itself [m/rad] or [1]

  CapsuleLaw& law_for(BushingCoordinate coordinate) {
    return laws[static_cast<std::size_t>(coordinate)];
  }
  [[nodiscard]] const CapsuleLaw& law_for(BushingCoordinate coordinate) const {
    return laws[static_cast<std::size_t>(coordinate)];
  }
};

/// Generalized force on the coordinates, its derivatives and the stored energy.
struct BushingAction {
  BushingVector effort = BushingVector::Zero();     // -dV/dx, less damping [N], [N m] (6)
  BushingMatrix stiffness = BushingMatrix::Zero();  // second derivatives of the energy (6, 6)
  BushingMatrix damping = BushingMatrix::Zero();    // -d effort / d rate (6, 6)
  double energy = 0;                                // V [J]
};

/// Returns the action of a bushing at its coordinates and rates.
/// @param x     coordinates [m], [rad] (6)
/// @param rate  their time derivatives [m/s], [rad/s] (6)
[[nodiscard]] BushingAction bushing_action(const BushingLaw& law, const BushingVector& x,
                                           const BushingVector& rate);

/// Checks the constants of a bushing law.
/// @throws InputError if a capsule law is invalid, a ratio is not finite, or the ratio of flexion
/// to itself is not 0.
void check_law(const BushingLaw& law);

/// Bushing coordinates of a pose, and the map from angular velocity to their rates.
struct BushingPose {
  BushingVector x = BushingVector::Zero();  // coordinates [m], [rad] (6)
  // (flexion, abduction, twist) rates = rate_map . angular velocity of B relative to A, in axes of
  // A (3, 3)
  Eigen::Matrix3d rate_map = Eigen::Matrix3d::Identity();
};

/// Largest abduction at which the coordinates are valid; they are singular at 90 deg [rad].
inline constexpr double kMaxAbduction = 1.4;

/// Returns the bushing coordinates of the pose of B in A, flexion in (-180, 180] deg. They are
/// singular at 90 deg of abduction, which no joint reaches.
[[nodiscard]] BushingPose bushing_pose(const Pose<double>& X_AB);

}  // namespace thenar
