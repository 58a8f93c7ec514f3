#include "live/motion_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/lists.h"
#include "dynamics/stepping/scene_stepper.h"

namespace thenar {
namespace {

constexpr double kMaxStepParts = 256;  // largest number of parts that a step is divided into

/// Bounds the computing time of a step; bodies that need more parts may pass through each other.
void bound_step_division(SceneOptions& options) {
  options.min_step = std::max(options.min_step, options.step_length / kMaxStepParts);
}

/// Sets the step size exactly, even if the scene's duration is not a multiple of it.
void set_step_length(double step, SceneOptions& options) {
  // SceneStepper fits the step size to the duration: if that changes it, make the duration one
  // step.
  options.step_length = step;
  const double adjusted = options.duration / static_cast<double>(fixed_steps(options));
  constexpr double kStepTolerance = 1e-12;  // relative difference of equal step sizes [1]
  if (std::abs(adjusted - step) > kStepTolerance * step) options.duration = step;
}

bool has_pads_of_elements(const SceneSpec& spec, const SceneRequest& request) {
  return any_of(spec.pads, [&](const ScenePadSpec& pad) {
    return (request.pads.empty() ? pad.rung : request.pads) == "elements";
  });
}

}  // namespace

MotionSource scene_motion(const SceneRequest& request) {
  // Read the scene as the command does.
  RequestedScene read = open_requested_scene(request);
  MotionSource out;
  out.name = read.spec.name;
  out.camera = read.spec.camera;
  out.warnings = read.open.built.warnings;
  SceneOptions& options = read.open.built.options;
  out.duration = options.duration;
  // Warn about settings that differ in a live motion.
  if (options.method != SteppingMethod::kTimeStepping)
    out.warnings.push_back(fmt::format(
        "the scene asks for '{}': live it takes steps of {:g} ms, in which nothing bounces",
        name_in(kSteppingMethodNames, options.method), 1e3 * options.step_length));
  if (has_pads_of_elements(read.spec, request))
    out.warnings.emplace_back(
        "pads of finite elements: where they touch, single steps take tenths of a second; other "
        "rungs of pads are faster");
  // Use time stepping with the requested step size.
  options.method = SteppingMethod::kTimeStepping;
  if (request.step) set_step_length(*request.step, options);
  bound_step_division(options);
  out.built = std::make_shared<const BuiltScene>(std::move(read.open.built));
  return out;
}

MotionSource world_motion(const WorldSpec& world, const std::string& data, WorldDrives drives,
                          std::optional<double> step) {
  // Build the scene; a world has neither a duration nor a stepping method.
  BuiltScene built = build_world_scene(world, data, drives);
  if (step) set_step_length(*step, built.options);
  bound_step_division(built.options);
  MotionSource out;
  out.name = world.name;
  out.camera = world.camera;
  out.warnings = built.warnings;
  out.built = std::make_shared<const BuiltScene>(std::move(built));
  return out;
}

}  // namespace thenar
