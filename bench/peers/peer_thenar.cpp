// Scenes in our own stepping.

#include <memory>

#include "bench/peers/peer_machine.h"
#include "bench/peers/peer_scene.h"
#include "dynamics/compliant/penalty_scene.h"
#include "dynamics/compliant/simbody_scene.h"
#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar::bench {
namespace {

using Simulate = SceneRun (*)(const MovingScene&, const SceneOptions&, const Progress&);

PeerRun run_ours(const PeerScene& peer, SceneOptions options, Simulate simulate = &simulate_scene) {
  options.duration = peer.seconds;
  options.sample_interval = peer.sample;
  const double start = thread_seconds();
  Progress progress;
  progress.stop_requested = [&] { return thread_seconds() - start > kPatience; };
  const SceneRun ours = simulate(peer.scene, options, progress);
  PeerRun run;
  for (const SceneSample& sample : ours.samples)
    run.samples.push_back({sample.t, motion_at(peer.scene, sample.q, sample.v)});
  run.cpu_seconds = ours.cost.cpu_seconds;
  // Energy that does not balance is an error of the motion, which is measured.
  if (ours.status != SceneStatus::kDone && ours.status != SceneStatus::kUnbalanced)
    run.message = ours.status == SceneStatus::kStopped ? "too slow" : name_of(ours.status);
  return run;
}

PeerSetting events(const std::string& name, PeerUse use, bool sleep,
                   int columns = SceneOptions{}.columns) {
  return {"thenar", name, true,
          [=](const PeerScene& scene, double tolerance) {
            SceneOptions options;
            options.tolerance = tolerance;
            options.sleep = sleep;
            options.columns = columns;
            return run_ours(scene, options);
          },
          use};
}

/// Contacts that yield, `stiffer` times stiffer than by default and the transition speed as much
/// lower.
PeerSetting compliant(const std::string& engine, const std::string& name, Simulate simulate,
                      double stiffer) {
  return {
      engine, name, true,
      [=](const PeerScene& scene, double tolerance) {
        SceneOptions options;
        options.tolerance = tolerance;
        options.compliance.modulus *= stiffer;
        options.compliance.stiffness *= stiffer;
        options.compliance.transition /= stiffer;
        options.compliance.dissipation = 10;
        try {
          return run_ours(scene, options, simulate);
        } catch (const InputError&) {
          return PeerRun{{{0, motion_at(scene.scene, scene.scene.q, scene.scene.v)}}, 0, "cannot"};
        }
      },
      PeerUse::kContacts};
}

/// The recursion that scenes of hinges run.
struct OurMachine {
  explicit OurMachine(const MovingScene& scene)
      : model(tree_model(scene.mechanism)), motion(model), machine(model), gravity(scene.gravity) {
    none = accelerations = Eigen::VectorXd::Zero(model.layout.v);
  }

  const Eigen::VectorXd& operator()(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    motion.set_position(q);
    motion.set_speed(v);
    motion.clear_loads();
    machine.accelerations(motion, gravity, none, accelerations);
    return accelerations;
  }

  TreeModel model;
  TreeMotion<double> motion;
  ArticulatedBody<double> machine;
  Eigen::Vector3d gravity;
  Eigen::VectorXd none, accelerations;
};

}  // namespace

std::vector<PeerSetting> our_settings() {
  return {
      events("events", PeerUse::kAll, true),
      events("events, no sleep", PeerUse::kContacts, false),
      events("events, no sleep, 8 columns", PeerUse::kContacts, false, 8),
      {"thenar", "time-stepping", false,
       [](const PeerScene& scene, double step) {
         SceneOptions options;
         options.method = SteppingMethod::kTimeStepping;
         options.step_length = step;
         return run_ours(scene, options);
       }},
      compliant("thenar", "compliant-sundials", &simulate_penalty_scene, 1),
      compliant("thenar", "compliant-sundials, 100 times stiffer", &simulate_penalty_scene, 100),
      compliant("Simbody", "compliant", &simulate_simbody_scene, 1),
      compliant("Simbody", "compliant, 100 times stiffer", &simulate_simbody_scene, 100)};
}

PeerMachine our_machine(const MovingScene& scene) {
  auto machine = std::make_shared<OurMachine>(scene);
  return {"thenar",
          [machine](const Eigen::VectorXd& q, const Eigen::VectorXd& v) -> const Eigen::VectorXd& {
            return (*machine)(q, v);
          }};
}

}  // namespace thenar::bench
