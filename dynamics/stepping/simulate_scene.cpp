#include "dynamics/stepping/simulate_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/progress_parts.h"
#include "base/thread_seconds.h"
#include "dynamics/stepping/energy_balance.h"
#include "dynamics/stepping/event_stepper.h"
#include "dynamics/stepping/scene_stepper.h"

namespace thenar {
namespace {

/// Returns the instant of the next sample after t [s].
double sample_after(double t, const SceneOptions& options) {
  return options.sample_interval *
         static_cast<double>(std::lround(t / options.sample_interval) + 1);
}

/// Simulates by kEvents to the end, or until the state is not finite or the caller stops.
void run_events(const MovingScene& scene, const SceneOptions& options, const Progress& progress,
                SceneRun& run) {
  EventStepper stepper(scene, options, run.cost);
  double next_sample = 0;
  const auto keep = [&] {
    run.samples.push_back(stepper.sample());
    next_sample = sample_after(stepper.state().t, options);
  };
  // Keep the initial state as first sample, as it was before impacts at the start.
  const SceneState start = stepper.state();
  stepper.resolve_initial_impacts();
  keep();
  SceneSample& first = run.samples.front();
  first.v = start.v;
  first.energy = stepper.energy_at(start);
  first.w = start.w;
  // Step from sample to sample, until the end, a stop or a state that is not finite.
  while (stepper.state().t < options.duration && run.status == SceneStatus::kDone) {
    progress(stepper.state().t / options.duration, "");
    if (progress.stop()) {
      run.status = SceneStatus::kStopped;
      return;
    }
    const bool is_possible = stepper.take_step(std::min(options.duration, next_sample));
    const double t = stepper.state().t;
    const bool finite = is_finite(stepper.state());
    if (finite && (t + 1e-12 >= next_sample || t >= options.duration)) keep();
    if (!is_possible || !finite) run.status = SceneStatus::kNotFinite;
  }
}

/// Simulates by kTimeStepping to the end, or until the state is not finite or the caller stops.
void run_fixed(const MovingScene& scene, const SceneOptions& options, const Progress& progress,
               SceneRun& run) {
  SceneStepper stepper(scene, options);
  double next_sample = 0;
  const auto keep = [&] {
    run.samples.push_back(stepper.sample());
    next_sample = sample_after(stepper.now().state.t, options);
  };
  keep();
  // Take all steps; a sample is the end of the step nearest to its time.
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
    progress(t / options.duration, "");
    if (progress.stop())
      run.status = SceneStatus::kStopped;
    else if (t >= next_sample - 0.5 * stepper.length() || i + 1 == steps)
      keep();
  }
  run.cost = stepper.cost();
}

}  // namespace

void check_scene_options(const SceneOptions& options) {
  require(options.duration > 0 && std::isfinite(options.duration), "wanted seconds above 0, got {}",
          options.duration);
  for (const auto& [name, value] : {std::pair{"sample", options.sample_interval},
                                    {"step", options.step_length},
                                    {"longest step", options.max_step},
                                    {"shortest step", options.min_step},
                                    {"tolerance", options.tolerance},
                                    {"touch", options.touch}})
    require(value > 0, "wanted a {} above 0, got {}", name, value);
  require(options.recovery >= 0, "wanted a recovery of 0 or more, got {}", options.recovery);
  require(options.columns >= 2 && options.columns <= Extrapolation::kMaxColumns,
          "wanted 2 to {} columns, got {}", Extrapolation::kMaxColumns, options.columns);
}

SceneRun simulate_scene(const MovingScene& scene, const SceneOptions& options,
                        const Progress& progress) {
  check_scene_options(options);
  require(
      options.method == SteppingMethod::kEvents || options.method == SteppingMethod::kTimeStepping,
      "wanted events or time-stepping, got {}", name_in(kSteppingMethodNames, options.method));
  // Run the method; a stop within a step is thrown.
  const double start = thread_seconds();
  SceneRun run;
  try {
    if (options.method == SteppingMethod::kEvents)
      run_events(scene, options, progress, run);
    else
      run_fixed(scene, options, progress, run);
  } catch (const Stopped&) {
    run.status = SceneStatus::kStopped;  // the unfinished step is discarded
  }
  // Set the status: unsolved contact problems, then an energy error.
  run.cost.cpu_seconds = thread_seconds() - start;
  if (run.status == SceneStatus::kDone && run.cost.unsolved > 0)
    run.status = SceneStatus::kUnsolved;
  const bool is_whole = run.status == SceneStatus::kDone || run.status == SceneStatus::kUnsolved;
  if (is_whole && !worst_balance(run.samples).holds()) run.status = SceneStatus::kUnbalanced;
  return run;
}

}  // namespace thenar
