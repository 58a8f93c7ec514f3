#pragma once

/// The answers of `thenar feasible-force`.

#include <array>
#include <string>
#include <vector>

#include "apps/digit_question.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"

namespace thenar {

/// Axes in which forces are asked for and shown.
struct ForceAxes {
  std::string name;                  // "world", "tip" or "map"
  std::array<std::string, 3> names;  // of each axis
  Eigen::Matrix3d to_world;          // columns: the axes, world frame (3, 3)
};

/// The set, and the largest pure force along each axis.
struct WholeSet {
  FeasibleForceSet set;
  std::vector<MaxTipForce> along;  // +1, -1, +2, -2, +3, -3 (6)
};

/// Derivative of the largest force by each joint, the direction held in the axes that it was given
/// in; empty unless there is such a force, and for a map [N/rad] (n).
[[nodiscard]] Eigen::VectorXd magnitude_change(const DigitAtPosture& at, const ForceAxes& axes,
                                               const MaxTipForce& largest);

[[nodiscard]] WholeSet whole_set(const DigitAtPosture& at, const ForceAxes& axes);

[[nodiscard]] nlohmann::ordered_json json_of(const DigitAtPosture& at, const ForceAxes& axes,
                                             const MaxTipForce& largest);
[[nodiscard]] nlohmann::ordered_json json_of(const ForceAxes& axes, const WholeSet& whole);
[[nodiscard]] std::string text_of(const DigitAtPosture& at, const ForceAxes& axes,
                                  const MaxTipForce& largest);
[[nodiscard]] std::string text_of(const ForceAxes& axes, const WholeSet& whole);

}  // namespace thenar
