#pragma once

/// Information about a thumb's axes in the few published measurements of its force: draws of a
/// prior or a posterior are weighted by the likelihood of the measurements.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"
#include "sampling/diagnostics/importance.h"
#include "tendons/forces/key_pinch.h"

namespace thenar {

/// Files of the measurements.
struct MeasuredThumbInputs {
  SourceText force;   // an experiment: forces of the tip under tendon loads, with sds
  SourceText losses;  // losses of pinch under nerve blocks
};

/// Reads files of a folder with experiments/ and studies/. @throws DataError if a file cannot be
/// read.
[[nodiscard]] MeasuredThumbInputs measured_thumb_inputs(const std::string& data);

/// Predictions of the measurements by models, one column for each draw.
struct MeasuredPredictions {
  Eigen::MatrixXd force;  // forces of all trials, tip pinned, in the experiment's components [N] (3
                          // trials, draws)
  Eigen::MatrixXd clamped;  // forces of all trials, tip clamped [N] (3 trials, draws)
  Eigen::VectorXd intact;   // pinch with all muscles [N] (draws); NaN: undecided
  Eigen::MatrixXd loss;     // loss of pinch force, NaN where `intact` is below kMinPinchForce or a
                            // program is undecided [1] (blocks, draws)
  Eigen::VectorXi undecided;  // programs of each draw, PinchStrength::undecided [1] (draws)
};

/// Measurements that are added to a prior or a posterior.
struct AddedData {
  std::string name;      // "FPL's force", in words
  bool force = false;    // the experiment's forces
  bool losses = false;   // the losses of pinch
  double sd_factor = 1;  // factor on the sds of forces [1]
  bool clamped = false;  // forces of a clamped tip in place of a pinned one
};

/// Returns the tested additions: both measurements, each alone, and forces with other sds or
/// another hold.
[[nodiscard]] std::vector<AddedData> additions_to_ask();

/// Draws updated by an addition.
struct DataUpdate {
  AddedData added;
  std::string message;        // why there are no tilts; empty: there are
  ImportanceWeights weights;  // weights of the draws
  WeightedSpread tilts;       // spread of ReweightedDraws::tilts [rad]
};

/// Draws of a prior or a posterior, and their updates.
struct ReweightedDraws {
  std::string name;                // "before any data"
  std::vector<std::string> names;  // names of tilts: "axis/CMC1_FE/direction/1"
  Eigen::MatrixXd tilts;           // values of these parameters [rad] (tilts, draws)
  MeasuredPredictions predicted;
  std::vector<DataUpdate> updates;  // updates by additions_to_ask(), in this order
};

/// Measurements, and the information that they add with and without simulated data.
struct MeasuredLessons {
  MeasuredThumbInputs inputs;
  Experiment force;
  PinchLosses losses;
  MeasuredPredictions truth;  // predictions of the thumb behind the simulated data: one column
  std::vector<ReweightedDraws> reweighted;  // the prior, and the posterior of simulated data
  bool complete = false;
};

struct MeasuredLessonsSettings {
  long prior_draws = 10000;     // [1]
  long posterior_draws = 3000;  // largest number of posterior draws, evenly thinned [1]
  Progress progress;
};

/// Computes the predictions of both measurements by digits.
/// @param digit   digit whose model the draws replace
/// @param models  one model for each draw
/// @throws InputError if the experiment or the losses do not fit the digit.
[[nodiscard]] MeasuredPredictions predict_measured(const TendonDigit& digit,
                                                   const std::vector<TendonModel<double>>& models,
                                                   const Experiment& force,
                                                   const PinchLosses& losses,
                                                   const Progress& progress = {});

/// Returns the log likelihood of the added measurements, up to a constant [1] (draws):
///   - 1/2 sum ((f - f_measured) / (factor sd))^2 - 1/2 sum ((loss - measured) / sd)^2,
/// -inf where losses are added but there is no pinch force, or a loss is undecided.
[[nodiscard]] Eigen::VectorXd log_likelihood(const MeasuredPredictions& predicted,
                                             const Experiment& force, const PinchLosses& losses,
                                             const AddedData& added);

/// Updates tilts by weights in proportion to a likelihood. There is a message instead if no draw
/// has a likelihood above 0, or one draw has all the weight.
/// @param tilts           draws as columns (tilts, draws)
/// @param log_likelihood  log likelihood of each draw [1] (draws)
/// @param chains          number of chains, whose draws follow one another; 0: draws are
///         independent
[[nodiscard]] DataUpdate update_tilts(const AddedData& added,
                                      const Eigen::Ref<const Eigen::MatrixXd>& tilts,
                                      const Eigen::Ref<const Eigen::VectorXd>& log_likelihood,
                                      int chains);

/// Weights draws of the prior of a run, and of its posterior, by the measurements. The same run
/// gives bitwise equal results.
/// @param run    run of a digit of one specimen, whose settings free tilts of axes
/// @param truth  true digit behind the simulated data of the run
[[nodiscard]] MeasuredLessons reweight_by_measurements(const MeasuredThumbInputs& inputs,
                                                       const PosteriorRun& run,
                                                       const TendonDigit& truth,
                                                       const MeasuredLessonsSettings& settings);

}  // namespace thenar
