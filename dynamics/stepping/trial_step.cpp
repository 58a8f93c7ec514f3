#include "dynamics/stepping/trial_step.h"

#include <cmath>
#include <limits>

#include "dynamics/stepping/fixed_step.h"
#include "dynamics/stepping/mode_change.h"

namespace thenar {
namespace {

constexpr int kModeChangeColumns = 4;       // number of columns if a mode changes within the step
constexpr double kOrderRatio = 0.1;         // allowed difference of two orders over the tolerance:
                                            // high orders differ little, and errors add up [1]
constexpr double kOrderRounding = 1e-12;    // rounding error of the difference of orders [m], [rad]
constexpr double kSpeedErrorTime = 0.01;    // time that converts velocity errors of smooth steps
                                            // to position errors [s]
constexpr double kMinClosingSpeed = 1e-12;  // closing speed below which it counts as this [m/s]

}  // namespace

StepTrials::StepTrials(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
                       const SceneState& like)
    : step_(step),
      options_(options),
      counts_(counts),
      free_(step),
      extrapolation_(like, options.columns) {
  for (StepTrial& column : table_) column.state = like;
}

void StepTrials::try_step(const Beginning& from, double length) {
  checked_end_ = false;
  extrapolation_.restart();
  counts_.clear();
  step_.select_active_forces(from.state.t);
  if (from.closed.empty() && !step_.is_stiff(from.state, length))
    return take_free_step(from, length);
  // Add columns of 1, 2, .. substeps and extrapolate them while no mode changes.
  bool smooth = true;
  for (int n = 1; n <= options_.columns; ++n) {
    StepTrial& column = table_[n - 1];
    result_ = n - 1;
    if (!take_substeps(from, length, n, column)) return;
    smooth = smooth && column.is_smooth && same_modes(column.active, table_[0].active);
    column.is_smooth = smooth;
    if (smooth ? extrapolate_column(column, n) : n >= kModeChangeColumns) break;
  }
  StepTrial& last = result();
  if (!smooth) {
    // If a mode changes, take the finest column; its difference from the previous one is the error.
    last.order = 2;
    last.error = scaled_difference(last.state, table_[result_ - 1].state, 1);
    // If friction reverses within the first substep, all columns have the same error: up to twice
    // the slip before.
    last.error =
        std::max(last.error, 2 * max_reversed_slip(from.closed, last.active) / options_.tolerance);
  }
  // Check the gaps of the extrapolated positions.
  if (last.error <= 1 || length <= options_.min_step) check_end(from, length, last);
}

/// Extrapolates with a further column, of n substeps. @return true if the trial ends with it,
/// accepted or rejected; it then holds the extrapolated state
bool StepTrials::extrapolate_column(StepTrial& column, int n) {
  // Estimate the error by the difference of the two highest orders.
  extrapolation_.add_column(column.state, n);
  if (n < 2) return false;
  const double ratio = std::max(kOrderRatio, std::min(1.0, kOrderRounding / options_.tolerance));
  column.error = scaled_difference(extrapolation_.highest_order(), extrapolation_.lower_order(),
                                   kSpeedErrorTime) /
                 ratio;
  if (!extrapolation_.judge(column.error)) return false;
  // Store the extrapolated state in the column.
  column.order = n;
  column.state = extrapolation_.highest_order();
  step_.normalise_quaternions(column.state.q);
  return true;
}

/// Integrates one column of n substeps. @return false if a gap closes or a number overflows
bool StepTrials::take_substeps(const Beginning& from, double length, int n, StepTrial& column) {
  // Start from the state and contacts, with impulses scaled to the substep.
  column.state = from.state;
  column.active = from.closed;
  column.h = length / n;
  column.is_smooth = true;
  column.closing_time = column.change_time = -1;
  column.error = 0;
  earlier_contacts_.clear();
  scale_impulses(column.active, from.impulse_time > 0 ? column.h / from.impulse_time : 0);
  // Take substeps until a gap closes or a number overflows.
  for (int i = 0; i < n; ++i) {
    step_.take_euler_substep(column.state, column.h, column.active, options_.touch, outcome_);
    counts_.count_problem(outcome_);
    if (outcome_.min_new_gap < -options_.touch) {
      column.closing_time = estimate_closing_time(column.h, i);
      return false;
    }
    // Record the first mode change, at the instant that the margins predict.
    if (column.is_smooth && !same_modes(column.active, outcome_.active)) {
      column.is_smooth = false;
      column.change_time = column.h * (i + fraction_before_change(earlier_contacts_, column.active,
                                                                  outcome_.active));
    }
    // Keep the contacts of this substep and of the previous one.
    earlier_contacts_.swap(column.active);
    column.active.swap(outcome_.active);
    if (!column.state.v.allFinite() || !column.state.z.allFinite()) {
      column.error = std::numeric_limits<double>::infinity();
      return false;
    }
  }
  return true;
}

/// Estimates when the gap of the last substep closed, at constant closing speed; time from the
/// start of the step [s]. @param h  length of a substep [s];  @param substep  its index
double StepTrials::estimate_closing_time(double h, int substep) const {
  const double since =
      -outcome_.min_new_gap / std::max(outcome_.new_closing_speed, kMinClosingSpeed);
  return h * (substep + 1) - std::min(since, h);
}

/// Computes the largest difference of two states over the tolerance [1].
/// @param horizon  time that converts velocity errors to position errors [s]
double StepTrials::scaled_difference(const SceneState& a, const SceneState& b,
                                     double horizon) const {
  double difference =
      std::max((a.q - b.q).cwiseAbs().maxCoeff(), horizon * (a.v - b.v).cwiseAbs().maxCoeff());
  // The last state, the work of elements, is an output only.
  const Eigen::Index states = a.z.size() - 1;
  if (states > 0)
    difference = std::max(difference, horizon * (a.z - b.z).head(states).cwiseAbs().maxCoeff());
  return difference / options_.tolerance;
}

/// Takes one step of order eight, without contacts.
void StepTrials::take_free_step(const Beginning& from, double length) {
  // Reset the trial.
  StepTrial& trial = table_[0];
  result_ = 0;
  trial.active.clear();
  trial.order = 8;
  trial.is_smooth = true;
  trial.closing_time = trial.change_time = -1;
  trial.h = length;
  // Integrate, with the error over the tolerance.
  trial.state = from.state;
  const FreeStep::Error error = free_.take_step(step_, length, trial.state);
  trial.error =
      std::max(error.q, kSpeedErrorTime * std::max(error.v, error.z)) / options_.tolerance;
  counts_.count_free_step(error.acted);
  if (!is_finite(trial.state)) {
    trial.error = std::numeric_limits<double>::infinity();
    return;
  }
  counts_.count_stages(static_cast<long>(FreeStep::kStages));
  // Check for contacts on the way and at the end.
  check_middle(from, length, trial);
  if (trial.closing_time < 0) check_end(from, length, trial);
}

/// Checks for contacts in the middle of a free step, which may have opened again at its end. The
/// positions are those of the cubic through both ends with their velocities.
void StepTrials::check_middle(const Beginning& from, double length, StepTrial& trial) {
  if (length <= options_.min_step) return;
  // Compute the middle of the cubic: mean of the ends plus length / 8 times the velocity
  // difference.
  middle_.t = from.state.t + 0.5 * length;
  middle_.q = 0.5 * (from.state.q + trial.state.q);
  step_.normalise_quaternions(middle_.q);
  middle_.v = from.state.v - trial.state.v;
  advance_positions(step_.scene().mechanism, step_.model().layout, middle_.v, 0.125 * length,
                    middle_.q);
  // Find new contacts there.
  middle_.v = 0.5 * (from.state.v + trial.state.v);
  step_.find_contacts(middle_, 0, found_);
  step_.find_deepest_new(found_, trial.active, outcome_);
  if (outcome_.min_new_gap < -options_.touch)
    trial.closing_time = std::max(estimate_closing_time(0.5 * length, 0), 0.125 * length);
}

/// Checks for new contacts at the end of a trial, and for bodies that passed through each other.
void StepTrials::check_end(const Beginning& from, double length, StepTrial& trial) {
  // Find new contacts at the end.
  checked_end_ = true;
  step_.find_contacts(trial.state, kSearchMargin, found_);
  step_.find_deepest_new(found_, trial.active, outcome_);
  if (outcome_.min_new_gap < -options_.touch) trial.closing_time = estimate_closing_time(length, 0);
  // Reject a motion in which bodies may have passed through each other.
  const double ratio = step_.tunnelling_ratio(from.state, trial.state, trial.active);
  if (ratio > 1 && length > options_.min_step) {
    trial.error = std::max(trial.error, std::pow(ratio, trial.order));
    trial.closing_time = -1;
  }
}

void StepTrials::find_end_contacts() {
  if (!checked_end_) step_.find_contacts(result().state, kSearchMargin, found_);
}

}  // namespace thenar
