#pragma once

/// Simulated tasks of a thumb with electromyography and a load cell, and the misfits of a model.

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Options of simulated tasks: postures x 5 directions x people, 80 by default, the number of
/// [ValeroCuevas2003].
struct TaskOptions {
  int postures = 2;     // number of leading thumb_postures() [1]
  int people = 8;       // number of people, who share the load among their muscles differently [1]
  double force = 20;    // target force, palmar, dorsal, radial, ulnar and distal [N]
  double habit = 0.5;   // sd of the logarithm of the cost of each person's muscles [1]
  double noise = 0.1;   // relative noise of the force, see SimulatedPullOptions::noise [1]
  double floor = 0.01;  // sd floor of the force [N]
  double activation_sd = 0.05;  // sd of electromyography [1]
  unsigned seed = 1;
};

/// Simulates tasks. Each person takes the activations  0 <= a <= 1  that minimise
///   |R' F0 a - J' f|^2 / (0.1 N m)^2 + sum (c_i a_i)^2 / 100,   log c_i ~ N(0, habit^2):
/// the target force with the smallest unbalanced torque that the thumb allows. The resulting tip
/// force (tip_force()) is measured with noise; measured activations are clamped to 0 .. 1.
[[nodiscard]] Experiment simulate_tasks(const TendonDigit& truth, const TaskOptions& options);

/// Misfit of a model in one task, driven by the measured activations.
struct TaskMisfit {
  double direction;  // angle between its tip force and the measured one [rad]
  double torque;     // unbalanced joint torque |R' t - J' f|, f the measured force [N m]
  double distance;   // r' S^-1 r of the measured force, S from noise and activations [1]
};

/// Returns the misfits of all tasks of the experiment.
[[nodiscard]] std::vector<TaskMisfit> task_misfits(const TendonDigit& model,
                                                   const Experiment& tasks);

/// 95 % quantile of chi squared with three degrees of freedom; a task with a smaller distance is
/// explained [1].
inline constexpr double kChiSquare3At95 = 7.814728;

}  // namespace thenar
