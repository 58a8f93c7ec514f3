#pragma once

/// The string of a band in world axes, in the form in which a net needs it: no 6 x 6 matrices, one
/// arctangent. A test holds it equal to wrap_string().

#include "tendons/wrapping/bone_surface.h"

namespace thenar::internal {

/// A bone that a band bends over, in world axes.
struct RoundBone {
  bool sphere = false;
  double radius = 0;          // [m]
  Eigen::Vector3d center;     // or a point of the axis [m]
  Eigen::Vector3d e1, e2, d;  // cylinder: towards the side, across, along the axis (unit)
  Eigen::Vector3d side;       // sphere: between opposite ends (3)
};

[[nodiscard]] RoundBone round_bone(const BoneSurface& surface, const Pose<double>& X_WS,
                                   const Eigen::Vector3d& side_S);

/// Length L and its derivatives by the ends:
///   dL/da = ua,   d2L/da2 = vaa va va' + na na na' (coefficient wa),   d2L/da db = vab va vb'
struct BandGeometry {
  double length;
  Eigen::Vector3d ua, ub;  // slopes
  Eigen::Vector3d va, vb;  // how the run turns as a whole
  Eigen::Vector3d na, nb;  // across the free runs
  double vaa, vab, vbb, wa, wb;
};

enum class WrapState {
  kStraight,   // the band misses the bone
  kBent,       // it lies on the bone
  kDegenerate  // an end lies inside, or both are in line with a sphere's centre: see wrap_string()
};

/// Sets `run` if the band is bent.
[[nodiscard]] WrapState wrap_over(const RoundBone& bone, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, BandGeometry& run);

}  // namespace thenar::internal
