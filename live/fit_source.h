#pragma once

/// Data of a fit, or of draws from a posterior, for a live view: parameters of every specimen,
/// measured and predicted forces.

#include <string>
#include <vector>

#include "kinematics_fit/prediction.h"
#include "posterior/run/posterior_axes.h"

namespace thenar {

/// Values of all parameters of one specimen.
struct SpecimenValues {
  std::vector<double> estimate;            // fitted values, or means of the draws [SI] (parameters)
  std::vector<std::vector<double>> draws;  // values of at most kMaxShownDraws draws; empty for a
                                           // fit [SI] (draws, parameters)
  std::vector<PosteriorAxes> axes;         // offsets of neighbouring axes over all draws, for the
                                           // pairs that the parameters move
};

/// Content of the file of a fit or a posterior.
struct FitSource {
  std::string file, kind;                 // path; "fit" or "posterior"
  Subject subject;                        // subject that the fit started from
  FitProblem problem;                     // experiments, digit, parameters
  std::vector<SpecimenValues> specimens;  // in the order of problem.specimens()
  std::vector<Prediction> predictions;    // one for each experiment, with predictive sds
  std::vector<std::string> warnings;      // reasons to doubt the fit or the draws
};

/// Largest number of draws whose joint axes are shown.
inline constexpr int kMaxShownDraws = 200;

/// Reads the result of a fit (.h5) or a posterior (.nc) and predicts the forces of its own
/// experiments, as fit_digit() and predict_by_draws() do.
/// @throws InputError for another kind of file; DataError for a damaged one
[[nodiscard]] FitSource read_fit_source(const std::string& path);

}  // namespace thenar
