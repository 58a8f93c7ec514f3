#include "dynamics/stepping/event_stepper.h"

#include <algorithm>
#include <cmath>

#include "dynamics/stepping/limit_excess.h"

namespace thenar {
namespace {

constexpr double kFirstShare = 0.1;        // of the longest step, of the first one [1]
constexpr double kMostStretch = 1.1;       // of a step, to end where it must [1]
constexpr int kChatterSteps = 200;         // that are judged together
constexpr double kChatterTime = 1e-4;      // that they should have passed [s]
constexpr double kChatterPassTime = 1e-3;  // that steps of fixed length pass instead [s]
constexpr int kPassSteps = 10;             // of them
constexpr int kUnsolvedTrials = 3;         // of a step whose problems are not solved, all shorter
constexpr double kUnsolvedDoubt = 4;  // of such a trial, which tells its length as doubts do [1]

}  // namespace

EventStepper::EventStepper(const MovingScene& scene, const SceneOptions& options, SceneCost& cost)
    : step_(scene),
      options_(options),
      cost_(cost),
      switches_(switching_times(scene)),
      state_(step_.start()),
      counts_(cost),
      trials_(step_, options, counts_, state_),
      touching_(step_, options, counts_, cost),
      control_(options),
      length_(kFirstShare * options.longest) {
  step_.solve_contacts_by(options.contacts);
}

void EventStepper::begin() {
  step_.find(state_, kNearGap, trials_.found());
  touching_.touch_and_bounce(state_, trials_.found());
}

/// The instant at which a step must end: at `stop`, or where something begins or ends to act [s].
double EventStepper::next_stop(double stop) const {
  const auto next = std::upper_bound(switches_.begin(), switches_.end(), state_.t);
  return next == switches_.end() ? stop : std::min(stop, *next);
}

bool EventStepper::go_on(double stop) {
  // Piles of events and rest are passed over.
  if (is_chattering()) {
    pass_events(stop);
    return true;
  }
  if (options_.sleep && sleep_.sleeps()) {
    pass_time(stop);
    return true;
  }
  // Equal parts up to the next stop.
  const double left = next_stop(stop) - state_.t, reach = control_.reach();
  length_ = std::min({length_, reach, std::max(step_.elements_foresee(), options_.shortest)});
  const double parts = std::ceil(left / std::min(kMostStretch * length_, reach) - 1e-9);
  return step_once(parts > 1 ? left / parts : left, left, stop) > 0;
}

SceneSample EventStepper::sample() {
  SceneSample out;
  out.t = state_.t;
  out.q = state_.q;
  out.v = state_.v;
  out.z = state_.z;
  out.contacts = contact_samples(touching_.closed(), touching_.impulse_time());
  step_.add_element_contacts(state_, out.contacts);
  out.energy = step_.energy(state_);
  out.w = state_.w;
  return out;
}

/// Returns whether the last steps went nowhere: events follow each other without end.
bool EventStepper::is_chattering() {
  // Judge kChatterSteps steps together, by the time that they passed.
  ++since_mark_;
  if (since_mark_ < kChatterSteps) return false;
  since_mark_ = 0;
  const bool stands = state_.t - mark_ < kChatterTime;
  mark_ = state_.t;
  return stands;
}

/// Goes through a pile of events by some steps of fixed length, which need not tell them apart.
void EventStepper::pass_events(double stop) {
  // Steps of a fixed length, from impulses scaled to it.
  const double end = std::min(next_stop(stop), state_.t + kChatterPassTime);
  const double h = (end - state_.t) / kPassSteps, before = touching_.impulse_time();
  std::vector<ActiveContact> last = touching_.closed();
  scale_impulses(last, before > 0 ? h / before : 0);
  step_.act_as_at(state_.t);
  double part = h;
  for (int i = 0; i < kPassSteps && is_finite(state_); ++i)
    part = fixed_.take(step_, h, options_, state_, last, cost_);
  state_.t = end;
  ++cost_.passed;
  touching_.take(last, part);
  if (!is_finite(state_)) return;
  // Contacts at the end, with impacts.
  note_limits(step_.scene().mechanism, step_.model().layout, state_.q, cost_.beyond);
  step_.accept(state_);
  step_.find(state_, kNearGap, trials_.found());
  touching_.touch_and_bounce(state_, trials_.found());
}

/// Lets time pass at rest.
void EventStepper::pass_time(double stop) {
  const double end = next_stop(stop);
  cost_.asleep += end - state_.t;
  state_.t = end;
  step_.accept(state_);
  wake_at_switches();
}

/// Makes one step of at most `wanted`. @return its length [s]; 0: there is none
double EventStepper::step_once(double wanted, double left, double stop) {
  double length = control_.begin(state_.t, wanted);
  if (!find_length(length)) return 0;
  if (trials_.result().error > 1) ++cost_.coarse;
  // Contacts at the end of a step that was too short to be looked at.
  trials_.find_end();
  was_solved_ = counts_.unsolved() == 0;
  accept(length, length == left ? next_stop(stop) : state_.t + length);
  length_ = std::max(control_.after(trials_, length), options_.shortest);
  return length;
}

/// Tries steps, ever shorter, until one is good enough. @return false if the state is no number
bool EventStepper::find_length(double& length) {
  int unsolved = 0;  // trials of it that were not solved
  while (true) {
    trials_.attempt({state_, touching_.closed(), touching_.impulse_time()}, length);
    const StepTrial& trial = trials_.result();
    // A state that is no number at the shortest length is hopeless.
    if (!std::isfinite(trial.error) && length <= options_.shortest) return false;
    // A step beyond the usual longest must hardly move.
    if (length > (1 + 1e-9) * options_.longest && moved_by(trial, length) >= kNearGap) {
      ++cost_.rejected;
      length = control_.shorten_to_longest();
      continue;
    }
    // No gap closes, and error or length are small enough: elements may still doubt it.
    double doubt = 0;
    if (trial.closes < 0 && (trial.error <= 1 || length <= options_.shortest)) {
      doubt = doubt_of(length, unsolved);
      if (doubt <= 1) return true;
    }
    // Rejected: shorter for the doubt, the closing gap, the error or the change of modes.
    ++cost_.rejected;
    if (doubt > 1) {
      trials_.forget_rates();
      length = control_.shorten_for(doubt, length);
    } else if (trial.closes >= 0 && trial.closes <= options_.shortest &&
               length <= options_.shortest) {
      control_.note_rejected();
      return true;  // as near as time is resolved
    } else {
      length = control_.shorten(trials_, state_.t, length);
    }
  }
}

/// Doubt in a trial whose error is small enough: that of elements, or of problems that are not
/// solved and may be so over a shorter step, unless that did not help before [1].
double EventStepper::doubt_of(double length, int& unsolved) {
  const double doubt = step_.elements_doubt(trials_.result().state);
  if (length <= options_.shortest) return 0;
  if (doubt > 1) return doubt;
  const bool tries_again = counts_.unsolved() > 0 && was_solved_ && unsolved < kUnsolvedTrials;
  if (!tries_again) return doubt;
  ++unsolved;
  return kUnsolvedDoubt;
}

/// Goes on from the end of a trial. @param end  instant of it [s]
void EventStepper::accept(double length, double end) {
  StepTrial& trial = trials_.result();
  const bool was_still = is_still(state_);
  // Where positions hardly move, the next step may be long.
  control_.set_reach(step_.scene().elements.empty() && moved_by(trial, length) < kNearGap);
  // State, contacts and counts of the trial.
  keep_account(trial.state);
  state_ = trial.state;
  state_.t = end;
  touching_.take(trial.active, trial.h);
  counts_.accept();
  ++cost_.steps;
  note_limits(step_.scene().mechanism, step_.model().layout, state_.q, cost_.beyond);
  // Contacts that touch at the end, with gaps closed and impacts, then rest and elements.
  const std::vector<ActiveContact>& closed = touching_.closed();
  const bool slides = std::any_of(closed.begin(), closed.end(), [](const ActiveContact& c) {
    return c.mode == ContactMode::kSlide;
  });
  const double gap = touching_.touch_again(length, state_, trials_.found());
  step_.accept(state_);
  sleep_.observe(step_, was_still, slides, gap, options_.touch, state_);
  trials_.forget_rates();
  wake_at_switches();
}

/// Measures how much energy there is to keep account of in the step to a state.
void EventStepper::keep_account(SceneState& end) {
  end.w[kWorked] = state_.w[kWorked] + std::abs(end.w[kApplied] - state_.w[kApplied]);
  if (end.z.size() > 0) end.w[kWorked] += std::abs((end.z - state_.z).tail<1>()[0]);
  end.w[kMostKinetic] = std::max(state_.w[kMostKinetic], step_.kinetic_energy(end));
}

/// Wakes what rests where something begins or ends to act.
void EventStepper::wake_at_switches() {
  if (!std::binary_search(switches_.begin(), switches_.end(), state_.t)) return;
  sleep_.wake();
  control_.set_reach(false);
}

/// Distance that a trial moves, at its end or on its way [m], [rad].
double EventStepper::moved_by(const StepTrial& trial, double length) const {
  if (state_.v.size() == 0) return 0;
  const double speed =
      std::max(state_.v.cwiseAbs().maxCoeff(), trial.state.v.cwiseAbs().maxCoeff());
  return std::max((trial.state.q - state_.q).cwiseAbs().maxCoeff(), 0.25 * length * speed);
}

}  // namespace thenar
