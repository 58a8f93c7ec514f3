#include "dynamics/stepping/trial_step.h"

#include <cmath>
#include <limits>

#include "dynamics/stepping/fixed_step.h"
#include "dynamics/stepping/mode_change.h"

namespace thenar {
namespace {

constexpr int kRoughColumns = 4;          // of steps in which a mode changes
constexpr double kOrderShare = 0.1;       // of the tolerance that two orders may differ by: high
                                          // orders differ little, and steps add up [1]
constexpr double kOrderRounding = 1e-12;  // two orders differ by at least that much [m], [rad]
constexpr double kSpeedErrorTime =
    0.01;  // over which an error of speeds counts in smooth steps [s]

bool all_numbers(const SceneState& state) {
  return state.q.allFinite() && state.v.allFinite() && state.z.allFinite();
}

}  // namespace

StepTrials::StepTrials(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
                       const SceneState& like)
    : step_(step),
      options_(options),
      counts_(counts),
      free_(step),
      columns_(like, options.columns) {
  for (StepTrial& column : table_) column.state = like;
}

void StepTrials::attempt(const Beginning& from, double length) {
  inspected_ = false;
  verdict_ = Verdict::kGoOn;
  counts_.forget();
  step_.act_as_at(from.state.t);
  if (from.closed.empty() && !step_.is_stiff(from.state, length)) return free_step(from, length);
  // Columns of ever more substeps, extrapolated while no mode changes.
  columns_.restart();
  bool smooth = true;
  for (int n = 1; n <= options_.columns; ++n) {
    StepTrial& column = table_[static_cast<std::size_t>(n - 1)];
    result_ = n - 1;
    if (!substeps(from, length, n, column)) return;
    smooth = smooth && column.smooth && same_modes(column.active, table_[0].active);
    column.smooth = smooth;
    if (smooth ? extrapolates(column) : n >= kRoughColumns) break;
  }
  StepTrial& last = result();
  if (!smooth) {
    // After a change of modes nothing is extrapolated: the finest column counts, and its difference
    // to the one before is the error.
    last.order = 2;
    last.error = difference(last.state, table_[static_cast<std::size_t>(result_ - 1)].state, 1);
    // A first substep that friction turns round within is wrong by as much in all columns: the
    // speed by up to twice what there was to lose.
    last.error =
        std::max(last.error, 2 * slip_that_turned(from.closed, last.active) / options_.tolerance);
    verdict_ = Verdict::kGoOn;
  }
  // Extrapolated positions have gaps of their own: look for contacts there.
  if (last.error <= 1 || length <= options_.shortest) inspect(from, length, last);
}

/// Returns whether another column is of no use, since this one is good enough or all will not be.
/// It then has the extrapolated state.
bool StepTrials::extrapolates(StepTrial& column) {
  // Error by the difference of the two highest orders, over the tolerance.
  columns_.add(column.state);
  if (columns_.columns() < 2) return false;
  const double share = std::max(kOrderShare, std::min(1.0, kOrderRounding / options_.tolerance));
  column.error = difference(columns_.best(), columns_.lower(), kSpeedErrorTime) / share;
  verdict_ = columns_.judge(column.error);
  if (verdict_ == Verdict::kGoOn) return false;
  // Accepted or rejected: the column gets the extrapolated state.
  column.order = columns_.columns();
  column.state = columns_.best();
  step_.normalise(column.state.q);
  return true;
}

/// Takes one column: n substeps. @return false if a gap closes within it
bool StepTrials::substeps(const Beginning& from, double length, int n, StepTrial& column) {
  // State, contacts and impulses at the beginning.
  column.state = from.state;
  column.active = from.closed;
  column.h = length / n;
  column.smooth = true;
  column.closes = column.changes = -1;
  column.error = 0;
  earlier_.clear();
  scale_impulses(column.active, from.impulse_time > 0 ? column.h / from.impulse_time : 0);
  // Substeps, until a gap closes or a number overflows.
  for (int i = 0; i < n; ++i) {
    step_.substep(column.state, column.h, column.active, options_.touch, outcome_);
    counts_.count(outcome_);
    if (outcome_.deepest_new < -options_.touch) {
      column.closes = closing_time(column.h, i);
      return false;
    }
    // First change of modes, at the share of the substep that the margins foretell.
    if (column.smooth && !same_modes(column.active, outcome_.active)) {
      column.smooth = false;
      column.changes =
          column.h * (i + share_before_change(earlier_, column.active, outcome_.active));
    }
    // Contacts of this substep and of the one before.
    earlier_.swap(column.active);
    column.active.swap(outcome_.active);
    if (!column.state.v.allFinite() || !column.state.z.allFinite()) {
      column.error = std::numeric_limits<double>::infinity();
      return false;
    }
  }
  return true;
}

/// Instant at which the gap of the last substep closed, if it closed evenly [s].
double StepTrials::closing_time(double h, int substep) const {
  const double since = -outcome_.deepest_new / std::max(outcome_.closing_new, 1e-12);
  return h * (substep + 1) - std::min(since, h);
}

/// Largest difference of two states over the tolerance [1]. @param horizon  of speeds [s]
double StepTrials::difference(const SceneState& a, const SceneState& b, double horizon) const {
  double most =
      std::max((a.q - b.q).cwiseAbs().maxCoeff(), horizon * (a.v - b.v).cwiseAbs().maxCoeff());
  // The work of elements, the last state, is told and steers nothing.
  const Eigen::Index states = a.z.size() - 1;
  if (states > 0) most = std::max(most, horizon * (a.z - b.z).head(states).cwiseAbs().maxCoeff());
  return most / options_.tolerance;
}

/// Takes one step of order eight, where nothing touches.
void StepTrials::free_step(const Beginning& from, double length) {
  // Trial of order eight, so far without contacts and changes of modes.
  StepTrial& trial = table_[0];
  result_ = 0;
  trial.active.clear();
  trial.order = 8;
  trial.smooth = true;
  trial.closes = trial.changes = -1;
  trial.h = length;
  // Step of order eight, with its error over the tolerance.
  trial.state = from.state;
  const FreeStep::Error error = free_.step(step_, length, trial.state);
  trial.error =
      std::max(error.q, kSpeedErrorTime * std::max(error.v, error.z)) / options_.tolerance;
  counts_.count_free(error.acted);
  if (!all_numbers(trial.state)) {
    trial.error = std::numeric_limits<double>::infinity();
    return;
  }
  counts_.count_stages(static_cast<long>(FreeStep::kStages));
  // Contacts that close on the way, then contacts at the end.
  look_between(from, length, trial);
  if (trial.closes < 0) inspect(from, length, trial);
}

/// Looks for contacts that close in the middle of a free step, where a cubic is that has its ends
/// and their speeds: they may have opened again where it ends.
void StepTrials::look_between(const Beginning& from, double length, StepTrial& trial) {
  if (length <= options_.shortest) return;
  // Middle of the cubic: mean of the ends, and an eighth of the step by the difference of speeds.
  middle_.t = from.state.t + 0.5 * length;
  middle_.q = 0.5 * (from.state.q + trial.state.q);
  step_.normalise(middle_.q);
  middle_.v = from.state.v - trial.state.v;
  advance(step_.scene().mechanism, step_.model().layout, middle_.v, 0.125 * length, middle_.q);
  // Look for new contacts in the middle.
  middle_.v = 0.5 * (from.state.v + trial.state.v);
  step_.find(middle_, 0, found_);
  step_.note_new(found_, trial.active, outcome_);
  if (outcome_.deepest_new < -options_.touch)
    trial.closes = std::max(closing_time(0.5 * length, 0), 0.125 * length);
}

/// Looks for contacts where a trial ends.
void StepTrials::inspect(const Beginning& from, double length, StepTrial& trial) {
  // Contacts that are new at the end.
  inspected_ = true;
  step_.find(trial.state, kNearGap, found_);
  step_.note_new(found_, trial.active, outcome_);
  if (outcome_.deepest_new < -options_.touch) trial.closes = closing_time(length, 0);
  // Reject a motion so long that bodies may have passed through each other.
  const double motion = step_.motion_between(from.state, trial.state, trial.active);
  if (motion > 1 && length > options_.shortest) {
    trial.error = std::max(trial.error, std::pow(motion, trial.order));
    trial.closes = -1;
  }
}

void StepTrials::find_end() {
  if (!inspected_) step_.find(result().state, kNearGap, found_);
}

}  // namespace thenar
