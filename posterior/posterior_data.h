#pragma once

/// Measurements of one experiment in the form that the likelihood needs.

#include "kinematics_fit/kernel/force_kernel.h"
#include "posterior/force_density.h"

namespace thenar {

/// Measured trials, followed by unit tensions of muscles in the postures of its tasks, with what
/// their density needs.
struct ObservedForces : ActivationPlan {
  Eigen::Matrix3Xd precision;  // 1 / sd^2 of the trials, 0 if not fitted [1/N^2] (3, trials)
  Eigen::VectorXd log_scale;   // log density of each trial at its measured force (trials)
  double log_peak = 0;         // their sum [1]
};

/// @throws InputError if a task names a muscle the digit has not, or one of unknown max_force.
[[nodiscard]] ObservedForces observed_forces(const TendonDigit& digit, const ExperimentPlan& plan,
                                             const Experiment& experiment, const ForceNoise& model);

/// Log likelihood of all measurements of an experiment at one point, with derivatives.
/// @param forces     of all columns of the plan (3 columns)
/// @param log_noise  logarithm of a factor on sds [1]
/// @param by_force   receives d/d forces (3 columns)
/// @param pointwise  receives the summands: trials, then tasks; may be null
/// @return {log likelihood, derivative by log noise}
struct DataDensity {
  double log_density, by_log_noise;
};
[[nodiscard]] DataDensity data_density(const ForceNoise& model, const ObservedForces& data,
                                       const double* forces, double log_noise, double* by_force,
                                       double* pointwise);

}  // namespace thenar
