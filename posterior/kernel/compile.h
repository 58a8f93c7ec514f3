#pragma once

/// From a digit, its parameters and an experiment to a program.

#include "kinematics_fit/predict_forces.h"
#include "posterior/kernel/program.h"

namespace thenar::kernel {

/// Fills a program; parameters without a coordinate become constants.
void compile(const TendonDigit& digit, const FitParameters& parameters, const ExperimentPlan& plan,
             Program& program);

}  // namespace thenar::kernel
