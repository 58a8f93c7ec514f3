#include "dynamics/stepping/step_control.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr double kQuietStepFactor = 5;      // The longest step grows by this factor while no
                                            // position changes by kNearGap [1]
constexpr double kModeChangeMargin = 0.97;  // A step ends at this share of the time to the next
                                            // mode change [1]
constexpr double kAfterChangeShare = 0.5;  // of the usual length, of a step after such a change [1]

}  // namespace

void StepControl::set_reach(bool is_quiet) {
  reach_ = (is_quiet ? kQuietStepFactor : 1) * options_.longest;
}

double StepControl::begin(double t, double wanted) {
  rejected_ = is_before_ = is_cut_ = false;
  double length = wanted;
  // A step that was halved has told where a mode changes behind its end.
  const double ahead = kModeChangeMargin * (change_ahead_ - t);
  if (ahead > options_.shortest && ahead < length) {
    is_before_ = is_cut_ = true;
    length = ahead;
  }
  change_ahead_ = -1;
  return length;
}

double StepControl::shorten_to_longest() {
  rejected_ = true;
  return options_.longest;
}

void StepControl::note_rejected() {
  rejected_ = true;
  is_cut_ = false;
}

double StepControl::shorten_for(double doubt, double length) {
  note_rejected();
  // What elements foresee is wrong by the square of the step.
  return std::max(length * std::clamp(0.9 / std::sqrt(doubt), 0.2, 0.8), options_.shortest);
}

double StepControl::shorten(StepTrials& trials, double t, double length) {
  const StepTrial& trial = trials.result();
  note_rejected();
  if (trial.closes >= 0 && trial.closes > options_.shortest) {
    // Again, up to the instant at which the gap closes.
    length = std::min(trial.closes, 0.999999 * length);
  } else if (trials.verdict() == Extrapolation::Verdict::kReject) {
    length = trials.next_length(length, reach_);
  } else if (trial.smooth && std::isfinite(trial.error)) {
    // Smooth, with an error: by its order in the length.
    length *= std::clamp(0.9 * std::pow(trial.error, -1.0 / trial.order), 0.1, 0.9);
  } else {
    // Up to the instant at which a mode changes; a short step goes over it.
    is_before_ = true;
    is_cut_ = trial.changes >= 0 && kModeChangeMargin * trial.changes < 0.5 * length;
    if (trial.changes >= 0 && !is_cut_) change_ahead_ = t + trial.changes;
    length = is_cut_ ? kModeChangeMargin * trial.changes : 0.5 * length;
  }
  return std::max(length, options_.shortest);
}

double StepControl::after(StepTrials& trials, double length) {
  const StepTrial& trial = trials.result();
  double next = next_length(trials, length);
  if (!trial.smooth) {
    // A mode has changed: on as before.
    next = std::max(next, kAfterChangeShare * usual_);
  } else if (is_cut_) {
    next = 2 * (1 - kModeChangeMargin) * length;
  } else if (!is_before_ && !was_before_) {
    usual_ = next;
  }
  was_before_ = is_before_ && trial.smooth;
  return next;
}

/// Length of the next step: no longer right after a rejection [s].
double StepControl::next_length(StepTrials& trials, double length) {
  const StepTrial& trial = trials.result();
  if (!trial.smooth) return length * (rejected_ ? 1 : 1.5);
  const double next = trials.verdict() == Extrapolation::Verdict::kAccept
                          ? trials.next_length(length, reach_)
                          : length * free_growth(trial);
  return rejected_ ? std::min(next, length) : next;
}

/// Growth by the error of a free step and that of the step before [Hairer1993], so carefully that
/// hardly any step is rejected [1].
double StepControl::free_growth(const StepTrial& trial) {
  const double error = std::max(trial.error, 1e-9);
  const double growth =
      0.8 * std::pow(error, -0.7 / trial.order) * std::pow(last_error_, 0.4 / trial.order);
  last_error_ = error;
  return std::clamp(growth, 0.2, 4.0);
}

}  // namespace thenar
