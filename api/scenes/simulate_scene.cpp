#include "api/scenes/simulate_scene.h"

#include <set>

#include "api/scenes/scene_account.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/parallel_for.h"
#include "base/parallel_tasks.h"
#include "dynamics/compliant/penalty_scene.h"
#include "dynamics/compliant/simbody_scene.h"
#include "dynamics/scene/run_bytes.h"
#include "dynamics/stepping/simulate_scene.h"
#include "sampling/run/communicator.h"

namespace thenar {
namespace {

/// Simulates a scene by whatever method its options name.
SceneRun simulate_by_method(const MovingScene& scene, const SceneOptions& options,
                            const Progress& progress) {
  if (options.method == SteppingMethod::kCompliantSimbody)
    return simulate_simbody_scene(scene, options, progress);
  if (options.method == SteppingMethod::kCompliantSundials)
    return simulate_penalty_scene(scene, options, progress);
  return simulate_scene(scene, options, progress);
}

Status status_of(const SceneResult& scene) {
  if (scene.run.status == SceneStatus::kStopped) return Status::kStopped;
  return refusal_of(scene).empty() ? Status::kSolved : Status::kStalled;
}

/// Simulates, unless that was done, and measures a scene with some numbers changed.
SceneResult simulated(const RequestedScene& read,
                      const std::vector<std::pair<std::string, double>>& numbers,
                      const Progress& progress, std::optional<SceneRun> done = {}) {
  SceneResult out;
  // Copy names and inputs for the provenance of the result.
  out.name = read.spec.name;
  out.description = read.spec.description;
  out.camera = read.spec.camera;
  out.sources = read.open.sources;
  out.files = read.open.files;
  out.varied = numbers;
  out.request = read.request;
  // Change the numbers in a copy, since runs share their input.
  auto built = std::make_shared<BuiltScene>(read.open.built);
  for (const auto& [name, value] : numbers) set_number(*built, name, value);
  out.run = done ? std::move(*done) : simulate_by_method(built->scene, built->options, progress);
  out.measures = measure_run(built->scene, out.run);
  out.built = std::move(built);
  out.outcome.status = status_of(out);
  out.outcome.warnings = scene_warnings(out);
  return out;
}

/// The numbers of one run of a sweep; the last one varies fastest.
std::vector<std::pair<std::string, double>> numbers_of(const std::vector<SceneVariation>& vary,
                                                       std::size_t run) {
  std::vector<std::pair<std::string, double>> numbers(vary.size());
  for (std::size_t k = vary.size(); k-- > 0;) {
    const auto count = static_cast<std::size_t>(vary[k].count);
    numbers[k] = {vary[k].name, vary[k].value(static_cast<int>(run % count))};
    run /= count;
  }
  return numbers;
}

/// Runs in one sweep. @throws InputError if a variation is none, or there are too many
std::size_t count_runs(const std::vector<SceneVariation>& vary) {
  std::size_t runs = 1;
  std::set<std::string> names;
  for (const SceneVariation& each : vary) {
    require_field("vary", each.count >= 1, "wanted at least one value of '{}', got {}", each.name,
                  each.count);
    require_field("vary", names.insert(each.name).second, "'{}' varies twice", each.name);
    require_field("vary", static_cast<std::size_t>(each.count) <= kMaxRuns / runs,
                  "wanted at most {} runs", kMaxRuns);
    runs *= static_cast<std::size_t>(each.count);
  }
  return runs;
}

/// Runs of a sweep; absent ones ran in another process, or did not start.
using SweptRuns = std::vector<std::optional<SceneResult>>;

/// Reads the scene of a sweep and counts its runs, whose numbers are checked before any work.
RequestedScene read_sweep(const SceneRequest& request, SceneSweepResult& sweep) {
  RequestedScene read = open_requested_scene(request);
  sweep.name = read.spec.name;
  sweep.request = request;
  sweep.files = read.open.files;
  sweep.outcome.asked = count_runs(request.vary);
  for (std::size_t i = 0; i < sweep.outcome.asked; ++i) {
    BuiltScene trial = read.open.built;
    for (const auto& [name, value] : numbers_of(request.vary, i)) set_number(trial, name, value);
  }
  return read;
}

/// Simulates the runs of this process, which are every size-th one. @param all  runs of the sweep
SweptRuns simulate_own(const RequestedScene& read, std::size_t all, const Communicator& ranks,
                       const Progress& progress) {
  SweptRuns runs(all);
  std::vector<ParallelTask> tasks;
  const auto size = static_cast<std::size_t>(ranks.size());
  for (auto i = static_cast<std::size_t>(ranks.rank()); i < all; i += size)
    tasks.push_back({1, [&, i](const Progress& own) {
                       runs[i] = simulated(read, numbers_of(read.request.vary, i), own);
                     }});
  run_tasks(std::move(tasks), progress);
  return runs;
}

/// Puts the runs of all processes together on the first. Only motions are sent: each process has
/// read the scene, and measures are made again.
void gather_runs(const RequestedScene& read, const Communicator& ranks, SweptRuns& runs) {
  const auto each_run = [&](const auto& work) {
    collective_call(ranks, [&] { parallel_for(runs.size(), work); });
  };
  // Processes other than the first pack the motions that they have; empty bytes are no motion.
  std::vector<std::string> packed(runs.size());
  each_run([&](std::size_t i) {
    if (ranks.rank() > 0 && runs[i]) packed[i] = bytes_of(runs[i]->run);
  });
  // The first one keeps what the owner of each run has sent.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t owner = i % static_cast<std::size_t>(ranks.size());
    std::vector<std::string> sent = internal::all_gather_bytes(ranks, packed[i]);
    packed[i] = ranks.rank() == 0 ? std::move(sent[owner]) : "";
  }
  each_run([&](std::size_t i) {
    if (!packed[i].empty())
      runs[i] = simulated(read, numbers_of(read.request.vary, i), {}, run_from_bytes(packed[i]));
  });
}

/// Fills in the outcome of a sweep from those of its runs, without duplicate warnings.
void tell_outcome(bool stopped, SceneSweepResult& sweep) {
  Outcome& outcome = sweep.outcome;
  outcome.part = "run";
  outcome.done = sweep.runs.size();
  for (const SceneResult& run : sweep.runs) {
    if (run.outcome.status == Status::kStalled) outcome.status = Status::kStalled;
    append_new(outcome.warnings, run.outcome.warnings);
  }
  if (stopped) outcome.status = Status::kStopped;
}

/// Sweeps a scene on all processes together; an exception on one process is thrown on all of them.
SceneSweepResult sweep_together(const SceneRequest& request, const Progress& progress,
                                const Communicator& ranks) {
  RequestedScene read;
  SceneSweepResult sweep;
  SweptRuns runs;
  collective_call(ranks, [&] { read = read_sweep(request, sweep); });
  collective_call(ranks, [&] { runs = simulate_own(read, sweep.outcome.asked, ranks, progress); });
  if (ranks.size() > 1) gather_runs(read, ranks, runs);
  for (std::optional<SceneResult>& run : runs)
    if (run) sweep.runs.push_back(std::move(*run));
  tell_outcome(progress.stop(), sweep);
  return sweep;
}

}  // namespace

bool has_contact_problems(const SceneResult& scene) {
  const SteppingMethod method = scene.built->options.method;
  return method == SteppingMethod::kEvents || method == SteppingMethod::kTimeStepping;
}

SceneResult simulate_scene(const SceneRequest& request, const Progress& progress) {
  require_field("vary", request.vary.empty(), "wanted one run, got numbers that vary");
  return simulated(open_requested_scene(request), {}, progress);
}

SceneResult simulate_scene(const SceneSpec& scene, const SceneRequest& request,
                           const Progress& progress) {
  require_field("vary", request.vary.empty(), "wanted one run, got numbers that vary");
  check_scene_spec(scene);
  return simulated(open_requested_scene(scene, request), {}, progress);
}

std::optional<SceneSweepResult> sweep_scene(const SceneRequest& request, const Progress& progress) {
  return result_of_first_rank([&](const Communicator& ranks) {
    // The first process reports the share that is done, not what each run reports.
    Progress told = progress;
    told.report = [&](double fraction, const std::string& /*what*/) {
      if (ranks.rank() == 0) progress(fraction, "");
    };
    return sweep_together(request, told, ranks);
  });
}

}  // namespace thenar
