#include "dynamics/compliant/compliant_run.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/thread_seconds.h"
#include "dynamics/compliant/penalty_law.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar::internal {
namespace {

constexpr double kSameInstant = 1e-12;  // nearer instants are one [s]

/// Samples and steps of one run.
class CompliantLoop {
 public:
  CompliantLoop(CompliantMotion& motion, const MovingScene& scene, const SceneOptions& options)
      : motion_(motion), energy_(scene), options_(options), stops_(switching_times(scene)) {
    // Spans end where something begins or ends to act.
    stops_.erase(std::remove_if(stops_.begin(), stops_.end(),
                                [&](double t) { return t <= 0 || t >= options.seconds; }),
                 stops_.end());
    stops_.push_back(options.seconds);
  }

  SceneRun run(const Progress& progress) {
    // Sample the start, then span after span.
    const double start = thread_seconds();
    contacts_ = motion_.contacts(stored_);
    sample();
    double from = 0;
    for (std::size_t i = 0; i < stops_.size() && run_.status == SceneStatus::kDone; ++i) {
      motion_.begin_span(from);
      span(stops_[i], progress);
      from = stops_[i];
    }
    // Take over the counts of the integrator.
    run_.cost.substeps = motion_.evaluations();
    run_.cost.rejected = motion_.rejected();
    run_.cost.cpu_seconds = thread_seconds() - start;
    return std::move(run_);
  }

 private:
  /// Goes on to an instant at which something begins or ends to act.
  void span(double end, const Progress& progress) {
    // Steps up to the next sample or the end of the span.
    while (end - motion_.state().t > kSameInstant) {
      progress(motion_.state().t / options_.seconds, "");
      if (progress.stop()) {
        run_.status = SceneStatus::kStopped;
        return;
      }
      const double next = options_.sample * static_cast<double>(samples_);
      CompliantStep step = motion_.step(std::min(end, next));
      if (step.status != SceneStatus::kDone) {
        run_.status = step.status;
        run_.message = std::move(step.message);
        return;
      }
      // Cost, depths and limits of the step.
      ++run_.cost.steps;
      note_depth();
      update_limit_excess(energy_.scene().mechanism, energy_.model().layout, motion_.state().q,
                          run_.cost.beyond);
      const double t = motion_.state().t;
      if (t >= next - kSameInstant || t >= options_.seconds - kSameInstant) sample();
    }
  }

  void note_depth() {
    contacts_ = motion_.contacts(stored_);
    for (const ContactSample& contact : contacts_)
      run_.cost.deepest = std::max(run_.cost.deepest, -contact.gap);
  }

  void sample() {
    const SceneState& state = motion_.state();
    SceneSample out;
    out.t = state.t;
    out.q = state.q;
    out.v = state.v;
    out.contacts = contacts_;
    out.energy = energy_.energy(state);
    out.energy.springs += stored_;
    run_.samples.push_back(std::move(out));
    samples_ = std::lround(state.t / options_.sample) + 1;
  }

  CompliantMotion& motion_;
  ContactStep energy_;
  const SceneOptions& options_;
  std::vector<double> stops_;
  std::vector<ContactSample> contacts_;  // at the state
  double stored_ = 0;                    // of their springs [J]
  long samples_ = 0;                     // the next is at so many lengths of one
  SceneRun run_;
};

void refuse_restitution(const PairFriction& pair) {
  require(pair.restitution == 0,
          "contacts that yield bounce by their dissipation, not by a restitution of {}",
          pair.restitution);
}

}  // namespace

double StepReach::follow(ContactStep& step, const SceneState& before, const SceneState& after) {
  // Contacts that touch stick, so that their pairs are not looked at.
  step.find_contacts(after, 0, touching_);
  for (ActiveContact& contact : touching_) contact.mode = ContactMode::kStick;
  const double motion = step.tunnelling_ratio(before, after, touching_);
  // Next length, by which surfaces may move half of what is allowed.
  length_ = motion > 0 ? 0.5 * (after.t - before.t) / motion : longest_;
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
