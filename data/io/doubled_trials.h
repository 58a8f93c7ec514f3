#pragma once

/// Rows of experiments that stand there twice.

#include <string>
#include <vector>

#include "data/io/experiment.h"

namespace thenar {

/// Returns a warning where trials have the posture, the loads, the load cell's place and all digits
/// of the force of another trial, in the same experiment or another one: a row that was copied
/// counts twice, so that intervals come out too narrow. Forces of zero are left out.
/// @return one sentence that names the first copy and counts the others; empty: none
[[nodiscard]] std::vector<std::string> doubled_trial_warnings(
    const std::vector<Experiment>& experiments);

}  // namespace thenar
