#pragma once

/// Reduced laws of a pad, fitted to presses of its finite elements and checked on others.

#include <string>
#include <vector>

#include "pad_laws/calibrated_laws.h"
#include "pads/press_trials.h"
#include "solvers/status.h"

namespace thenar {

struct LawFitOptions {
  int rings = 18;                         // of pad_columns()
  double force_sd = 0.05, area_sd = 0.1;  // relative: weights of the foundation's fit [1]
};

/// Result of fit_laws().
struct [[nodiscard]] LawCalibration {
  CalibratedLaws laws;
  Status status = Status::kStalled;   // kSolved: each fit is at a certified minimum
  std::string message;                // which is not, otherwise
  std::vector<std::string> failures;  // presses that the elements could not solve
};

/// Fits powers to logarithms of force, radius and torsion, and the bed of springs to force and
/// area, in least squares; then measures errors on `check`. Relaxation is that of the pulp.
/// @throws InputError unless there are at least 4 presses to fit and 1 to check, on the pad.
LawCalibration fit_laws(const PadModel& model, const MeasuredPresses& fit,
                        const MeasuredPresses& check, const LawFitOptions& options);

}  // namespace thenar
