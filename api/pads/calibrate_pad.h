#pragma once

/// Calibration of a pad's reduced contact laws against its own finite elements.
///
///     PadLawsRequest request;
///     request.pad.pad = "index_pad";
///     const PadLaws laws = calibrate_pad(request);

#include <optional>
#include <string>
#include <vector>

#include "api/named/pads.h"
#include "base/progress.h"
#include "pads/calibrate_laws.h"
#include "solvers/status.h"

namespace thenar {

/// Options of calibrate_pad(): a pad, its presses, and the accuracy of the elements.
struct PadLawsRequest {
  PadRequest pad;                  // pad whose laws are found
  double force_error = 0.04;       // largest estimated error of the force of accepted meshes [1]
  double max_penetration = 20e-6;  // largest penetration between nodes [m]
  int max_elements = 4000;         // limit of refinement
  std::vector<double> depths;      // depths of the fitted presses [m]; empty: trial_depths()
};

/// Forces of a press by the contact laws.
struct LawForces {
  double power = 0, soft_finger = 0;  // forces by curvatures of the gap [N]
  double bed = 0;                     // force by springs over the skin [N]
  double bed_area = 0;                // area of the patch of these springs [m^2]
  double bed_arm = 0;                 // torque per normal force for a friction of 1 [m]
};

/// Press of the elements, with the forces of the laws.
struct LawPress {
  bool fitted = true;             // false: one of the presses on which errors are measured
  MeasuredPress elements;         // press as elements compute it
  std::optional<LawForces> laws;  // absent: no laws
};

/// Result of a calibration.
struct [[nodiscard]] PadLaws {
  PadLawsRequest request;         // request that was answered
  Outcome outcome;                // its status is that of the calibration
  NamedPad pad;                   // pad that was pressed
  std::vector<double> depths;     // depths of the presses that laws are fitted to [m]
  std::vector<LawPress> presses;  // presses that the elements solved, those of the fit first
  LawCalibration calibration;     // without laws if stopped, or after too few presses
  double press_s = 0, fit_s = 0;  // wall time of presses and of fits [s]

  [[nodiscard]] bool has_laws() const { return calibration.laws.evidence.fitted > 0; }
};

/// Presses the pad's elements in standard_trials(), instantaneously and without friction, fits
/// power law, soft finger and bed of springs to one part of the presses and measures their errors
/// on the others. Failed presses are named in warnings; the others are fitted if they are at least
/// half.
/// @throws InputError as open_pad(), and unless depths are positive and rising, and errors and
/// counts are positive.
[[nodiscard]] PadLaws calibrate_pad(const PadLawsRequest& request, const Progress& progress = {});

/// Returns the laws as a data file for this pad, with its name and digest.
/// @throws InputError if there are none.
[[nodiscard]] std::string pad_laws_text(const PadLaws& found);

/// Returns the reason why there are no usable laws; empty if there are, or if it was stopped.
[[nodiscard]] std::string refusal_of(const PadLaws& found);

}  // namespace thenar
