#pragma once

/// Constants of a finger pad, fitted to measured presses.
///
///     PadFitRequest request;
///     request.presses = "index_published";
///     const FittedPad fitted = fit_pad(request);

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
  std::string presses;             // a data file, or the name of one of presses/; required
  std::string pad;                 // a file, or a name of pads/; empty: as the data file says
  std::string data;                // folder with presses/ and pads/; empty: the usual ones
  bool check_mesh = true;          // repeat the presses of the estimate on finer cells
  int points = 16;                 // points of each curve of the fitted pad
  bool allow_unconverged = false;  // accept the pad of a search that did not converge
};

/// Force-displacement curve of the fitted pad in one press.
struct FittedCurve {
  std::vector<double> loads;       // imposed loads, which include those of the data [N] or [m]
  std::vector<PressPoint> points;  // point of each load; empty: the press failed
};

/// Result of a pad fit.
struct [[nodiscard]] FittedPad {
  PadFitRequest request;  // request that was answered
  Outcome outcome;        // stalled: the search did not converge, and that was not allowed
  PadData data;           // measured presses
  NamedPad pad;           // initial pad, except initial values that the data file states
  PadFitProblem problem;  // residuals and parameters
  PadFitResult fit;       // result; without estimates if stopped before the first
  PadSpec spec;           // pad with the estimates; without estimates, the initial one
  std::vector<FittedCurve> curves;  // curve of each press of the data; none without estimates
};

/// Fits the constants that a data file names to the presses that it states.
///
/// A pad of the data file is a file beside it, or a name. A stopped search returns the best
/// estimate so far.
/// @throws DataError at the file's line if a press fails at the start of the search, and as
/// read_pad_data(), read_pad() and pad_fit_problem(); InputError if an input is not found, or for
/// too few or too many points.
[[nodiscard]] FittedPad fit_pad(const PadFitRequest& request, const Progress& progress = {});

/// Returns the text of a pad file with the estimates, whose head describes the fit and whose name
/// is that of the file. The path of a skin mesh is relative to it.
/// @param path  file that the text is meant for
/// @throws InputError if there is no estimate.
[[nodiscard]] std::string fitted_pad_text(const FittedPad& fitted, const std::string& path);

/// Returns the reason why there is no usable pad: the search did not converge, and that was not
/// allowed; empty if there is one.
[[nodiscard]] std::string refusal_of(const FittedPad& fitted);

}  // namespace thenar
