#include "live/live_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

constexpr long kStepsBetweenLooks = 16;  // at whether to stop

}  // namespace

LiveMotion::LiveMotion(MotionSource source, const HistoryLimits& limits)
    : source_(std::move(source)),
      picture_(scene_picture(*source_.built, source_.camera)),
      stepper_(source_.built->scene, source_.built->options),
      inputs_(stepper_),
      history_(limits) {
  // Bodies that move, and which reading is the tension of each muscle that is drawn.
  moving_ = moving_bodies(scene().mechanism, stepper_.model());
  readings_ = stepper_.readings();
  for (const std::string& muscle : picture_.tendons.muscles()) {
    const int found = place_named(readings_, muscle);
    require(found >= 0, "no element says what pulls '{}'", muscle);
    tension_at_.push_back(static_cast<std::size_t>(found));
  }
  begin();
}

void LiveMotion::begin() {
  quality_ = {};
  beyond_ = {};
  (void)stepper_.take_cost();
  start_ = stepper_.sample();
  history_.clear();
  keep();
}

void LiveMotion::keep() {
  newest_.at = stepper_.now();
  // Keep contacts of soft pads only where there are some: they are large.
  if (source_.built->pads > 0) newest_.pads = stepper_.element_contacts();
  newest_.readings.clear();
  if (!readings_.empty())
    for (const ElementValue& value : stepper_.readings()) newest_.readings.push_back(value.value);
  newest_.efforts.clear();
  for (std::size_t c = 0; c < inputs_.coordinates().size(); ++c)
    newest_.efforts.push_back(stepper_.effort(static_cast<int>(c), newest_.at));
  history_.add(newest_);
  shown_ = history_.size() - 1;
  ++changes_;
}

// Time.

MotionQuality LiveMotion::step(long count, const Progress& progress) {
  // The past is shown: forget what came behind it and go on from there.
  if (!is_newest()) {
    history_.cut_behind(shown_);
    stepper_.go_to(shown());
  }
  // Report the quality of these steps alone, beside that of the whole motion.
  MotionQuality out;
  // Progress of one step is a part of that of all.
  long made = 0;
  Progress within = progress;
  within.report = [&](double part, const std::string& what) {
    progress((static_cast<double>(made) + part) / static_cast<double>(count), what);
  };
  // Steps until one is bad, the caller stops, or play passes its end.
  bool good = true;
  for (; made < count && good; ++made) {
    if (made % kStepsBetweenLooks == 0) {
      if (progress.stop()) break;
      within(0, "stepping");
    }
    try {
      if (!stepper_.step(within)) break;
    } catch (const Error&) {
      // As where numbers are too large for contacts to be looked for: the steps before count.
      take_quality(out);
      stand_still();
      throw;
    }
    good = is_finite(stepper_.now().state);
    if (!good) continue;
    keep();
    ++out.steps;
    if (playing_ && passes_end()) {
      playing_ = false;
      break;
    }
  }
  take_quality(out);
  if (good) return out;
  stand_still();
  throw InputError(fmt::format(
      "after {:.6g} s positions or speeds are not finite any more: the motion stands where they "
      "were last; try shorter steps or smaller inputs",
      shown().state.t));
}

bool LiveMotion::passes_end() const {
  const double end = source_.duration.value_or(-1), near = 0.5 * stepper_.length();
  const double to = shown().state.t, from = to - stepper_.length();
  return from + near < end && end <= to + near;
}

void LiveMotion::take_quality(MotionQuality& of) {
  // Take the costs since the last look, and add them to the totals.
  const SceneCost cost = stepper_.take_cost();
  of.unsolved = cost.unsolved;
  of.leaps = cost.leaps;
  of.worst_residual = cost.worst_residual;
  of.deepest = cost.deepest;
  quality_.steps += of.steps;
  quality_.unsolved += of.unsolved;
  quality_.leaps += of.leaps;
  quality_.worst_residual = std::max(quality_.worst_residual, of.worst_residual);
  quality_.deepest = std::max(quality_.deepest, of.deepest);
  keep_max_excess(cost.beyond, beyond_);
  add_account(cost.beyond, of);
}

void LiveMotion::add_account(const Eigen::VectorXd& beyond, MotionQuality& of) const {
  of.balance = flow_balance(start_, stepper_.sample_of(shown()));
  of.limits = passed_limits(scene().mechanism, beyond);
  of.restitution = max_restitution(scene());
}

MotionQuality LiveMotion::quality() const {
  MotionQuality out = quality_;
  add_account(beyond_, out);
  return out;
}

void LiveMotion::stand_still() {
  stepper_.go_to(shown());
  playing_ = false;
}

double LiveMotion::seek(double t) {
  shown_ = history_.nearest(t);
  playing_ = false;  // play would forget what came behind
  ++changes_;
  return shown().state.t;
}

void LiveMotion::reset() {
  stepper_.reset();
  inputs_.clear();
  playing_ = false;
  begin();
}

LiveTime LiveMotion::live_time() const {
  LiveTime out;
  out.t = shown().state.t;
  out.step = stepper_.length();
  out.playing = playing_;
  out.speed = speed_;
  out.duration = source_.duration;
  return out;
}

// What is shown.

std::vector<ContactSample> LiveMotion::contacts() const {
  const PastInstant& past = history_.at(shown_);
  std::vector<ContactSample> all = contact_samples(past.at.active, past.at.part);
  all.insert(all.end(), past.pads.begin(), past.pads.end());
  return all;
}

std::vector<Pose<double>> LiveMotion::poses() const {
  std::vector<Pose<double>> out;
  stepper_.poses(shown(), out);
  return out;
}

LiveInstant LiveMotion::instant() const {
  const SceneState& state = shown().state;
  const std::vector<Pose<double>> X_WB = poses();
  return scene_instant(picture_, scene(), stepper_.model().layout,
                       {state.t, state.q, X_WB, contacts(), tension()});
}

std::vector<ElementValue> LiveMotion::muscles() const {
  std::vector<ElementValue> out = readings_;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].value = history_.at(shown_).readings[i];
  return out;
}

Eigen::VectorXd LiveMotion::tension() const {
  Eigen::VectorXd out(static_cast<Eigen::Index>(tension_at_.size()));
  for (std::size_t m = 0; m < tension_at_.size(); ++m)
    out[m] = history_.at(shown_).readings[tension_at_[m]];
  return out;
}

void LiveMotion::add_joints(TimelineState& out) const {
  const MechanismLayout& layout = stepper_.model().layout;
  const SceneState& state = shown().state;
  // Positions and speeds are those of the instant shown.
  // Efforts of the present follow inputs as they are set, those of the past stay.
  for (std::size_t c = 0; c < inputs_.coordinates().size(); ++c)
    out.joints.push_back({inputs_.coordinates()[c], state.q[layout.coordinate_q[c]],
                          state.v[layout.coordinate_v[c]],
                          is_newest() ? stepper_.effort(static_cast<int>(c), shown())
                                      : history_.at(shown_).efforts[c]});
}

void LiveMotion::add_bodies(TimelineState& out) const {
  const SceneState& state = shown().state;
  const std::vector<Pose<double>> X_WB = poses();
  const std::vector<SceneVelocity> velocities =
      body_velocities(scene().mechanism, stepper_.model(), state.q, state.v);
  for (const std::size_t i : moving_)
    out.bodies.push_back({scene().mechanism.bodies[i].name, X_WB[i], velocities[i]});
}

MotionEnergy LiveMotion::energy() const {
  const SceneSample sample = stepper_.sample_of(shown());
  return {sample.energy.kinetic, sample.energy.weight, sample.energy.springs,
          flow_balance(start_, sample), sample.energy.total()};
}

TimelineState LiveMotion::state(const MotionParts& parts) const {
  TimelineState out;
  // Fill only the parts that were asked for, as contacts are many.
  out.t = shown().state.t;
  if (parts.joints) add_joints(out);
  if (parts.bodies) add_bodies(out);
  if (parts.contacts) {
    out.contacts = contacts();
    for (const MechanismBody& body : scene().mechanism.bodies) out.body_names.push_back(body.name);
  }
  if (parts.energy) out.energy = energy();
  if (parts.muscles) out.muscles = muscles();
  return out;
}

}  // namespace thenar
