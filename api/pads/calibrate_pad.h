#pragma once

/// Reduced laws of any pad, fitted to its own finite elements.

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
  PadRequest pad;
  double force_error = 0.04;  // estimated by elements, below which their meshes do [1]
  double max_penetration =
      20e-6;                   // largest penetration of faces by an object between their nodes [m]
  int max_elements = 4000;     // a mesh is not refined beyond
  std::vector<double> depths;  // depths of the fitted presses [m]; empty: trial_depths()
};

/// Forces of a press by the contact laws.
struct LawForces {
  double power = 0, soft_finger = 0;  // forces by curvatures of the gap [N]
  double bed = 0;                     // force by springs over the skin [N]
  double bed_area = 0;                // area of the patch of these springs [m^2]
  double bed_arm = 0;                 // torsion for a friction of 1 [m]
};

/// A press of the elements, and laws beside it.
struct LawPress {
  bool fitted = true;  // false: one of those that errors are of
  MeasuredPress elements;
  std::optional<LawForces> laws;  // absent: there are none
};

/// Result of a calibration.
struct [[nodiscard]] PadLaws {
  PadLawsRequest request;
  Outcome outcome;  // outcome with the status of the calibration
  NamedPad pad;
  std::vector<double> depths;     // depths of the presses that laws are fitted to [m]
  std::vector<LawPress> presses;  // presses that the elements solved, those of the fit first
  LawCalibration calibration;     // kStopped, or too few presses: without laws
  double press_s = 0, fit_s = 0;  // time of presses, of fits [s]

  [[nodiscard]] bool has_laws() const { return calibration.laws.evidence.fitted > 0; }
};

/// Presses the pad's elements by standard_trials(), at once and without friction, fits power law,
/// soft finger and bed of springs to one part of the presses and measures their errors on the
/// others. Presses that fail are warned of, and what is left is fitted if it is half of them or
/// more.
/// @throws InputError as open_pad(), of depths that do not rise from above 0, and unless errors and
/// counts are positive.
[[nodiscard]] PadLaws calibrate_pad(const PadLawsRequest& request, const Progress& progress = {});

/// Returns the laws as a data file for this pad, with its name and digest.
/// @throws InputError if there are none.
[[nodiscard]] std::string pad_laws_text(const PadLaws& found);

/// Returns the reason why there are no usable laws; empty if there are, or if it was stopped.
[[nodiscard]] std::string refusal_of(const PadLaws& found);

}  // namespace thenar
