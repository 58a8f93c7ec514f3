#pragma once

/// Postures that several experiments share. The part of a force that the geometry does not explain
/// is shared between people only in postures in which they stand alike.

#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/fit_parameters.h"

namespace thenar {

/// The posture of this name, or null.
[[nodiscard]] const PostureRecord* find_posture(const Experiment& experiment,
                                                const std::string& name);

/// Returns whether all joints stand alike within 2 degrees; a joint that one of the two does not
/// name is at 0 there. Null is like nothing.
[[nodiscard]] bool same_posture(const PostureRecord* a, const PostureRecord* b);

/// The parameters, what postures have of their own kept to each specimen, sd 0 and the whole
/// variance between specimens, wherever two of the experiments have a posture of one name at other
/// angles.
[[nodiscard]] FitParameters share_same_postures(FitParameters parameters,
                                                const std::vector<Experiment>& experiments);

/// The experiment, with " (EXPERIMENT)" after the names of postures that stand elsewhere in
/// `known`, so that nothing which is known of those is taken for these: where experiments of its
/// own specimen have the name, in all of them, else in any.
[[nodiscard]] Experiment with_own_postures(Experiment experiment,
                                           const std::vector<Experiment>& known);

/// Warnings where one name stands for postures at different angles, a sentence each: those renamed
/// by with_own_postures(), and those of several experiments that share_same_postures() keeps apart.
[[nodiscard]] std::vector<std::string> posture_name_warnings(
    const std::vector<Experiment>& experiments);

}  // namespace thenar
