#pragma once

/// Duplicate rows of experiments.

#include <string>
#include <vector>

#include "data/io/experiment.h"

namespace thenar {

/// Returns a warning if a trial has the same posture, loads, place of the load cell and all digits
/// of the force as another trial, in the same experiment or another one: a copied row counts twice,
/// so that intervals are too narrow. Forces of zero are ignored.
/// @return one sentence that names the first copy and counts the others; empty: none
[[nodiscard]] std::vector<std::string> doubled_trial_warnings(
    const std::vector<Experiment>& experiments);

}  // namespace thenar
