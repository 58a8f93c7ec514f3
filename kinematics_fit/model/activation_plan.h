#pragma once

/// Rows of muscle activations prepared for a digit: tensions with variances, and unit pulls.

#include <vector>

#include "kinematics_fit/model/experiment_plan.h"

namespace thenar {

/// Distribution of a muscle's tension in a task.
struct MuscleTension {
  int column;       // of the unit pulls' forces
  double tension;   // F0 a, expected [N]
  double variance;  // (F0 sd)^2 [N^2]
};

/// One task with electromyography.
struct ActivationTask {
  std::vector<MuscleTension> pulls;  // column: of all trials of ActivationPlan::plan
  Eigen::Vector3d force, sd;         // [N] (3)
};

/// Trials of an experiment, followed by unit tensions of muscles in the postures of its tasks.
struct ActivationPlan {
  ExperimentPlan plan;  // with the unit tensions as further trials, of force 0 and sd 1
  int trials = 0;       // measured trials, the first of the plan [1]
  std::vector<ActivationTask> tasks;
};

/// Adds unit pulls to the trials of a plan, one for each muscle and posture of the activation rows.
/// Muscles are taken at their optimal length and at rest: F0 times the activation.
/// @throws InputError if a row names a muscle the digit has not, or one of unknown max_force.
[[nodiscard]] ActivationPlan plan_activations(const TendonDigit& digit, const ExperimentPlan& plan,
                                              const Experiment& experiment);

/// The plan without its trials: postures, hold and load cell remain.
[[nodiscard]] ExperimentPlan without_trials(ExperimentPlan plan);

}  // namespace thenar
