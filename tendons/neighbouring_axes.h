#pragma once

/// Relative position of neighbouring joint axes of a digit in its reference posture: the angle
/// between two axes, their distance, and which one is distal.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// Position of one axis relative to another, in the reference posture.
struct AxisOffset {
  double angle = 0;     // angle between the two lines, whatever their senses, 0..pi/2 [rad]
  double distance = 0;  // length of their common normal [m]
  double beyond = 0;    // component along the digit of the common normal from the first axis to the
                        // second: positive where the second is distal of the first [m]
};

/// Computes the offset of the second axis from the first.
/// @param distal  direction along the digit, away from its base; unit (3)
[[nodiscard]] AxisOffset axis_offset(const Hinge<double>& first, const Hinge<double>& second,
                                     const Eigen::Vector3d& distal);

/// Two successive hinges of a digit, from its base to its tip.
struct NeighbouringAxes {
  int first = 0, second = 0;  // indices of the hinges in the model's tree
  std::string name;           // "CMC1_FE-CMC1_AA"
};

/// Returns the pairs of successive hinges between the base and the tip.
[[nodiscard]] std::vector<NeighbouringAxes> neighbouring_axes(const TendonDigit& digit);

/// Computes the offset of the second axis from the first in the reference posture. The direction
/// along the digit is the reverse of the tip's proximal direction there.
[[nodiscard]] AxisOffset axis_offset(const TendonModel<double>& model,
                                     const NeighbouringAxes& axes);

/// Computes the point of each axis nearest to the straight line from the first axis to the tip,
/// where a bone would cross it; for pictures, since any point of an axis gives the same kinematics.
/// @return world frame [m] (3) for each hinge
[[nodiscard]] std::vector<Eigen::Vector3d> axis_points(const TendonModel<double>& model,
                                                       const TreeState<double>& state);

}  // namespace thenar
