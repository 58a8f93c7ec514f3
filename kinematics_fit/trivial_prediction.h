#pragma once

/// The trivial prediction of a fingertip force, without a model: the mean of what others measured
/// under the same load. A model that does no better has learnt nothing about strangers.

#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "kinematics_fit/prediction.h"

namespace thenar {

/// Mean force per tension of the same row of others, times the tension of this trial, in the axes
/// of its experiment [N] (3). A row is the same where the same muscles pull, in the same proportion
/// within 10 %, at the same joint angles within 2 degrees. Where nobody has measured this posture,
/// it is the mean over other postures: those of the same specimen, or else of all. Where nobody has
/// loaded these muscles together, it is the sum of such means, one for each muscle alone.
/// @param seen  experiments that the prediction may know; `experiment` itself only without the
/// trial
/// @return empty if nobody measured such a load, or measured fewer components of it
[[nodiscard]] std::optional<Eigen::Vector3d> trivial_force(const Experiment& experiment,
                                                           const Trial& trial,
                                                           const std::vector<Experiment>& seen);

/// Superposition: the sum of the forces that the same specimen showed in this posture under each of
/// the loads alone, each in proportion to its tension, in the axes of the experiment [N] (3). A
/// linear model can do no better; what it errs by is the nonlinearity of the specimen and noise.
/// @return empty unless several muscles pull and each was measured alone
[[nodiscard]] std::optional<Eigen::Vector3d> superposed_force(const Experiment& experiment,
                                                              const Trial& trial,
                                                              const std::vector<Experiment>& seen);

/// Errors of the model and of the trivial prediction, over the trials that have one.
struct BesideTrivial {
  ForceError model;
  ForceError trivial;  // without intervals
};

/// @return empty if no trial has a trivial prediction, or all those measured forces are zero
[[nodiscard]] std::optional<BesideTrivial> beside_trivial(const Prediction& prediction);

/// Root mean squares over the trials of one load, component by component.
struct ErrorsOfLoad {
  std::string loads;         // "FDS" or "FDS+EDC"
  int trials = 0;            // [1]
  Eigen::Vector3d measured;  // [N] (3)
  Eigen::Vector3d model;     // of predicted - measured [N] (3)
  Eigen::Vector3d trivial;   // the same of the trivial prediction [N] (3)
};

/// Computes the errors of every load that has a trivial prediction, over the trials that have one,
/// in the order of the trials.
[[nodiscard]] std::vector<ErrorsOfLoad> errors_by_load(const Prediction& prediction);

/// Prediction of an experiment by a baseline without a fit.
struct BaselinePrediction {
  std::string name;
  std::string data_seen;  // the data that it has used
  Prediction prediction;
};

/// Predicts an experiment by a subject without any fit: no friction, in-plane hold, all shifts
/// zero.
[[nodiscard]] Prediction predict_as_published(const SourceText& subject,
                                              const Experiment& experiment);

/// Predicts every trial by the mean of the trials with the same loads in other postures, a baseline
/// without any model. Trials without such others are left out.
[[nodiscard]] Prediction mean_of_other_postures(const Experiment& experiment);

}  // namespace thenar
