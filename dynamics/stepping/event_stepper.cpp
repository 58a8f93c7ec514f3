#include "dynamics/stepping/event_stepper.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {
namespace {

constexpr double kInitialStepRatio = 0.1;  // length of the first step over the longest step [1]
constexpr double kMaxStretch = 1.1;        // largest extension of a step to end at a stop [1]
constexpr int kChatterSteps = 200;         // number of steps over which chattering is judged
constexpr double kChatterTime = 1e-4;      // time below which these steps count as chattering [s]
constexpr double kBurstTime = 1e-3;        // time passed by one burst of fixed steps [s]
constexpr int kBurstSteps = 10;            // number of fixed steps in a burst
constexpr int kMaxUnsolvedTrials = 3;      // largest number of repetitions of an unsolved step
constexpr double kUnsolvedError = 4;      // error assigned to an unsolved trial: 0.45 of its length
                                          // is tried next [1]
constexpr double kLengthRounding = 1e-9;  // relative rounding error of step lengths [1]
constexpr double kArcRatio = 0.25;  // excursion of a step that ends where it began, over its length
                                    // and largest speed: constant deceleration turns it round [1]

}  // namespace

EventStepper::EventStepper(const MovingScene& scene, const SceneOptions& options, SceneCost& cost)
    : step_(scene),
      fixed_(options),
      options_(options),
      cost_(cost),
      switching_times_(switching_times(scene)),
      state_(step_.initial_state()),
      counts_(cost),
      trials_(step_, options, counts_, state_),
      touching_(step_, options, counts_, cost),
      control_(options),
      next_length_(kInitialStepRatio * options.max_step) {
  step_.set_solver_options(options.contacts);
}

void EventStepper::resolve_initial_impacts() {
  step_.find_contacts(state_, kSearchMargin, trials_.end_contacts());
  touching_.update_with_impacts(state_, trials_.end_contacts());
}

/// Returns the instant at which the next step must end: `stop` or the next switching time [s].
double EventStepper::next_stop(double stop) const {
  const auto next = std::upper_bound(switching_times_.begin(), switching_times_.end(), state_.t);
  return next == switching_times_.end() ? stop : std::min(stop, *next);
}

bool EventStepper::take_step(double stop) {
  // Pass over chattering and rest.
  if (is_chattering()) {
    skip_chattering(stop);
    return true;
  }
  if (options_.sleep && sleep_.is_asleep()) {
    skip_rest(stop);
    return true;
  }
  // Divide the time to the next stop into equal steps no longer than the proposed length.
  const double left = next_stop(stop) - state_.t, max_length = control_.max_length();
  next_length_ =
      std::min({next_length_, max_length, std::max(step_.max_element_step(), options_.min_step)});
  const double parts =
      std::ceil(left / std::min(kMaxStretch * next_length_, max_length) - kLengthRounding);
  return take_adaptive_step(parts > 1 ? left / parts : left, left, stop) > 0;
}

SceneSample EventStepper::sample() {
  return make_sample(step_, state_, touching_.closed(), touching_.impulse_time());
}

/// Returns true if the last kChatterSteps steps together passed less than kChatterTime.
bool EventStepper::is_chattering() {
  // Count steps until kChatterSteps can be judged.
  ++steps_since_mark_;
  if (steps_since_mark_ < kChatterSteps) return false;
  steps_since_mark_ = 0;
  // Compare the time that they passed, and start a new count.
  const bool chatters = state_.t - mark_time_ < kChatterTime;
  mark_time_ = state_.t;
  return chatters;
}

/// Passes a burst of fixed steps, which contain events and need not resolve them one by one.
void EventStepper::skip_chattering(double stop) {
  // Take fixed steps, starting from impulses scaled to their length.
  const double end = std::min(next_stop(stop), state_.t + kBurstTime);
  const double h = (end - state_.t) / kBurstSteps, before = touching_.impulse_time();
  std::vector<ActiveContact> last = touching_.closed();
  scale_impulses(last, before > 0 ? h / before : 0);
  step_.select_active_forces(state_.t);
  double part = h;
  for (int i = 0; i < kBurstSteps && is_finite(state_); ++i)
    part = fixed_.take_step(step_, h, state_, last, cost_);
  state_.t = end;
  ++cost_.chatter_bursts;
  touching_.set_closed(last, part);
  if (!is_finite(state_)) return;
  // Record joint limits, then update contacts at the end and resolve their impacts.
  update_limit_excess(step_.scene().mechanism, step_.model().layout, state_.q, cost_.limit_excess);
  step_.accept_step(state_);
  step_.find_contacts(state_, kSearchMargin, trials_.end_contacts());
  touching_.update_with_impacts(state_, trials_.end_contacts());
}

/// Passes time at rest, to the next switching time at most.
void EventStepper::skip_rest(double stop) {
  const double end = next_stop(stop);
  cost_.rest_time += end - state_.t;
  state_.t = end;
  step_.accept_step(state_);
  wake_at_switches();
}

/// Takes one step of at most `wanted`. @param left  time to the next stop [s]
/// @return its length [s]; 0: no step is possible
double EventStepper::take_adaptive_step(double wanted, double left, double stop) {
  double length = control_.first_trial_length(state_.t, wanted);
  if (!find_accepted_length(length)) return 0;
  if (trials_.result().error > 1) ++cost_.inaccurate_steps;
  // Accept the trial with its contacts at the end, then propose the next length.
  trials_.find_end_contacts();
  was_solved_ = counts_.unsolved() == 0;
  accept_trial(length, length == left ? next_stop(stop) : state_.t + length);
  next_length_ = std::max(control_.next_step_length(trials_, length), options_.min_step);
  return length;
}

/// Repeats a step with ever shorter lengths until a trial is acceptable.
/// @param length  of the first trial, replaced by that of the accepted one [s]
/// @return false if the state is infinite or NaN
bool EventStepper::find_accepted_length(double& length) {
  int unsolved_trials = 0;  // number of repetitions for unsolved contact problems
  while (true) {
    trials_.try_step({state_, touching_.closed(), touching_.impulse_time()}, length);
    const StepTrial& trial = trials_.result();
    // Give up if even the shortest step overflows.
    if (!std::isfinite(trial.error) && length <= options_.min_step) return false;
    // A step longer than options_.max_step is valid only if positions hardly move.
    if (length > (1 + kLengthRounding) * options_.max_step &&
        max_displacement(trial, length) >= kSearchMargin) {
      ++cost_.rejected;
      length = control_.cap_at_max_step();
      continue;
    }
    // Accept a trial without closing gap and with a small error, if its other errors are small too.
    double error = 0;
    if (trial.closing_time < 0 && (trial.error <= 1 || length <= options_.min_step)) {
      error = trial_error(length, unsolved_trials);
      if (error <= 1) return true;
    }
    // Otherwise shorten the step for these errors, the closing gap, the error or a mode change.
    ++cost_.rejected;
    if (error > 1) {
      trials_.discard_rates();
      length = control_.shorten_for_elements(error, length);
    } else if (trial.closing_time >= 0 && trial.closing_time <= options_.min_step &&
               length <= options_.min_step) {
      control_.record_rejection();
      return true;  // the gap closes within the shortest step
    } else {
      length = control_.shorten_after_rejection(trials_, state_.t, length);
    }
  }
}

/// Returns the error of a trial beyond its integration error: that of elements, or kUnsolvedError
/// if contact problems are unsolved and a shorter step may solve them [1].
double EventStepper::trial_error(double length, int& unsolved_trials) {
  const double error = step_.element_step_error(trials_.result().state);
  if (length <= options_.min_step) return 0;
  if (error > 1) return error;
  // Repeat an unsolved step a few times, unless the previous step stayed unsolved, too.
  const bool repeats =
      counts_.unsolved() > 0 && was_solved_ && unsolved_trials < kMaxUnsolvedTrials;
  if (!repeats) return error;
  ++unsolved_trials;
  return kUnsolvedError;
}

/// Makes the end of a trial the present state. @param end  its instant [s]
void EventStepper::accept_trial(double length, double end) {
  StepTrial& trial = trials_.result();
  const bool was_still = is_still(state_);
  // Allow longer steps while positions hardly move.
  control_.set_max_length(step_.scene().elements.empty() &&
                          max_displacement(trial, length) < kSearchMargin);
  // Take over state, contacts and counts of the trial.
  update_energy_account(trial.state);
  state_ = trial.state;
  state_.t = end;
  touching_.set_closed(trial.active, trial.h);
  counts_.accept();
  ++cost_.steps;
  update_limit_excess(step_.scene().mechanism, step_.model().layout, state_.q, cost_.limit_excess);
  // Correct gaps and resolve impacts at the end.
  const std::vector<ActiveContact>& closed = touching_.closed();
  const bool slides =
      any_of(closed, [](const ActiveContact& c) { return c.mode == ContactMode::kSlide; });
  const double gap = touching_.close_gaps_and_update(length, state_, trials_.end_contacts());
  // Inform elements, detect rest, and wake the scene at switching times.
  step_.accept_step(state_);
  sleep_.observe_step(step_, was_still, slides, gap, options_.touch, state_);
  trials_.discard_rates();
  wake_at_switches();
}

/// Updates the measures of turned-over energy for the step to a state.
void EventStepper::update_energy_account(SceneState& end) {
  end.w[kWorkMagnitude] =
      state_.w[kWorkMagnitude] + std::abs(end.w[kAppliedWork] - state_.w[kAppliedWork]);
  if (end.z.size() > 0) end.w[kWorkMagnitude] += std::abs((end.z - state_.z).tail<1>()[0]);
  end.w[kMaxKinetic] = std::max(state_.w[kMaxKinetic], step_.kinetic_energy(end));
}

/// Wakes a resting scene at switching times.
void EventStepper::wake_at_switches() {
  if (!std::binary_search(switching_times_.begin(), switching_times_.end(), state_.t)) return;
  sleep_.wake();
  control_.set_max_length(false);
}

/// Estimates the largest displacement of a coordinate during a trial [m], [rad].
double EventStepper::max_displacement(const StepTrial& trial, double length) const {
  if (state_.v.size() == 0) return 0;
  const double speed =
      std::max(state_.v.cwiseAbs().maxCoeff(), trial.state.v.cwiseAbs().maxCoeff());
  return std::max((trial.state.q - state_.q).cwiseAbs().maxCoeff(), kArcRatio * length * speed);
}

}  // namespace thenar
