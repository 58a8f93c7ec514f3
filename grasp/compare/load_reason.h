#pragma once

/// Why a grasp holds nothing, or why nobody knows.

#include <string>
#include <vector>

#include "grasp/quality/task_wrenches.h"

namespace thenar {

/// Loads below it are rounding of the cone programmes [N].
inline constexpr double kNoLoad = 1e-6;

/// Of a load without limit.
inline constexpr const char* kBorneByStructure = "borne by structure, whose strength is not known";

/// What hand_forces() is made of.
struct HeldForces {
  const HandLayout& layout;
  WrenchSet set;
  Eigen::MatrixXd T;  // torque_map()
  Actuation actuation;
};

/// "the effort of 'motor' is unknown": of the first actuator without a limit that moves a
/// coordinate which feels a contact and is not locked; empty: there is none, all that matters is
/// known.
[[nodiscard]] std::string unknown_effort(const HeldForces& forces);

/// What stands in the way of every multiple of some loads: friction, or a least set of joints that
/// would need a motor of any strength for any of the loads to be borne.
[[nodiscard]] std::string why_nothing_holds(const HeldForces& forces,
                                            const std::vector<Wrench>& loads);

}  // namespace thenar
