#pragma once

/// Rows of muscle activations prepared for a digit: tensions with variances, and unit pulls.

#include <vector>

#include "kinematics_fit/model/experiment_plan.h"

namespace thenar {

/// Distribution of a muscle's tension in a task.
struct MuscleTension {
  int column = 0;       // column of the unit pull among all trials of ActivationPlan::plan
  double tension = 0;   // F0 a, expected [N]
  double variance = 0;  // (F0 sd)^2 [N^2]
};

/// Task with electromyography.
struct ActivationTask {
  std::vector<MuscleTension> pulls;  // tensions of the muscles
  Eigen::Vector3d force, sd;         // measured force and its sd [N] (3)
};

/// Trials of an experiment, followed by unit tensions of muscles in the postures of its tasks.
struct ActivationPlan {
  ExperimentPlan plan;  // plan with unit tensions as additional trials, of force 0 and sd 1
  int trials = 0;       // number of measured trials, which come first in the plan [1]
  std::vector<ActivationTask> tasks;
};

/// Adds unit pulls to the trials of a plan, one for each muscle and posture of the activation rows.
/// Tensions are F0 times the activation: muscles are at their optimal length and do not shorten.
/// @throws InputError if a row names an unknown muscle, or one of unknown max_force.
[[nodiscard]] ActivationPlan plan_activations(const TendonDigit& digit, const ExperimentPlan& plan,
                                              const Experiment& experiment);

/// Returns the plan without its trials: postures, tip constraint and load cell remain.
[[nodiscard]] ExperimentPlan without_trials(ExperimentPlan plan);

}  // namespace thenar
