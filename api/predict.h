#pragma once

/// Forces that a fit predicts, also for specimens that were not fitted.
///
///     PredictRequest request;
///     request.fit = "fit.h5";
///     request.experiments = {"synek2019_B01"};
///     const PredictResult predicted = predict_forces(request);

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/fidelity.h"
#include "base/run_record.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/prediction.h"
#include "solvers/status.h"

namespace thenar {

/// Parameters used for a prediction: those of the specimen or of the population, and whether the
/// specimen was fitted.
enum class PredictedBy {
  kOwn,            // the specimen's own, which were fitted
  kOwnPopulation,  // the population's, which includes it
  kStranger        // the population's, which does not include it
};

struct PredictRequest {
  std::string fit;                       // result of a fit (.h5); required
  std::vector<std::string> experiments;  // files, or names of experiments/; at least one
  bool population = false;               // predict a fitted specimen as if it had not been fitted
  std::string data;                      // folder with experiments/; empty: the usual ones
  std::optional<Path> path = {};         // tendon paths, see require_fit_path()
};

/// One experiment with its prediction.
struct PredictedExperiment {
  Experiment experiment;                    // experiment as its file states it
  Prediction prediction;                    // prediction with predictive sds
  PredictedBy by = PredictedBy::kStranger;  // parameters that predict it
};

struct PredictResult {
  PredictRequest request;           // request; where draws predict, its fit is the posterior
  Outcome outcome;                  // stalled: the fit has not converged; warnings: of the fit and
                                    // of each experiment
  FitInputs inputs;                 // inputs of the fit
  RunRecord fitted_by;              // the run that wrote the file; empty in older files
  Fidelity fidelity;                // fidelity of the digit
  std::vector<SourceText> sources;  // texts of the experiments
  std::vector<PredictedExperiment> experiments;  // predictions, as requested
};

/// Predicts every experiment by a fit, and compares with the measurements.
/// @throws DataError or InputError if the file is no fit, or an experiment does not match its
///         digit.
[[nodiscard]] PredictResult predict_forces(const PredictRequest& request);

/// Returns the parameters that predict a specimen. @param specimen  index in fitted.specimens(), or
/// kUnfittedSpecimen
/// @param population  use the population's, also for a fitted specimen
[[nodiscard]] PredictedBy predicted_by(int specimen, bool population);

/// Adds a baseline without a model for each trial: for a specimen that was not fitted, the mean of
/// the fitted ones; for combined loads on a fitted one, the sum of its own forces.
[[nodiscard]] Prediction beside_trivial_forces(Prediction prediction, const Experiment& experiment,
                                               const FitProblem& fitted, PredictedBy by);

/// Reads an experiment whose trials are to be predicted.
/// @throws DataError as parse_experiment(); InputError if it has no trials.
[[nodiscard]] Experiment read_trials(const SourceText& source);

/// Prediction of an experiment by the parameters of a specimen, see predicted_by().
using PredictSpecimen = std::function<Prediction(const Experiment& experiment, int specimen)>;

/// Predicts the experiments of result.request, and adds them, their texts and warnings to `result`.
/// @throws as predict_forces()
void add_predictions(const FitProblem& problem, const PredictSpecimen& predict,
                     PredictResult& result);

/// Returns warnings about a prediction of the experiment by this fit.
[[nodiscard]] std::vector<std::string> prediction_warnings(const FitProblem& fitted,
                                                           const Experiment& experiment);

}  // namespace thenar
