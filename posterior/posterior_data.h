#pragma once

/// Measurements of one experiment in the form needed by the likelihood.

#include "kinematics_fit/kernel/force_kernel.h"
#include "posterior/force_density.h"

namespace thenar {

/// Measured trials, followed by unit muscle tensions in the postures of the experiment's tasks,
/// with the constants of their density.
struct ObservedForces : ActivationPlan {
  Eigen::Matrix3Xd precision;  // 1 / sd^2 of the trials, 0 if not fitted [1/N^2] (3, trials)
  Eigen::VectorXd log_scale;   // log density of each trial at its measured force (trials)
  double log_peak = 0;         // sum of log_scale [1]
};

/// Collects the measurements of an experiment.
/// @throws InputError if a task names an unknown muscle, or one of unknown max_force.
[[nodiscard]] ObservedForces observed_forces(const TendonDigit& digit, const ExperimentPlan& plan,
                                             const Experiment& experiment, const ForceNoise& model);

/// Log likelihood of all measurements of an experiment at one point, with its derivative.
struct DataDensity {
  double log_density = 0, by_log_noise = 0;  // log likelihood, and its derivative by log_noise [1]
};
/// Computes the log likelihood of all measurements of an experiment at one point.
/// @param forces     predicted forces of all columns of the plan (3 columns)
/// @param log_noise  logarithm of a factor on the sds [1]
/// @param by_force   receives the derivative by `forces` (3 columns)
/// @param pointwise  receives the summands: trials, then tasks; may be null
[[nodiscard]] DataDensity data_density(const ForceNoise& model, const ObservedForces& data,
                                       const double* forces, double log_noise, double* by_force,
                                       double* pointwise);

}  // namespace thenar
