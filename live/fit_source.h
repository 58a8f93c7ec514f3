#pragma once

/// Data of a fit, or of draws from a posterior, for a live view: parameters of every specimen, and
/// forces measured and predicted.

#include <string>
#include <vector>

#include "kinematics_fit/prediction.h"
#include "posterior/run/posterior_axes.h"

namespace thenar {

/// Values of all parameters of one specimen.
struct SpecimenValues {
  std::vector<double> estimate;            // fitted, or the means of draws [SI] (all)
  std::vector<std::vector<double>> drawn;  // of some draws; none of a fit [SI] (draws) of (all)
  std::vector<PosteriorAxes> axes;         // of all draws; only pairs of which an axis moves
};

/// A fit or a posterior, read.
struct FitSource {
  std::string file, kind;                 // "fit" or "posterior"
  Subject subject;                        // that it started from
  FitProblem problem;                     // experiments, digit, parameters
  std::vector<SpecimenValues> specimens;  // in the order of problem.specimens()
  std::vector<Prediction> predictions;    // of each experiment, with predictive sds
  std::vector<std::string> warnings;      // to read before either is trusted
};

/// Most draws of which axes are shown.
inline constexpr int kShownDraws = 200;

/// Reads a result of a fit (.h5) or a posterior (.nc). Forces are those that fit_digit() and
/// predict_by_draws() predict of what was fitted.
/// @throws InputError if it is something else; DataError if it is damaged.
[[nodiscard]] FitSource read_fit_source(const std::string& path);

}  // namespace thenar
