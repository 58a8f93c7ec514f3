#pragma once

/// Relative position of a digit's joint axes in its reference posture: the angle between two axes,
/// their distance, and which of them is the distal one.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// One axis as seen from another, in the reference posture.
struct AxisOffset {
  double angle;     // between the two lines, whatever their senses, 0..pi/2 [rad]
  double distance;  // length of their common normal [m]
  double beyond;    // component of the common normal, from the first axis to the second, along the
                    // digit: above 0 where the second one lies distal of the first [m]
};

/// @param distal  direction along the digit, away from its base; unit (3)
[[nodiscard]] AxisOffset axis_offset(const Hinge<double>& first, const Hinge<double>& second,
                                     const Eigen::Vector3d& distal);

/// Two successive hinges of a digit, from its base to its tip.
struct NeighbouringAxes {
  int first, second;  // in the model's tree
  std::string name;   // "CMC1_FE-CMC1_AA"
};

/// Returns the pairs of successive hinges between the base and the tip.
[[nodiscard]] std::vector<NeighbouringAxes> neighbouring_axes(const TendonDigit& digit);

/// Returns the offset of the second axis from the first in the reference posture; along the digit
/// is opposite to the tip's proximal direction there.
[[nodiscard]] AxisOffset axis_offset(const TendonModel<double>& model,
                                     const NeighbouringAxes& axes);

/// The point of each axis nearest to a straight way from the first axis to the tip: where a bone
/// would cross it. Any point of an axis is as good for kinematics; this one is fit to look at.
/// @return world frame [m] (3, of each hinge)
[[nodiscard]] std::vector<Eigen::Vector3d> axis_points(const TendonModel<double>& model,
                                                       const TreeState<double>& state);

}  // namespace thenar
