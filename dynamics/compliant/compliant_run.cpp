#include "dynamics/compliant/compliant_run.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/thread_seconds.h"
#include "dynamics/compliant/penalty_law.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar::internal {
namespace {

constexpr double kSameInstant = 1e-12;  // largest difference of equal instants [s]
constexpr double kMotionRatio = 0.5;    // surface motion of the next step over its limit [1]

/// Time loop of one run, with its samples and costs.
class CompliantLoop {
 public:
  CompliantLoop(CompliantMotion& motion, const MovingScene& scene, const SceneOptions& options)
      : motion_(motion), energy_(scene), options_(options), stops_(switching_times(scene)) {
    // A time span ends where a force or drive starts or stops to act.
    erase_where(stops_, [&](double t) { return t <= 0 || t >= options.duration; });
    stops_.push_back(options.duration);
  }

  SceneRun run(const Progress& progress) {
    // Sample the initial state, then run the time spans.
    const double start = thread_seconds();
    contacts_ = motion_.contacts();
    add_sample();
    double from = 0;
    for (std::size_t i = 0; i < stops_.size() && run_.status == SceneStatus::kDone; ++i) {
      motion_.begin_span(from);
      run_span(stops_[i], progress);
      from = stops_[i];
    }
    // Copy the counters of the integrator.
    run_.cost.substeps = motion_.evaluations();
    run_.cost.rejected = motion_.rejected();
    run_.cost.cpu_seconds = thread_seconds() - start;
    return std::move(run_);
  }

 private:
  /// Runs to the end of a time span in which the same forces and drives act [s].
  void run_span(double end, const Progress& progress) {
    while (end - motion_.state().t > kSameInstant) {
      progress(motion_.state().t / options_.duration, "");
      if (progress.stop()) {
        run_.status = SceneStatus::kStopped;
        return;
      }
      // Step at most to the next sample or to the end of the span.
      const double next = options_.sample_interval * static_cast<double>(next_sample_);
      CompliantStep step = motion_.step(std::min(end, next));
      if (step.status != SceneStatus::kDone) {
        run_.status = step.status;
        run_.message = std::move(step.message);
        return;
      }
      // Record cost, depths and excess over joint limits.
      ++run_.cost.steps;
      update_depth();
      update_limit_excess(energy_.scene().mechanism, energy_.model().layout, motion_.state().q,
                          run_.cost.limit_excess);
      const double t = motion_.state().t;
      if (t >= next - kSameInstant || t >= options_.duration - kSameInstant) add_sample();
    }
  }

  void update_depth() {
    contacts_ = motion_.contacts();
    for (const ContactSample& contact : contacts_.samples)
      run_.cost.max_penetration = std::max(run_.cost.max_penetration, -contact.gap);
  }

  void add_sample() {
    const SceneState& state = motion_.state();
    run_.samples.push_back(
        {state.t, state.q, state.v, {}, contacts_.samples, energy_.energy(state), {}});
    run_.samples.back().energy.springs += contacts_.energy;
    next_sample_ = std::lround(state.t / options_.sample_interval) + 1;
  }

  CompliantMotion& motion_;
  ContactStep energy_;
  const SceneOptions& options_;
  std::vector<double> stops_;   // ends of the time spans [s]
  CompliantContacts contacts_;  // contacts in the present state
  long next_sample_ = 0;        // index of the next sample
  SceneRun run_;
};

void refuse_restitution(const PairFriction& pair) {
  require(pair.restitution == 0,
          "contacts that yield bounce by their dissipation, not by a restitution of {}",
          pair.restitution);
}

}  // namespace

double StepLimiter::update(ContactStep& step, const SceneState& before, const SceneState& after) {
  // Mark closed contacts as sticking, so that tunnelling_ratio() leaves out their pairs.
  step.find_contacts(after, 0, touching_);
  for (ActiveContact& contact : touching_) contact.mode = ContactMode::kStick;
  const double motion = step.tunnelling_ratio(before, after, touching_);
  // Length of the next step at the same speed.
  length_ = motion > 0 ? kMotionRatio * (after.t - before.t) / motion : longest_;
  return motion;
}

SceneRun run_compliant(CompliantMotion& motion, const MovingScene& scene,
                       const SceneOptions& options, const Progress& progress) {
  return CompliantLoop(motion, scene, options).run(progress);
}

void check_compliant(const MovingScene& scene, const SceneOptions& options) {
  check_scene(scene);
  check_scene_options(options);
  check_compliance(options.compliance);
  require(scene.elements.empty(),
          "contacts that yield are not simulated with ligaments, tendons or joints that give: this "
          "scene has '{}'",
          scene.elements.empty() ? "" : scene.elements.front()->name());
  refuse_restitution(scene.friction);
  for (const auto& [bodies, pair] : scene.friction_pairs) refuse_restitution(pair);
}

}  // namespace thenar::internal
