#pragma once

/// Forces that a fit predicts, also for specimens that it has never seen.

#include <optional>
#include <string>
#include <vector>

#include "base/fidelity.h"
#include "base/run_record.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/prediction.h"
#include "solvers/status.h"

namespace thenar {

/// Parameters that predict: those of the specimen or of the population, and whether the fit has
/// seen the specimen.
enum class PredictedBy {
  kOwn,            // the specimen's own, which were fitted
  kOwnPopulation,  // the population's, which it was a part of
  kStranger        // the population's; it was not fitted
};

struct PredictRequest {
  std::string fit;                       // result of a fit (.h5)
  std::vector<std::string> experiments;  // files, or names of experiments/
  bool population = false;               // predict a fitted specimen as if it had never been seen
  std::string data;                      // folder with experiments/; empty: the usual ones
  std::optional<Path> path = {};         // tendon paths, see require_fit_path()
};

/// One experiment with its prediction.
struct PredictedExperiment {
  Experiment experiment;
  Prediction prediction;  // prediction with predictive sds
  PredictedBy by = PredictedBy::kStranger;
};

struct PredictResult {
  PredictRequest request;           // request; where draws predict, its fit is the posterior
  Outcome outcome;                  // warnings: of the fit and of each experiment
  FitInputs inputs;                 // inputs of the fit
  RunRecord fitted_by;              // the run that wrote the file; empty in older files
  Fidelity fidelity;                // fidelity of the digit
  std::vector<SourceText> sources;  // texts of the experiments
  std::vector<PredictedExperiment> experiments;
};

/// Predicts every experiment by a fit, and compares with what was measured.
/// @throws DataError or InputError if the file is no fit, or an experiment does not suit its digit.
[[nodiscard]] PredictResult predict_forces(const PredictRequest& request);

/// @param specimen    index in fitted.specimens(), or kUnfittedSpecimen
/// @param population  asked for, also of a fitted specimen
[[nodiscard]] PredictedBy predicted_by(int specimen, bool population);

/// Adds what one could say of each trial without a model: of a specimen that was not fitted the
/// mean of those that were, of combined loads on a fitted one the sum of its own forces.
[[nodiscard]] Prediction beside_trivial_forces(Prediction prediction, const Experiment& experiment,
                                               const FitProblem& fitted, PredictedBy by);

/// Returns an experiment whose trials are to be predicted.
/// @throws DataError as parse_experiment(); InputError if it has no trials.
[[nodiscard]] Experiment read_trials(const SourceText& source);

/// Returns warnings about a prediction of the experiment by this fit.
[[nodiscard]] std::vector<std::string> prediction_warnings(const FitProblem& fitted,
                                                           const Experiment& experiment);

}  // namespace thenar
