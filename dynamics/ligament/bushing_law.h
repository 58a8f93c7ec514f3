#pragma once

/// Law of a joint capsule: efforts on the six coordinates of one bone relative to another.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "dynamics/ligament/ligament_law.h"

namespace thenar {

/// Coordinates of a bushing, in this order. Its frame A stands in the proximal body: z is the axis
/// of flexion, y the distal bone's direction across it, x perpendicular to both. Of the distal
/// body's frame B:
///   p_AB = (across, along, axial),  R_AB = Rz(flexion) Rx(abduction) Ry(twist).
/// Flexion is about an axis of the proximal bone, twist about one of the distal bone, and abduction
/// about the floating axis across both. Source: [GroodSuntay1983].
enum class BushingWay { kAcross, kAlong, kAxial, kFlexion, kAbduction, kTwist };
inline constexpr int kBushingWays = 6;
/// "across", "along", "axial", "flexion", "abduction", "twist".
[[nodiscard]] const std::vector<std::string>& bushing_way_names();

using BushingVector = Eigen::Matrix<double, kBushingWays, 1>;
using BushingMatrix = Eigen::Matrix<double, kBushingWays, kBushingWays>;

/// A law for each way. The rest of a way may follow flexion:
///   force_i = law_i(x_i - follows_i flexion),
/// and flexion feels what that does to it, so that energy
///   V = sum law_i.energy(x_i - follows_i flexion)
/// is kept. A metacarpal that turns inwards as it flexes follows flexion with its twist.
struct BushingLaw {
  std::array<CapsuleLaw, kBushingWays> ways;
  std::array<double, kBushingWays> follows{};  // of flexion itself 0 [m/rad] or [1]

  CapsuleLaw& of(BushingWay way) { return ways[static_cast<std::size_t>(way)]; }
  [[nodiscard]] const CapsuleLaw& of(BushingWay way) const {
    return ways[static_cast<std::size_t>(way)];
  }
};

/// Efforts on the coordinates: minus the gradient of the energy, less damping.
struct BushingAction {
  BushingVector effort = BushingVector::Zero();     // [N], [N m] (6)
  BushingMatrix stiffness = BushingMatrix::Zero();  // second derivatives of the energy (6, 6)
  BushingMatrix damping = BushingMatrix::Zero();    // (6, 6)
  double energy = 0;                                // [J]
};

/// @param x  coordinates [m], [rad] (6);  @param rate  of them (6)
[[nodiscard]] BushingAction bushing_action(const BushingLaw& law, const BushingVector& x,
                                           const BushingVector& rate);

/// @throws InputError as check_law(); if flexion follows itself, or a number is not finite.
void check_law(const BushingLaw& law);

/// Coordinates of a pose, and what turns its angular velocity into rates of the angles.
struct BushingPose {
  BushingVector x;       // [m], [rad] (6)
  Eigen::Matrix3d turn;  // rates of (flexion, abduction, twist) = turn . angular velocity of B
                         // against A, axes of A (3, 3)
};

/// Largest abduction to which the coordinates are trusted: at 90 deg they are singular [rad].
inline constexpr double kMostAbduction = 1.4;

/// Singular at 90 deg of abduction, far beyond what any joint allows; flexion in (-180, 180] deg.
[[nodiscard]] BushingPose bushing_pose(const Pose<double>& X_AB);

}  // namespace thenar
