#pragma once

/// What couples and drives the joints of an MJCF model.

#include "data/io/robot/mjcf_source.h"
#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Gives the joints of `robot` their degrees of freedom: joint equalities and equalities of fixed
/// tendons of two joints couple rigidly; a fixed tendon with an actuator gives the joints it spans
/// one compliant degree of freedom, its length L = sum c_i q_i, each with q_i = c_i / sum(c^2) L,
/// what equal springs would do. Efforts come from the actuators.
/// @param ref  of each joint, its value in the file's own posture, in the order of `robot.joints`
/// @throws DataError
void drive_mjcf(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot);

}  // namespace thenar::internal
