#include "posterior/posterior_data.h"

#include <cmath>

#include "posterior/simd_loops.h"

namespace thenar {
namespace {

/// Evaluates normal noise: all trials are one sum of squares.
DataDensity normal_density(const ObservedForces& data, const double* forces, double log_noise,
                           double* by_force) {
  // Weight the residuals of all trials.
  const double scale = std::exp(-2 * log_noise);
  const int count = data.plan.measured * data.trials;
  const double m =
      scale * internal::weigh_residuals(3 * data.trials, data.plan.force.data(), forces,
                                        data.precision.data(), scale, by_force);
  return {data.log_peak - count * log_noise - 0.5 * m, m - count};
}

/// Evaluates any noise model, trial by trial.
DataDensity trials_density(const ForceNoise& model, const ObservedForces& data,
                           const double* forces, double log_noise, double* by_force,
                           double* pointwise) {
  const double scale = std::exp(-2 * log_noise);
  (void)internal::weigh_residuals(3 * data.trials, data.plan.force.data(), forces,
                                  data.precision.data(), scale, by_force);
  DataDensity sum{0, 0};
  for (int i = 0; i < data.trials; ++i) {
    // Squared length of the trial's residual, in sds.
    const double* measured = data.plan.force.data() + 3 * i;
    const double* predicted = forces + 3 * i;
    double* by = by_force + 3 * i;
    double m = 0;
    for (int k = 0; k < 3; ++k) m += (measured[k] - predicted[k]) * by[k];
    // The tail weights the density and both derivatives.
    const ForceNoise::Tail tail = model.tail(m);
    for (int k = 0; k < 3; ++k) by[k] *= tail.weight;
    const double log_density =
        data.log_scale[i] - data.plan.measured * log_noise + tail.log_density;
    if (pointwise != nullptr) pointwise[i] = log_density;
    sum.log_density += log_density;
    sum.by_log_noise += tail.weight * m - data.plan.measured;
  }
  return sum;
}

}  // namespace

ObservedForces observed_forces(const TendonDigit& digit, const ExperimentPlan& plan,
                               const Experiment& experiment, const ForceNoise& model) {
  // Compute the constants of the trials, and add the unit pulls of the tasks.
  ObservedForces out{plan_activations(digit, plan, experiment), {}, {}, 0};
  out.precision = plan.sd.cwiseAbs2().cwiseInverse();
  Eigen::Matrix3Xd known = plan.sd;  // log 1 = 0: components that are not fitted do not contribute
  known.bottomRows(3 - plan.measured).setOnes();
  out.log_scale =
      model.log_constant(plan.measured) - known.array().log().colwise().sum().transpose();
  out.log_peak = out.log_scale.sum();
  return out;
}

DataDensity data_density(const ForceNoise& model, const ObservedForces& data, const double* forces,
                         double log_noise, double* by_force, double* pointwise) {
  // Evaluate the trials, at once if single values are not requested.
  const bool plain = std::isinf(model.c2) && pointwise == nullptr;
  DataDensity sum = plain ? normal_density(data, forces, log_noise, by_force)
                          : trials_density(model, data, forces, log_noise, by_force, pointwise);
  if (data.tasks.empty()) return sum;

  // Evaluate the tasks from the forces of their unit pulls.
  const auto columns = static_cast<Eigen::Index>(data.plan.force.cols());
  Eigen::Map<Eigen::Matrix3Xd> by(by_force, 3, columns);
  by.rightCols(columns - data.trials).setZero();
  for (std::size_t t = 0; t < data.tasks.size(); ++t) {
    const ActivationTask& task = data.tasks[t];
    Eigen::Matrix3Xd unit(3, static_cast<Eigen::Index>(task.pulls.size()));
    for (std::size_t j = 0; j < task.pulls.size(); ++j)
      unit.col(static_cast<Eigen::Index>(j)) =
          Eigen::Map<const Eigen::Vector3d>(forces + 3 * task.pulls[j].column);
    // Density of the task, and its derivatives by the unit pulls.
    const TaskDensity one =
        task_density(model, unit, task.pulls, task.force, task.sd, std::exp(log_noise));
    for (std::size_t j = 0; j < task.pulls.size(); ++j)
      by.col(task.pulls[j].column) += one.by_unit.col(static_cast<Eigen::Index>(j));
    if (pointwise != nullptr) pointwise[data.trials + t] = one.log_density;
    sum.log_density += one.log_density;
    sum.by_log_noise += one.by_log_noise;
  }
  return sum;
}

}  // namespace thenar
