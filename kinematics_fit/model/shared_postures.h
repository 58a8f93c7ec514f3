#pragma once

/// Postures that several experiments share. The part of a force that the geometry does not explain
/// is shared between people only in postures with equal joint angles.

#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/fit_parameters.h"

namespace thenar {

/// Returns the posture of this name, or null.
[[nodiscard]] const PostureRecord* find_posture(const Experiment& experiment,
                                                const std::string& name);

/// Returns whether all joint angles agree within 2 degrees; a joint that one of the two does not
/// name is at 0 there. False if either is null.
[[nodiscard]] bool same_posture(const PostureRecord* a, const PostureRecord* b);

/// Returns the parameters with posture-specific effects that are independent between specimens (sd
/// 0, and all variance between specimens) if two of the experiments have a posture of one name at
/// different angles.
[[nodiscard]] FitParameters share_same_postures(FitParameters parameters,
                                                const std::vector<Experiment>& experiments);

/// Returns the experiment with " (EXPERIMENT)" appended to the names of postures whose angles
/// differ in `known`, so that they are not confused. If experiments of its own specimen have the
/// name, the angles are compared with all of them, otherwise with any experiment.
[[nodiscard]] Experiment with_own_postures(Experiment experiment,
                                           const std::vector<Experiment>& known);

/// Returns a warning for each name of postures at different angles: those renamed by
/// with_own_postures(), and those of several experiments that share_same_postures() separates.
[[nodiscard]] std::vector<std::string> posture_name_warnings(
    const std::vector<Experiment>& experiments);

}  // namespace thenar
