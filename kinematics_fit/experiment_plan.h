#pragma once

#include <string>
#include <vector>

namespace thenar {

/// What to know of an experiment before its numbers are trusted with this digit: postures beyond
/// the joints' limits or in which the held tip is nearly singular, tensions far above what the
/// muscle can make, a subject that was calibrated on the specimen, moments that no fit uses.
[[nodiscard]] std::vector<std::string> experiment_warnings(const TendonDigit& digit,
                                                           const ExperimentPlan& plan,
                                                           const Experiment& experiment);

}  // namespace thenar
