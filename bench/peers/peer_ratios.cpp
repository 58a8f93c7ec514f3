// Prints how many times less processor time our scenes take than other engines', for the engines
// that are installed, like bench/ratios. Exit code 1 if a row misses.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "bench/peers/peer_machine.h"
#include "bench/peers/peer_tasks.h"
#include "bench/ratios.h"

namespace thenar::bench {
namespace {

constexpr int kTurns = 5;

/// A setting at a knob.
struct Contender {
  PeerSetting setting;
  double knob;

  [[nodiscard]] PeerRun run(const PeerTask& task) const { return setting.run(task.peer, knob); }
};

PeerTask task_named(const std::string& name) {
  for (PeerTask& task : contact_tasks())
    if (task.peer.name == name) return std::move(task);
  throw InputError(fmt::format("there is no scene '{}'", name));
}

PeerSetting setting_named(const std::vector<PeerSetting>& all, const std::string& name) {
  for (const PeerSetting& setting : all)
    if (setting.setting == name) return setting;
  throw InputError(fmt::format("there is no setting '{}'", name));
}

bool print(const Row& row) {
  fmt::print("{:<60}{:>11.1f}{:>12.1f}{:>9.1f}{:>10}{:>10.1e}{:>11}\n", row.name, row.ours,
             row.rival, row.ratio, row.required > 0 ? fmt::format("{:.0f}", row.required) : "none",
             row.error, row.pass() ? "PASS" : "MISS");
  std::fflush(stdout);
  return row.pass();
}

/// Both run the scene in turns. @param row  name and what is required; the rest is filled
bool duel(const PeerTask& task, const Contender& ours, const Contender& rival, Row row) {
  std::vector<double> our_times, rival_times, ratios;
  for (int turn = 0; turn < kTurns; ++turn) {
    our_times.push_back(1e6 * ours.run(task).cpu_seconds);
    rival_times.push_back(1e6 * rival.run(task).cpu_seconds);
    ratios.push_back(rival_times.back() / our_times.back());
  }
  row.ours = median(our_times);
  row.rival = median(rival_times);
  row.ratio = median(ratios);
  return print(row);
}

/// The loosest knob of a geometric row at which a run errs by no more than `most`.
Contender loosest(const PeerTask& task, const PeerSetting& setting, double first, double factor,
                  double most) {
  for (double knob = first; knob > 1e-14; knob *= factor)
    if (const PeerRun run = setting.run(task.peer, knob);
        run.message.empty() && task.error.of(run) <= most)
      return {setting, knob};
  throw InputError(fmt::format("{} does not reach {:g}", setting.name(), most));
}

Contender our_events(const std::string& name, double tolerance) {
  return {setting_named(our_settings(), name), tolerance};
}

/// The grip that stays, at rest and awake.
[[maybe_unused]] bool hold(const std::string& rival_name, const Contender& rival) {
  const PeerTask task = task_named("pinch");
  const Contender asleep = our_events("events", 1e-9), awake = our_events("events, no sleep", 1e-9);
  Row row{fmt::format("pinch for 10 s, slip [mm]: {}", rival_name)};
  row.required = 10;
  row.error = task.error.of(asleep.run(task));
  row.tolerance = 1e-9;
  const bool passed = duel(task, asleep, rival, row);
  row.name = "the same, without sleep";
  row.required = 0;
  row.error = task.error.of(awake.run(task));
  duel(task, awake, rival, row);
  return passed;
}

/// The grip whose cube swings.
[[maybe_unused]] bool swing(const std::string& rival_name, const Contender& rival) {
  const PeerTask task = task_named("swinging pinch");
  const Contender ours = our_events("events", 1e-5);
  Row row{fmt::format("swinging pinch for 10 s, drift over: {}", rival_name)};
  row.required = 1;
  row.error = task.error.of(ours.run(task)) / task.error.of(rival.run(task));
  row.tolerance = 0.01;
  return duel(task, ours, rival, row);
}

/// The hand that swings freely.
bool free_hand(const std::string& rival_name, const PeerSetting& rival, double required) {
  const PeerTask task = task_named("free hand");
  const PeerSetting events = setting_named(our_settings(), "events");
  const double finer = std::pow(0.1, 1.0 / 12);
  const Contender ours = loosest(task, events, 1e-6, finer, 1e-6);
  const Contender theirs = loosest(task, rival, rival.adaptive ? 1e-5 : 1e-3, finer, 1e-6);
  Row row{fmt::format("free hand to 1e-6 rad: {} at {:.2g}", rival_name, theirs.knob)};
  row.required = required;
  row.error = task.error.of(ours.run(task));
  row.tolerance = 1e-6;
  return duel(task, ours, theirs, row);
}

/// Accelerations of the 21 joints.
bool forward_dynamics() {
  const MovingScene scene = task_named("free hand").peer.scene;
  const PeerMachine ours = our_machine(scene);
  Eigen::VectorXd q = scene.q;
  const auto turned = [&]() -> const Eigen::VectorXd& {
    q[0] = 0.6 - q[0];  // so that nothing is known beforehand
    return q;
  };
  std::vector<PeerMachine> rivals{simbody_machine(scene)};
#ifdef THENAR_HAS_DART
  rivals.push_back(dart_machine(scene));
#endif
#ifdef THENAR_HAS_MUJOCO
  rivals.push_back(mujoco_machine(scene));
#endif
  Row limit{"forward dynamics of 21 joints: 3.5 us"};
  limit.ours = std::numeric_limits<double>::infinity();
  for (const PeerMachine& rival : rivals) {
    Duel task{fmt::format("forward dynamics of 21 joints: {}", rival.engine), {}, {}, 0, 0, 1e-9};
    const Eigen::VectorXd expected = ours.of(scene.q, scene.v);
    task.error = (rival.of(scene.q, scene.v) - expected).norm() / expected.norm();
    task.ours = [&] { keep(ours.of(turned(), scene.v)); };
    task.rival = [&] { keep(rival.of(turned(), scene.v)); };
    const Row row = measure(task);
    print(row);
    limit.ours = std::min(limit.ours, row.ours);  // a busy machine only makes it longer
  }
  limit.rival = 3.5;
  limit.ratio = limit.rival / limit.ours;
  limit.required = 1;
  return print(limit);
}

bool all_rows() {
  fmt::print("{:<60}{:>11}{:>12}{:>9}{:>10}{:>10}{:>11}\n", "", "ours [us]", "rival [us]", "ratio",
             "required", "error", "verdict");
  bool pass = forward_dynamics();
#ifdef THENAR_HAS_MUJOCO
  const std::vector<PeerSetting> mujoco = mujoco_settings();
  pass = hold("MuJoCo, grasp recipe, 1 ms", {setting_named(mujoco, "grasp recipe"), 1e-3}) && pass;
  pass = swing("MuJoCo, noslip, stiff, 1 ms",
               {setting_named(mujoco, "recipe, noslip 10, stiff"), 1e-3}) &&
         pass;
  pass = free_hand("MuJoCo RK4", setting_named(mujoco, "RK4"), 5) && pass;
#endif
#ifdef THENAR_HAS_ODE
  const Contender ode{setting_named(ode_settings(), "Step"), 1e-3};
  pass = hold("ODE, dWorldStep, 1 ms", ode) && pass;
  pass = swing("ODE, dWorldStep, 1 ms", ode) && pass;
#endif
  pass = free_hand("Simbody Runge-Kutta-Merson",
                   setting_named(simbody_settings(), "Runge-Kutta-Merson"), 30) &&
         pass;
  free_hand("Simbody CPodes", setting_named(simbody_settings(), "CPodes, Adams"), 0);
  fmt::print(
      "Processor times of whole runs, without building the scene; accelerations: of one call.\n"
      "Free hands: each at the loosest of twelve knobs a decade that reaches 1e-6 rad.\n");
  return pass;
}

}  // namespace
}  // namespace thenar::bench

int main() {
  try {
    return thenar::bench::all_rows() ? 0 : 1;
  } catch (const thenar::Error& error) {
    fmt::print(stderr, "peer_ratios: {}\n", error.what());
    return 2;
  }
}
