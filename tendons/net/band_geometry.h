#pragma once

/// Length of a band over a bone in world axes, in the form that a net needs: no 6 x 6 matrices, one
/// arctangent. A test compares it with wrap_string().

#include "tendons/wrapping/bone_surface.h"

namespace thenar::internal {

/// Sphere or cylinder that a band bends over, world frame.
struct RoundBone {
  bool sphere = false;  // false: cylinder
  double radius = 0;    // [m]
  // Centre of the sphere, or a point of the cylinder's axis [m] (3).
  Eigen::Vector3d center{0, 0, 0};
  // Cylinder: directions towards the side, across, and along the axis; unit (3).
  Eigen::Vector3d e1{0, 0, 0}, e2{0, 0, 0}, d{0, 0, 0};
  Eigen::Vector3d side{0, 0, 0};  // sphere: direction that decides between ways of equal length (3)
};

/// Poses a sphere or cylinder. @param side_S  NetBand::side (3)
[[nodiscard]] RoundBone round_bone(const BoneSurface& surface, const Pose<double>& X_WS,
                                   const Eigen::Vector3d& side_S);

/// Length L of a bent band and its derivatives by the ends:
///   dL/da = ua,   d2L/da2 = vaa va va' + na na na' (coefficient wa),   d2L/da db = vab va vb'
struct BandGeometry {
  double length = 0;
  Eigen::Vector3d ua, ub;  // gradients of L by a and b [1] (3)
  Eigen::Vector3d va, vb;  // directions in which the ends turn the whole run (3)
  Eigen::Vector3d na, nb;  // directions across the free runs (3)
  double vaa = 0, vab = 0, vbb = 0, wa = 0, wb = 0;  // coefficients of the second derivatives [1/m]
};

/// Contact of a band with its bone.
enum class WrapState {
  kStraight,   // the band misses the bone
  kBent,       // the band lies on the bone
  kDegenerate  // an end lies inside, or the ends are in line with a sphere's centre: see
               // wrap_string()
};

/// Computes the contact of a band from a to b with a bone; sets `run` if the band is bent.
[[nodiscard]] WrapState wrap_over(const RoundBone& bone, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, BandGeometry& run);

}  // namespace thenar::internal
