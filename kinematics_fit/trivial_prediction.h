#pragma once

/// Trivial prediction of a fingertip force, without a model: the mean of measurements by others
/// under the same load. It is the baseline for predictions of unseen specimens.

#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "kinematics_fit/prediction.h"

namespace thenar {

/// Predicts the force of a trial as the mean force per tension in equal rows of others, times the
/// tension of this trial, in the axes of its experiment [N] (3). Rows are equal if the same muscles
/// pull, in the same proportion within 10 %, at the same joint angles within 2 degrees. If this
/// posture was not measured, the mean is over other postures: those of the same specimen, or else
/// of all. If these muscles were not loaded together, it is the sum of such means, one per muscle.
/// @param seen  experiments available to the prediction; may include `experiment`, but without the
///         trial
/// @return nothing if no such load was measured, or only with fewer components
[[nodiscard]] std::optional<Eigen::Vector3d> trivial_force(const Experiment& experiment,
                                                           const Trial& trial,
                                                           const std::vector<Experiment>& seen);

/// Predicts by superposition: the sum of the forces of the same specimen in this posture under each
/// of the loads alone, each in proportion to its tension, in the axes of the experiment [N] (3). A
/// linear model cannot do better; the remaining error is the specimen's nonlinearity and noise.
/// @return nothing unless several muscles pull and each was measured alone
[[nodiscard]] std::optional<Eigen::Vector3d> superposed_force(const Experiment& experiment,
                                                              const Trial& trial,
                                                              const std::vector<Experiment>& seen);

/// Errors of the model and of the trivial prediction, over the trials that have one.
struct BesideTrivial {
  ForceError model;
  ForceError trivial;  // without predictive intervals
};

/// Compares the errors.
/// @return nothing if no trial has a trivial prediction, or all their measured forces are zero
[[nodiscard]] std::optional<BesideTrivial> beside_trivial(const Prediction& prediction);

/// Root mean squares over the trials of one load, by component.
struct ErrorsOfLoad {
  std::string loads;         // "FDS" or "FDS+EDC"
  int trials = 0;            // number of trials [1]
  Eigen::Vector3d measured;  // rms of the measured force [N] (3)
  Eigen::Vector3d model;     // rms error of the model [N] (3)
  Eigen::Vector3d trivial;   // rms error of the trivial prediction [N] (3)
};

/// Computes the errors of every load with a trivial prediction, over the trials that have one, in
/// the order of the trials.
[[nodiscard]] std::vector<ErrorsOfLoad> errors_by_load(const Prediction& prediction);

/// Prediction of an experiment by a baseline without a fit.
struct BaselinePrediction {
  std::string name;
  std::string data_seen;  // description of the data that it used
  Prediction prediction;
};

/// Predicts an experiment by a subject without any fit: no friction, in-plane hold, all shifts
/// zero.
[[nodiscard]] Prediction predict_as_published(const SourceText& subject,
                                              const Experiment& experiment);

/// Predicts every trial by the mean of the trials with the same loads in other postures, a baseline
/// without a model. Trials without such others are left out.
[[nodiscard]] Prediction mean_of_other_postures(const Experiment& experiment);

}  // namespace thenar
