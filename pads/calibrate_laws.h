#pragma once

/// Reduced laws of a pad, fitted to presses of its finite elements and checked on others.

#include <string>
#include <vector>

#include "pad_laws/calibrated_laws.h"
#include "pads/press_trials.h"
#include "solvers/status.h"

namespace thenar {

struct LawFitOptions {
  int rings = 18;  // rings of pad_columns()
  // Relative sds of force and area, the weights of the foundation's fit [1]
  double force_sd = 0.05, area_sd = 0.1;
};

/// Result of fit_laws().
struct [[nodiscard]] LawCalibration {
  CalibratedLaws laws;
  Status status = Status::kStalled;   // kSolved: each fit is at a certified minimum
  std::string message;                // fits that did not converge
  std::vector<std::string> failures;  // presses that the finite elements could not solve
};

/// Fits power laws to the logarithms of force, radius and torsion, and the bed of springs to force
/// and area, by least squares; then measures errors on `check`. The laws relax like the pulp.
/// @throws InputError unless there are at least 4 presses to fit and 1 to check, on the pad.
LawCalibration fit_laws(const PadModel& model, const MeasuredPresses& fit,
                        const MeasuredPresses& check, const LawFitOptions& options);

}  // namespace thenar
