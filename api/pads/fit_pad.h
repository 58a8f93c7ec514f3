#pragma once

/// Constants of a finger pad, fitted to measured presses.

#include <string>
#include <vector>

#include "api/named/pads.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "data/io/pad/pad_data.h"
#include "pads/pad_fit.h"
#include "solvers/status.h"

namespace thenar {

/// Options of a pad fit: the measured presses and the pad.
struct PadFitRequest {
  std::string presses;             // a data file, or the name of one of presses/
  std::string pad;                 // a file, or a name of pads/; empty: as the data file says
  std::string data;                // folder with presses/ and pads/; empty: the usual ones
  bool check_mesh = true;          // repeat the presses of the estimate on finer cells
  int points = 16;                 // points of each curve of the fitted pad
  bool allow_unconverged = false;  // accept the pad of a search that did not converge
};

/// A press of the fitted pad, load by load.
struct FittedCurve {
  std::vector<double> loads;       // imposed, those of the data among them [N] or [m]
  std::vector<PressPoint> points;  // (loads); empty: it could not be pressed
};

/// Result of a pad fit.
struct [[nodiscard]] FittedPad {
  PadFitRequest request;
  Outcome outcome;  // stalled: the search did not converge, and that was not allowed
  PadData data;
  NamedPad pad;  // pad at which the search started, except starts that the data file states
  PadFitProblem problem;
  PadFitResult fit;                 // result; without estimates if stopped before the first
  PadSpec spec;                     // the pad with the estimates; where there are none, as before
  std::vector<FittedCurve> curves;  // curve of each press of the data; none without estimates
};

/// Fits the constants that a data file names to the presses that it states.
///
/// A pad of the data file is a file beside it, or a name. A search that is stopped gives the best
/// estimate by then.
/// @throws DataError at the file's line if a press cannot be done where the search begins, and as
/// read_pad_data(), read_pad() and pad_fit_problem(); InputError if something is not to be found,
/// or there are too few or too many points.
[[nodiscard]] FittedPad fit_pad(const PadFitRequest& request, const Progress& progress = {});

/// Returns the fitted pad as a data file: its head says what was found, its name is that of the
/// file. A mesh of the skin is named as it is seen from there.
/// @param path  where the text is to be written
/// @throws InputError if there is no estimate.
[[nodiscard]] std::string fitted_pad_text(const FittedPad& fitted, const std::string& path);

/// Returns the reason why there is no usable pad: the search did not converge, and that was not
/// allowed; empty if there is one.
[[nodiscard]] std::string refusal_of(const FittedPad& fitted);

}  // namespace thenar
