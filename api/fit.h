#pragma once

/// Fit of a digit's parameters to measured fingertip forces.
/// Example: examples/07_fit.cpp, examples/14_fit_and_posterior.cpp.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/run_record.h"
#include "kinematics_fit/choose_settings.h"
#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/misfit.h"
#include "kinematics_fit/trivial_prediction.h"
#include "solvers/status.h"

namespace thenar {

/// Inputs of a fit, by name or file.
struct FitSources {
  std::vector<std::string> experiments;  // files, or names of experiments/; at least one
  std::string subject;   // subject that the fit starts from: file, or name of subjects/; required
  std::string settings;  // file, or name of fits/; empty: the digit's built-in ones
  std::vector<std::string> also_free;  // globs of further free parameters
  std::string net = {};                // file, or name of nets/, of the extensor mechanism in
                                       // place of the subject's hood; empty: none
  Scaling scale = Scaling::kSubject;   // sizes of the digit of each specimen
  std::string data;                    // folder with subjects/ ..; empty: the usual ones
  std::optional<Path> path = {};       // tendon paths, see require_fit_path()
};

struct FitRequest {
  FitSources sources;                                      // data and model of the fit
  LeastSquaresMethod method = LeastSquaresMethod::kCeres;  // optimiser
  unsigned seed = 1;                                       // seed of a global search
  int max_evaluations = 0;                                 // 0: the method's own limit [1]
  std::vector<LeaveOut> leave_out;  // trial groups that are also predicted by fits without them
  bool choose_settings = false;     // choose settings by left-out data, in each fold too
  std::string output;               // result file (.h5), written before anything is left out; or ""
  RunRecord run;                    // record of the run for the file
};

/// Fit with the fractions of the subject's hood instead of a net, otherwise like the main fit.
/// Settings are chosen separately where they are chosen at all.
struct FractionsFit {
  Fit fit;                                // parameters and their covariance
  std::vector<Prediction> in_sample;      // see FitResult
  std::vector<CrossValidation> left_out;  // see FitResult
};

struct FitResult {
  FitRequest request;  // request that was answered
  Outcome outcome;  // stopped: the fit is the best point so far. Warnings: of the experiments, the
                    // subject, misfits that are beyond chance, and estimates beyond 3 prior sds
  Fit fit;          // parameters and their covariance
  std::vector<Prediction> in_sample;      // predictions of each experiment, by its specimen's own
                                          // parameters, with predictive sds
  std::vector<CrossValidation> left_out;  // in the order of the request; fewer if stopped
  std::vector<Misfit> misfits = {};       // misfit of each experiment
  std::optional<ChosenSettings> chosen = {};  // chosen settings, present if requested
  std::vector<FoldChoice> fold_choices = {};  // choices of the folds of left_out, in their order
  // Of each experiment, by every subject of the data that knows its digit, muscles and joints, as
  // it was published and without a fit; the subject that the fit starts from comes first. Empty
  // where nothing is left out.
  std::vector<BaselinePrediction> published = {};
  // With a net, where something is left out and the subject has a hood rule.
  std::optional<FractionsFit> fractions = {};
};

/// Reads fit settings by name or file; without a name, the built-in ones for the digit.
/// @param data  folder with fits/; empty: the usual ones
/// @throws InputError if there are none of that name, or they cannot be read.
[[nodiscard]] SourceText fit_settings_source(const std::string& settings, const std::string& digit,
                                             const std::string& data);

// Tendon paths of a fit are straight between via points, even where other questions wrap them.

/// @throws InputError for paths that the force model of a fit cannot have; absent paths and via
/// points are accepted.
void require_fit_path(const std::optional<Path>& path);

/// Returns a warning if tendons of the subject wrap by default but its fit does not wrap them; else
/// nothing.
[[nodiscard]] std::vector<std::string> path_cautions(const FitInputs& inputs);

/// Returns the texts of the inputs; without settings, the built-in ones for the digit.
/// @throws InputError or DataError for a source that is not there or cannot be read.
[[nodiscard]] FitInputs read_fit_inputs(const FitSources& sources);

/// Fits, writes the result file, and cross-validates.
/// @throws InputError or DataError as the readers and builders do.
[[nodiscard]] FitResult fit_digit(const FitRequest& request, const Progress& progress = {});

/// Returns the value named "posture", "tendon" or "specimen". @throws InputError naming these for
/// anything else.
[[nodiscard]] LeaveOut leave_out_named(const std::string& name);

/// Returns the file of an experiment given by its file or its name.
/// @param field  field of the request, which errors name
/// @throws InputError listing the searched folders.
[[nodiscard]] std::string experiment_file(const std::string& name_or_path, const std::string& data,
                                          const char* field = "experiments");

/// Returns predictions of the experiments of a fit in their order, with predictive sds.
[[nodiscard]] std::vector<Prediction> predict_own(const Fit& fit);

/// Returns the digit with the fitted parameters of a specimen.
/// @param specimen  index in fit.problem.specimens()
[[nodiscard]] TendonDigit fitted_digit(const Fit& fit, int specimen);

}  // namespace thenar
