#pragma once

/// The demo's posteriors: the middle fingers of two hands, each alone and both as one population.

#include <string>

#include "base/progress.h"
#include "kinematics_fit/fit_study.h"
#include "report/blocks.h"

namespace thenar {

/// Samples and writes each to `output`/NAME.nc. @returns sections of a report, a table of all
/// first; empty if a stop was requested
[[nodiscard]] Json posterior_pages(const StudyInputs& inputs, const std::string& output,
                                   const Progress& progress);

}  // namespace thenar
