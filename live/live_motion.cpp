#include "live/live_motion.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

constexpr long kStepsBetweenStopChecks = 16;  // number of steps between checks for a stop

}  // namespace

LiveMotion::LiveMotion(MotionSource source, const HistoryLimits& limits)
    : source_(std::move(source)),
      picture_(scene_picture(*source_.built, source_.camera)),
      stepper_(source_.built->scene, source_.built->options),
      inputs_(stepper_),
      history_(limits) {
  // Find the moving bodies, and the reading with the tension of each drawn muscle.
  moving_bodies_ = moving_bodies(scene().mechanism, stepper_.model());
  readings_ = stepper_.readings();
  for (const std::string& muscle : picture_.tendons.muscles()) {
    const int found = place_named(readings_, muscle);
    require(found >= 0, "no element says what pulls '{}'", muscle);
    tension_index_.push_back(static_cast<std::size_t>(found));
  }
  start_history();
}

void LiveMotion::start_history() {
  quality_ = {};
  limit_excess_ = {};
  (void)stepper_.take_cost();
  start_sample_ = stepper_.sample();
  history_.clear();
  record_instant();
}

void LiveMotion::record_instant() {
  new_record_.scene = stepper_.now();
  // Copy the state, and the contacts of soft pads if the scene has any.
  if (source_.built->pads > 0) new_record_.pads = stepper_.element_contacts();
  // Copy the readings of force elements and the efforts of drives.
  new_record_.readings.clear();
  if (!readings_.empty())
    for (const ElementValue& value : stepper_.readings())
      new_record_.readings.push_back(value.value);
  new_record_.efforts.clear();
  for (std::size_t c = 0; c < inputs_.coordinates().size(); ++c)
    new_record_.efforts.push_back(stepper_.effort(static_cast<int>(c), new_record_.scene));
  history_.add(new_record_);
  shown_ = history_.size() - 1;
  ++changes_;
}

// Time.

MotionQuality LiveMotion::step(long count, const Progress& progress) {
  // If an older instant is shown, erase all later ones and continue from there.
  if (!is_newest()) {
    history_.erase_after(shown_);
    stepper_.go_to(shown_instant());
  }
  // Scale the progress of each step to the progress of all steps.
  MotionQuality out;
  long made = 0;
  Progress within = progress;
  within.report = [&](double part, const std::string& what) {
    progress((static_cast<double>(made) + part) / static_cast<double>(count), what);
  };
  // Step until a state is not finite, the caller stops, or playback passes the end.
  bool good = true;
  for (; made < count && good; ++made) {
    if (made % kStepsBetweenStopChecks == 0) {
      if (progress.stop()) break;
      within(0, "stepping");
    }
    try {
      if (!stepper_.step(within)) break;
    } catch (const Error&) {
      // Collision detection fails for huge coordinates; the steps before this one are kept.
      restore_shown_instant();
      collect_quality(out);
      throw;
    }
    good = is_finite(stepper_.now().state);
    if (!good) continue;
    record_instant();
    ++out.steps;
    if (playing_ && passed_end()) {
      playing_ = false;
      break;
    }
  }
  if (!good) restore_shown_instant();
  collect_quality(out);
  if (good) return out;
  throw InputError(
      fmt::format("after {:.6g} s positions or speeds are not finite any more: the motion stays "
                  "where they were last; try shorter steps or smaller inputs",
                  shown_instant().state.t));
}

bool LiveMotion::passed_end() const {
  const double end = source_.duration.value_or(-1), near = 0.5 * stepper_.length();
  const double to = shown_instant().state.t, from = to - stepper_.length();
  return from + near < end && end <= to + near;
}

void LiveMotion::collect_quality(MotionQuality& quality) {
  // Read the costs since the last call, and add them to the totals.
  const SceneCost cost = stepper_.take_cost();
  quality.unsolved = cost.unsolved;
  quality.leaps = cost.tunnelling_steps;
  quality.worst_residual = cost.worst_residual;
  quality.deepest = cost.max_penetration;
  quality_.steps += quality.steps;
  quality_.unsolved += quality.unsolved;
  quality_.leaps += quality.leaps;
  quality_.worst_residual = std::max(quality_.worst_residual, quality.worst_residual);
  quality_.deepest = std::max(quality_.deepest, quality.deepest);
  keep_max_excess(cost.limit_excess, limit_excess_);
  add_balance(cost.limit_excess, quality);
}

void LiveMotion::add_balance(const Eigen::VectorXd& excess, MotionQuality& quality) const {
  quality.balance = flow_balance(start_sample_, stepper_.sample_of(shown_instant()));
  quality.limits = passed_limits(scene().mechanism, excess);
  quality.restitution = max_restitution(scene());
}

MotionQuality LiveMotion::quality() const {
  MotionQuality out = quality_;
  add_balance(limit_excess_, out);
  return out;
}

void LiveMotion::restore_shown_instant() {
  stepper_.go_to(shown_instant());
  playing_ = false;
}

double LiveMotion::seek(double t) {
  shown_ = history_.nearest_index(t);
  playing_ = false;  // playing on would erase the later instants
  ++changes_;
  return shown_instant().state.t;
}

void LiveMotion::reset() {
  stepper_.reset();
  inputs_.clear();
  playing_ = false;
  start_history();
}

LiveTime LiveMotion::live_time() const {
  return {shown_instant().state.t, stepper_.length(), playing_, speed_, source_.duration};
}

// State of the instant that is shown.

std::vector<ContactSample> LiveMotion::contacts() const {
  const PastInstant& past = history_.instant(shown_);
  std::vector<ContactSample> all = contact_samples(past.scene.active, past.scene.part);
  append_all(all, past.pads);
  return all;
}

std::vector<Pose<double>> LiveMotion::poses() const {
  std::vector<Pose<double>> out;
  stepper_.poses(shown_instant(), out);
  return out;
}

LiveInstant LiveMotion::instant() const {
  const SceneState& state = shown_instant().state;
  const std::vector<Pose<double>> X_WB = poses();
  return scene_instant(picture_, scene(), stepper_.model().layout,
                       {state.t, state.q, X_WB, contacts(), tension()});
}

std::vector<ElementValue> LiveMotion::muscles() const {
  std::vector<ElementValue> out = readings_;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].value = history_.instant(shown_).readings[i];
  return out;
}

Eigen::VectorXd LiveMotion::tension() const {
  Eigen::VectorXd out(static_cast<Eigen::Index>(tension_index_.size()));
  for (std::size_t m = 0; m < tension_index_.size(); ++m)
    out[m] = history_.instant(shown_).readings[tension_index_[m]];
  return out;
}

void LiveMotion::add_joints(TimelineState& out) const {
  const MechanismLayout& layout = stepper_.model().layout;
  const SceneState& state = shown_instant().state;
  // Efforts of the newest instant follow the current inputs; those of older instants are recorded.
  for (std::size_t c = 0; c < inputs_.coordinates().size(); ++c)
    out.joints.push_back({inputs_.coordinates()[c], state.q[layout.coordinate_q[c]],
                          state.v[layout.coordinate_v[c]],
                          is_newest() ? stepper_.effort(static_cast<int>(c), shown_instant())
                                      : history_.instant(shown_).efforts[c]});
}

void LiveMotion::add_bodies(TimelineState& out) const {
  const SceneState& state = shown_instant().state;
  const std::vector<Pose<double>> X_WB = poses();
  const std::vector<SceneVelocity> velocities =
      body_velocities(scene().mechanism, stepper_.model(), state.q, state.v);
  for (const std::size_t i : moving_bodies_)
    out.bodies.push_back({scene().mechanism.bodies[i].name, X_WB[i], velocities[i]});
}

MotionEnergy LiveMotion::energy() const {
  const SceneSample sample = stepper_.sample_of(shown_instant());
  return {sample.energy.kinetic, sample.energy.weight, sample.energy.springs,
          flow_balance(start_sample_, sample), sample.energy.total()};
}

TimelineState LiveMotion::state(const MotionParts& parts) const {
  TimelineState out;
  // Fill only the selected parts: contacts can be many.
  out.t = shown_instant().state.t;
  if (parts.joints) add_joints(out);
  if (parts.bodies) add_bodies(out);
  if (parts.contacts) {
    out.contacts = contacts();
    out.body_names = names_of(scene().mechanism.bodies);
  }
  if (parts.energy) out.energy = energy();
  if (parts.muscles) out.muscles = muscles();
  return out;
}

}  // namespace thenar
