#include "dynamics/stepping/simulate_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/progress_parts.h"
#include "base/thread_seconds.h"
#include "dynamics/stepping/energy_balance.h"
#include "dynamics/stepping/extrapolation.h"
#include "dynamics/stepping/free_step.h"
#include "dynamics/stepping/limit_excess.h"
#include "dynamics/stepping/mode_change.h"
#include "dynamics/stepping/scene_stepper.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

constexpr int kRoughColumns = 4;           // of steps in which a mode changes
constexpr double kOrderShare = 0.1;        // of the tolerance that two orders may differ by: high
                                           // orders differ little, and steps add up [1]
constexpr double kOrderRounding = 1e-12;   // they differ by at least that much [m], [rad]
constexpr double kMostStretch = 1.1;       // of a step, to end where it must
constexpr double kQuietStepFactor = 5;     // of `longest`, where positions hardly move
constexpr double kRestSpeed = 1e-11;       // slower is at rest [m/s], [rad/s]
constexpr int kChatterSteps = 200;         // steps that are judged together
constexpr double kChatterTime = 1e-4;      // that they should have passed [s]
constexpr double kChatterPassTime = 1e-3;  // that steps of fixed length pass instead [s]
constexpr int kPassSteps = 10;             // of them
constexpr double kSpeedErrorTime =
    0.01;  // over which an error of speeds counts in smooth steps [s]
constexpr double kModeChangeMargin = 0.97;  // of the way to a change of modes that a step takes [1]
constexpr double kAfterChangeShare = 0.5;  // of the usual length, of a step after such a change [1]
constexpr int kUnsolvedTrials = 3;         // of a step whose problems are not solved, all shorter
constexpr double kUnsolvedDoubt = 4;   // of such a trial, which tells its length as doubts do [1]
constexpr double kImpactSpeed = 1e-7;  // slower approaches are not impacts [m/s], [rad/s]

/// What a trial of one step found.
struct StepTrial {
  SceneState state;
  std::vector<ActiveContact> active;  // of its last substep, impulses over `h`
  double h = 0;                       // of that substep [s]
  double error = 0;                   // over the tolerance [1]
  int order = 1;                      // of the error in the length
  bool smooth = true;                 // extrapolated: all modes stayed
  double closes = -1;                 // >= 0: a gap closes about then, after the step began [s]
  double changes = -1;                // >= 0: the first mode changes about then, likewise [s]
};

class Simulation {
 public:
  Simulation(const MovingScene& scene, const SceneOptions& options, const Progress& progress)
      : step_(scene),
        options_(options),
        progress_(progress),
        switches_(switching_times(scene)),
        state_(step_.start()),
        free_(step_),
        columns_(state_, options.columns) {
    step_.solve_contacts_by(options.contacts);
    for (StepTrial& column : table_) column.state = state_;
  }

  SceneRun run() {
    try {
      run_events();
    } catch (const Stopped&) {
      run_.status = SceneStatus::kStopped;  // within a step, which does not count
    }
    return std::move(run_);
  }

 private:
  /// The next instant at which a step must end.
  [[nodiscard]] double next_stop() const {
    const double stop = std::min(options_.seconds, next_sample_);
    const auto next = std::upper_bound(switches_.begin(), switches_.end(), state_.t);
    return next == switches_.end() ? stop : std::min(stop, *next);
  }

  /// Keeps the state as a sample. @param h  over which the impulses of `active` acted [s]
  void sample(const std::vector<ActiveContact>& active, double h) {
    SceneSample out;
    out.t = state_.t;
    out.q = state_.q;
    out.v = state_.v;
    out.z = state_.z;
    out.contacts = contact_samples(active, h);
    step_.add_element_contacts(state_, out.contacts);
    out.energy = step_.energy(state_);
    out.w = state_.w;
    run_.samples.push_back(std::move(out));
    next_sample_ =
        options_.sample * static_cast<double>(std::lround(state_.t / options_.sample) + 1);
  }

  /// Whether the caller wants more. Ends the run otherwise.
  bool go_on() {
    if (!is_finite(state_)) {
      run_.status = SceneStatus::kNotFinite;
      return false;
    }
    progress_(state_.t / options_.seconds, "");
    if (progress_.stop()) {
      run_.status = SceneStatus::kStopped;
      return false;
    }
    return true;
  }

  /// Counts a contact problem of a trial, which may be rejected.
  void count(const StepOutcome& outcome) {
    ++run_.cost.substeps;
    if (!outcome.solved) ++tried_unsolved_;
    tried_residual_ = std::max(tried_residual_, outcome.residual);
  }
  void forget_counts() { tried_unsolved_ = 0, tried_residual_ = 0; }
  /// The contact problems since forget_counts() belong to the run.
  void accept_counts() {
    run_.cost.unsolved += tried_unsolved_;
    run_.cost.worst_residual = std::max(run_.cost.worst_residual, tried_residual_);
    forget_counts();
  }

  // ---- steps between events

  void run_events() {
    double H = 0.1 * options_.longest;
    reach_ = options_.longest;
    step_.find(state_, kNearGap, found_);
    const SceneState start = state_;
    touch_and_bounce();
    sample(closed_, last_h_);
    begin_with(start);
    while (state_.t < options_.seconds) {
      if (!go_on()) return;
      if (is_chattering()) {
        pass_events();
        continue;
      }
      if (asleep()) {
        pass_time();
        continue;
      }
      const double left = next_stop() - state_.t;
      // Equal parts up to the next stop.
      H = std::min({H, reach_, std::max(step_.elements_foresee(), options_.shortest)});
      const double parts = std::ceil(left / std::min(kMostStretch * H, reach_) - 1e-9);
      const double taken = step_once(parts > 1 ? left / parts : left, left, H);
      sample_if_due();
      if (taken <= 0) return;
      H = std::max(H, options_.shortest);
    }
  }

  /// The first instant is that before an impact at the start.
  void begin_with(const SceneState& start) {
    SceneSample& first = run_.samples.front();
    first.v = start.v;
    first.energy = step_.energy(start);
    first.w = start.w;
  }

  void sample_if_due() {
    if (state_.t + 1e-12 >= next_sample_ || state_.t >= options_.seconds) sample(closed_, last_h_);
  }

  /// Keeps what touches of all that was found at the state, and ends its approach.
  void touch_and_bounce() {
    // What has a force and was not found may come back: manifolds choose among their points.
    lost_.clear();
    for (const ActiveContact& old : closed_)
      if (old.mode != ContactMode::kOpen &&
          std::none_of(found_.begin(), found_.end(),
                       [&](const ActiveContact& c) { return c.same(old); }))
        lost_.push_back(old);
    // Contacts with a force stay closed, though their gap may be a little wide.
    const auto is_open = [&](const ActiveContact& contact) {
      return contact.gap > options_.touch &&
             std::none_of(closed_.begin(), closed_.end(), [&](const ActiveContact& c) {
               return c.mode != ContactMode::kOpen && c.same(contact);
             });
    };
    found_.erase(std::remove_if(found_.begin(), found_.end(), is_open), found_.end());
    // Contacts that go on keep their modes, and their impulses start the next solution.
    bool all_known = true;
    for (ActiveContact& contact : found_) {
      const auto old = std::find_if(closed_.begin(), closed_.end(),
                                    [&](const ActiveContact& c) { return c.same(contact); });
      if (old == closed_.end()) {
        all_known = false;
        continue;
      }
      contact.impulse = old->impulse;
      contact.torsion = old->torsion;
      contact.mode = old->mode;
    }
    closed_.swap(found_);
    const bool approaches =
        std::any_of(closed_.begin(), closed_.end(), [](const ActiveContact& contact) {
          return contact.kind != Kind::kJointFriction && contact.approach < -kImpactSpeed;
        });
    if (approaches) {
      StepOutcome outcome;
      step_.impact(state_, closed_, outcome);
      count(outcome);
      accept_counts();
      ++run_.cost.impacts;
    }
    if (approaches || !all_known) settle_modes();
    // What leaves is free: if it comes back, its gap will close anew. Where its gap still counts as
    // closed it does not come back, else contacts that push each other off by turns would ask for
    // an impact each time.
    closed_.erase(std::remove_if(closed_.begin(), closed_.end(),
                                 [&](const ActiveContact& c) {
                                   return c.mode == ContactMode::kOpen &&
                                          c.approach > kImpactSpeed && c.gap > options_.touch;
                                 }),
                  closed_.end());
    closed_.insert(closed_.end(), lost_.begin(), lost_.end());
  }

  /// What contacts do next, by a step that is as short as can be.
  void settle_modes() {
    SceneState state = state_;
    step_.act_as_at(state.t);
    const double factor = last_h_ > 0 ? options_.shortest / last_h_ : 0;
    scale_impulses(closed_, factor);
    scale_impulses(lost_, factor);
    step_.substep(state, options_.shortest, closed_, options_.touch, outcome_);
    count(outcome_);
    accept_counts();
    closed_.swap(outcome_.active);
    last_h_ = options_.shortest;
  }

  /// The last steps went nowhere: events follow each other without end.
  bool is_chattering() {
    ++since_mark_;
    if (since_mark_ < kChatterSteps) return false;
    since_mark_ = 0;
    const bool stands = state_.t - mark_ < kChatterTime;
    mark_ = state_.t;
    return stands;
  }

  /// Goes through a pile of events by some steps of fixed length, which need not tell them apart.
  void pass_events() {
    const double stop = std::min(next_stop(), state_.t + kChatterPassTime);
    const double h = (stop - state_.t) / kPassSteps;
    std::vector<ActiveContact> last = closed_;
    scale_impulses(last, last_h_ > 0 ? h / last_h_ : 0);
    step_.act_as_at(state_.t);
    double part = h;
    for (int i = 0; i < kPassSteps && is_finite(state_); ++i)
      part = fixed_.take(step_, h, options_, state_, last, run_.cost);
    state_.t = stop;
    ++run_.cost.passed;
    closed_ = last;
    last_h_ = part;
    if (!is_finite(state_)) return;
    note_limits(step_.scene().mechanism, step_.model().layout, state_.q, run_.cost.beyond);
    step_.accept(state_);
    step_.find(state_, kNearGap, found_);
    touch_and_bounce();
    sample_if_due();
  }

  /// Nothing moves, and the last steps changed nothing.
  [[nodiscard]] bool asleep() const { return options_.sleep && asleep_ >= 3; }

  void pass_time() {
    const double stop = next_stop();
    run_.cost.asleep += stop - state_.t;
    state_.t = stop;
    step_.accept(state_);
    sample_if_due();
    if (is_switch()) wake();
  }

  /// One accepted step of at most `wanted`. @param H  length of the next one
  /// @return its length; 0: the run ends
  double step_once(double wanted, double left, double& H) {
    double length = wanted;
    // Shortened for a change of modes within it, and to end just before that change.
    bool rejected = false, is_before = false, is_cut = false;
    int unsolved = 0;  // trials of it that were not solved
    // A step that was halved has told where a mode changes behind its end.
    const double ahead = kModeChangeMargin * (change_ahead_ - state_.t);
    if (ahead > options_.shortest && ahead < length) {
      is_before = is_cut = true;
      length = ahead;
    }
    change_ahead_ = -1;
    while (true) {
      try_step(length);
      const StepTrial& trial = table_[static_cast<std::size_t>(result_)];
      if (!std::isfinite(trial.error) && length <= options_.shortest) return give_up();
      // Long steps are for what hardly moves.
      if (length > (1 + 1e-9) * options_.longest && moved_by(trial, length) >= kNearGap) {
        ++run_.cost.rejected;
        rejected = true;
        length = options_.longest;
        continue;
      }
      double doubt = 0;
      if (trial.closes < 0 && (trial.error <= 1 || length <= options_.shortest)) {
        doubt = step_.elements_doubt(trial.state);
        // What is not solved may be so over a shorter step, unless that did not help before.
        const bool tries_again = tried_unsolved_ > 0 && was_solved_ && unsolved < kUnsolvedTrials;
        if (length <= options_.shortest || (doubt <= 1 && !tries_again)) break;
        if (doubt <= 1) {
          ++unsolved;
          doubt = kUnsolvedDoubt;
        }
      }
      ++run_.cost.rejected;
      rejected = true;
      is_cut = false;
      if (doubt > 1) {
        free_.forget();
        // What elements foresee is wrong by the square of the step.
        length *= std::clamp(0.9 / std::sqrt(doubt), 0.2, 0.8);
      } else if (trial.closes >= 0 && trial.closes > options_.shortest) {
        // Again, up to the instant at which the gap closes.
        length = std::min(trial.closes, 0.999999 * length);
      } else if (trial.closes >= 0 && length <= options_.shortest) {
        break;  // as near as time is resolved
      } else if (verdict_ == Extrapolation::Verdict::kReject) {
        length = columns_.next_length(length, reach_, verdict_);
      } else if (trial.smooth && std::isfinite(trial.error)) {
        length *= std::clamp(0.9 * std::pow(trial.error, -1.0 / trial.order), 0.1, 0.9);
      } else {
        // Up to the instant at which a mode changes; a short step goes over it.
        is_before = true;
        is_cut = trial.changes >= 0 && kModeChangeMargin * trial.changes < 0.5 * length;
        if (trial.changes >= 0 && !is_cut) change_ahead_ = state_.t + trial.changes;
        length = is_cut ? kModeChangeMargin * trial.changes : 0.5 * length;
      }
      length = std::max(length, options_.shortest);
    }
    if (table_[static_cast<std::size_t>(result_)].error > 1) ++run_.cost.coarse;
    // A step that is as short as can be was not inspected.
    if (!inspected_) step_.find(table_[static_cast<std::size_t>(result_)].state, kNearGap, found_);
    was_solved_ = tried_unsolved_ == 0;
    accept(length, left);
    const StepTrial& trial = table_[static_cast<std::size_t>(result_)];
    H = next_length(trial, length, rejected);
    if (!trial.smooth) {
      // A mode has changed: on as before.
      H = std::max(H, kAfterChangeShare * usual_);
    } else if (is_cut) {
      H = 2 * (1 - kModeChangeMargin) * length;
    } else if (!is_before && !was_before_) {
      usual_ = H;
    }
    was_before_ = is_before && trial.smooth;
    return length;
  }

  /// Length of the next step after an accepted one: no longer right after a rejection.
  double next_length(const StepTrial& trial, double length, bool rejected) {
    if (!trial.smooth) return length * (rejected ? 1 : 1.5);
    const double next = verdict_ == Extrapolation::Verdict::kAccept
                            ? columns_.next_length(length, reach_, verdict_)
                            : length * free_growth(trial);
    return rejected ? std::min(next, length) : next;
  }

  /// By the error of a free step and that of the step before [Hairer1993], so carefully that
  /// hardly any step is rejected.
  double free_growth(const StepTrial& trial) {
    const double error = std::max(trial.error, 1e-9);
    const double growth =
        0.8 * std::pow(error, -0.7 / trial.order) * std::pow(last_error_, 0.4 / trial.order);
    last_error_ = error;
    return std::clamp(growth, 0.2, 4.0);
  }

  double give_up() {
    run_.status = SceneStatus::kNotFinite;
    return 0;
  }

  void accept(double length, double left) {
    StepTrial& trial = table_[static_cast<std::size_t>(result_)];
    const double end = length == left ? next_stop() : state_.t + length;
    const bool was_still = is_still();
    // Where positions hardly move, the next step may be long.
    const bool quiet = step_.scene().elements.empty() && moved_by(trial, length) < kNearGap;
    reach_ = (quiet ? kQuietStepFactor : 1) * options_.longest;
    keep_account(trial.state);
    state_ = trial.state;
    state_.t = end;
    closed_.swap(trial.active);
    last_h_ = trial.h;
    accept_counts();
    ++run_.cost.steps;
    note_limits(step_.scene().mechanism, step_.model().layout, state_.q, run_.cost.beyond);
    const bool slides = std::any_of(closed_.begin(), closed_.end(), [](const ActiveContact& c) {
      return c.mode == ContactMode::kSlide;
    });
    const double gap = touch_again(length);
    step_.accept(state_);
    if (was_still && is_still() && !slides && gap < options_.touch && !drives_move() &&
        !step_.elements_move(state_)) {
      state_.v.setZero();
      ++asleep_;
    } else {
      asleep_ = 0;
    }
    free_.forget();
    if (is_switch()) wake();
  }

  /// Measures how much energy there is to keep account of in the step to a state.
  void keep_account(SceneState& end) {
    end.w[kWorked] = state_.w[kWorked] + std::abs(end.w[kApplied] - state_.w[kApplied]);
    if (end.z.size() > 0) end.w[kWorked] += std::abs((end.z - state_.z).tail<1>()[0]);
    end.w[kMostKinetic] = std::max(state_.w[kMostKinetic], step_.kinetic_energy(end));
  }

  /// Whether something begins or ends to act now.
  [[nodiscard]] bool is_switch() const {
    return std::binary_search(switches_.begin(), switches_.end(), state_.t);
  }
  void wake() {
    asleep_ = 0;
    reach_ = options_.longest;
  }

  /// How far a trial moves, at its end or on its way [m], [rad].
  [[nodiscard]] double moved_by(const StepTrial& trial, double length) const {
    if (state_.v.size() == 0) return 0;
    const double speed =
        std::max(state_.v.cwiseAbs().maxCoeff(), trial.state.v.cwiseAbs().maxCoeff());
    return std::max((trial.state.q - state_.q).cwiseAbs().maxCoeff(), 0.25 * length * speed);
  }

  [[nodiscard]] bool is_still() const {
    return state_.v.size() == 0 || state_.v.cwiseAbs().maxCoeff() <= kRestSpeed;
  }

  /// Whether some drive has a target that moves.
  [[nodiscard]] bool drives_move() const {
    return std::any_of(
        step_.scene().drives.begin(), step_.scene().drives.end(), [&](const SceneDrive& drive) {
          return drive.when.holds(state_.t) && drive_target(drive, state_.t, state_.t).speed != 0;
        });
  }

  /// Closes gaps that have opened or overlap since the trial was inspected, and ends approaches.
  /// @return the largest gap of contacts with a force, before it was closed [m]
  double touch_again(double length) {
    const std::vector<ActiveContact> pressed = closed_;
    double worst = 0;
    for (const ActiveContact& contact : found_)
      for (const ActiveContact& old : pressed)
        if (old.same(contact) && old.mode != ContactMode::kOpen)
          worst = std::max(worst, std::abs(contact.gap));
    if (worst > 0.1 * options_.touch) {
      step_.close_gaps(state_, pressed, std::max(options_.touch, options_.recovery * length));
      step_.find(state_, kNearGap, found_);
    }
    touch_and_bounce();
    for (const ActiveContact& contact : closed_)
      if (contact.kind == Kind::kContact)
        run_.cost.deepest = std::max(run_.cost.deepest, -contact.gap);
    return worst;
  }

  /// Fills the table for one step, up to the first sign that it is too long.
  void try_step(double length) {
    inspected_ = false;
    verdict_ = Extrapolation::Verdict::kGoOn;
    forget_counts();
    step_.act_as_at(state_.t);
    if (closed_.empty() && !step_.is_stiff(state_, length)) return free_step(length);
    columns_.restart();
    bool smooth = true;
    for (int n = 1; n <= options_.columns; ++n) {
      StepTrial& column = table_[static_cast<std::size_t>(n - 1)];
      result_ = n - 1;
      if (!substeps(length, n, column)) return;
      smooth = smooth && column.smooth && same_modes(column.active, table_[0].active);
      column.smooth = smooth;
      if (smooth ? extrapolates(column) : n >= kRoughColumns) break;
    }
    StepTrial& last = table_[static_cast<std::size_t>(result_)];
    if (!smooth) {
      // Modes that changed leave the finest column.
      last.order = 2;
      last.error = difference(last.state, table_[static_cast<std::size_t>(result_ - 1)].state, 1);
      // A first substep that friction turns round within is wrong by as much in all columns: the
      // speed by up to twice what there was to lose.
      last.error =
          std::max(last.error, 2 * slip_that_turned(closed_, last.active) / options_.tolerance);
      verdict_ = Extrapolation::Verdict::kGoOn;
    }
    // Gaps of extrapolated positions are not those of any column.
    if (last.error <= 1 || length <= options_.shortest) inspect(length, last);
  }

  /// Whether another column is of no use, since this one is good enough or all will not be. It then
  /// has the extrapolated state.
  bool extrapolates(StepTrial& column) {
    columns_.add(column.state);
    if (columns_.columns() < 2) return false;
    const double share = std::max(kOrderShare, std::min(1.0, kOrderRounding / options_.tolerance));
    column.error = difference(columns_.best(), columns_.lower(), kSpeedErrorTime) / share;
    verdict_ = columns_.judge(column.error);
    if (verdict_ == Extrapolation::Verdict::kGoOn) return false;
    column.order = columns_.columns();
    column.state = columns_.best();
    step_.normalise(column.state.q);
    return true;
  }

  /// One column: n substeps. @return false if a gap closes within it
  bool substeps(double length, int n, StepTrial& column) {
    column.state = state_;
    column.active = closed_;
    column.h = length / n;
    column.smooth = true;
    column.closes = column.changes = -1;
    column.error = 0;
    earlier_.clear();
    scale_impulses(column.active, last_h_ > 0 ? column.h / last_h_ : 0);
    for (int i = 0; i < n; ++i) {
      step_.substep(column.state, column.h, column.active, options_.touch, outcome_);
      count(outcome_);
      if (outcome_.deepest_new < -options_.touch) {
        column.closes = closing_time(column.h, i);
        return false;
      }
      if (column.smooth && !same_modes(column.active, outcome_.active)) {
        column.smooth = false;
        column.changes =
            column.h * (i + share_before_change(earlier_, column.active, outcome_.active));
      }
      earlier_.swap(column.active);
      column.active.swap(outcome_.active);
      if (!column.state.v.allFinite() || !column.state.z.allFinite()) {
        column.error = std::numeric_limits<double>::infinity();
        return false;
      }
    }
    return true;
  }

  /// Instant at which the gap of the last substep closed, if it closed evenly.
  [[nodiscard]] double closing_time(double h, int substep) const {
    const double since = -outcome_.deepest_new / std::max(outcome_.closing_new, 1e-12);
    return h * (substep + 1) - std::min(since, h);
  }

  /// Largest difference of two states over the tolerance. @param horizon  of speeds [s]
  [[nodiscard]] double difference(const SceneState& a, const SceneState& b, double horizon) const {
    double most =
        std::max((a.q - b.q).cwiseAbs().maxCoeff(), horizon * (a.v - b.v).cwiseAbs().maxCoeff());
    // The work of elements, the last state, is told and steers nothing.
    const Eigen::Index states = a.z.size() - 1;
    if (states > 0) most = std::max(most, horizon * (a.z - b.z).head(states).cwiseAbs().maxCoeff());
    return most / options_.tolerance;
  }

  /// One step of order eight, where nothing touches.
  void free_step(double length) {
    StepTrial& trial = table_[0];
    result_ = 0;
    trial.active.clear();
    trial.order = 8;
    trial.smooth = true;
    trial.closes = trial.changes = -1;
    trial.h = length;
    trial.state = state_;
    const FreeStep::Error error = free_.step(step_, length, trial.state);
    trial.error =
        std::max(error.q, kSpeedErrorTime * std::max(error.v, error.z)) / options_.tolerance;
    if (!error.acted) ++tried_unsolved_;
    if (!trial.state.q.allFinite() || !trial.state.v.allFinite() || !trial.state.z.allFinite()) {
      trial.error = std::numeric_limits<double>::infinity();
      return;
    }
    run_.cost.substeps += static_cast<long>(FreeStep::kStages);
    look_between(length, trial);
    if (trial.closes < 0) inspect(length, trial);
  }

  /// Looks for contacts that close in the middle of a free step, where a cubic is that has its ends
  /// and their speeds: they may have opened again where it ends.
  void look_between(double length, StepTrial& trial) {
    if (length <= options_.shortest) return;
    middle_.t = state_.t + 0.5 * length;
    middle_.q = 0.5 * (state_.q + trial.state.q);
    step_.normalise(middle_.q);
    middle_.v = state_.v - trial.state.v;
    advance(step_.scene().mechanism, step_.model().layout, middle_.v, 0.125 * length, middle_.q);
    middle_.v = 0.5 * (state_.v + trial.state.v);
    step_.find(middle_, 0, found_);
    step_.note_new(found_, trial.active, outcome_);
    if (outcome_.deepest_new < -options_.touch)
      trial.closes = std::max(closing_time(0.5 * length, 0), 0.125 * length);
  }

  /// Looks for contacts where a trial ends.
  void inspect(double length, StepTrial& trial) {
    inspected_ = true;
    step_.find(trial.state, kNearGap, found_);
    step_.note_new(found_, trial.active, outcome_);
    if (outcome_.deepest_new < -options_.touch) trial.closes = closing_time(length, 0);
    // Too far to be sure that nothing went through something.
    const double motion = step_.motion_between(state_, trial.state, trial.active);
    if (motion > 1 && length > options_.shortest) {
      trial.error = std::max(trial.error, std::pow(motion, trial.order));
      trial.closes = -1;
    }
  }

  ContactStep step_;
  FixedStep fixed_;
  SceneOptions options_;
  const Progress& progress_;
  std::vector<double> switches_;
  SceneState state_, middle_;
  SceneRun run_;
  double next_sample_ = 0;
  std::vector<ActiveContact> lost_, closed_, found_;  // what touches, with impulses over last_h_
  std::vector<ActiveContact> earlier_;                // of the column, a substep before its last
  double last_h_ = 0;
  long tried_unsolved_ = 0;    // since forget_counts()
  bool was_solved_ = true;     // the last step
  double tried_residual_ = 0;  // the same [1]
  int since_mark_ = 0;
  double mark_ = -1;          // when the steps that are judged began [s]
  double last_error_ = 1;     // of the last accepted step over the tolerance
  double usual_ = 0;          // length of a step that no change of modes bounds [s]
  double change_ahead_ = -1;  // instant at which a mode may change, seen from before [s]; < 0: none
  bool was_before_ = false;   // the last step was shortened for a change of modes ahead
  bool inspected_ = false;    // found_ belongs to the trial
  int asleep_ = 0;
  int result_ = 0;
  double reach_ = 0;  // no step is longer for now [s]
  std::array<StepTrial, Extrapolation::kMostColumns> table_;
  StepOutcome outcome_;
  FreeStep free_;
  Extrapolation columns_;
  Extrapolation::Verdict verdict_ = Extrapolation::Verdict::kGoOn;  // on the last column, if any
};

/// Steps of fixed length from the start to the end.
SceneRun run_fixed(const MovingScene& scene, const SceneOptions& options,
                   const Progress& progress) {
  SceneStepper stepper(scene, options);
  SceneRun run;
  double next_sample = 0;
  const auto keep = [&] {
    run.samples.push_back(stepper.sample());
    next_sample = options.sample *
                  static_cast<double>(std::lround(stepper.now().state.t / options.sample) + 1);
  };
  keep();
  const long steps = fixed_steps(options);
  for (long i = 0; i < steps && run.status == SceneStatus::kDone; ++i) {
    if (!stepper.step()) {
      run.status = SceneStatus::kStopped;
      break;
    }
    const double t = stepper.now().state.t;
    if (!is_finite(stepper.now().state)) {
      run.status = SceneStatus::kNotFinite;
      break;
    }
    progress(t / options.seconds, "");
    if (progress.stop())
      run.status = SceneStatus::kStopped;
    else if (t >= next_sample - 0.5 * stepper.length() || i + 1 == steps)
      keep();
  }
  run.cost = stepper.cost();
  return run;
}

}  // namespace

const std::vector<std::string>& stepping_names() {
  static const std::vector<std::string> names{"events", "time-stepping", "compliant-simbody",
                                              "compliant-sundials"};
  return names;
}

const std::vector<std::string>& friction_ramp_names() {
  static const std::vector<std::string> names{"quintic", "linear"};
  return names;
}

std::string name_of(SceneStatus status) {
  static const std::vector<std::string> names{"done",       "stopped", "unsolved",
                                              "not finite", "failed",  "energy does not balance"};
  return names[static_cast<std::size_t>(status)];
}

void check_scene_options(const SceneOptions& options) {
  require(options.seconds > 0 && std::isfinite(options.seconds), "wanted seconds above 0, got {}",
          options.seconds);
  require(options.sample > 0 && options.step > 0 && options.longest > 0 && options.tolerance > 0 &&
              options.shortest > 0 && options.touch > 0 && options.recovery >= 0,
          "wanted steps, samples, tolerances and lengths above 0");
  require(options.columns >= 2 && options.columns <= Extrapolation::kMostColumns,
          "wanted 2 to {} columns, got {}", Extrapolation::kMostColumns, options.columns);
}

SceneRun simulate_scene(const MovingScene& scene, const SceneOptions& options,
                        const Progress& progress) {
  check_scene_options(options);
  require(
      options.method == SteppingMethod::kEvents || options.method == SteppingMethod::kTimeStepping,
      "wanted events or time-stepping, got {}",
      stepping_names()[static_cast<std::size_t>(options.method)]);
  const double start = thread_seconds();
  SceneRun run = options.method == SteppingMethod::kEvents
                     ? Simulation(scene, options, progress).run()
                     : run_fixed(scene, options, progress);
  run.cost.cpu_seconds = thread_seconds() - start;
  if (run.status == SceneStatus::kDone && run.cost.unsolved > 0)
    run.status = SceneStatus::kUnsolved;
  const bool is_whole = run.status == SceneStatus::kDone || run.status == SceneStatus::kUnsolved;
  if (is_whole && !worst_balance(run.samples).holds()) run.status = SceneStatus::kUnbalanced;
  return run;
}

}  // namespace thenar
