#include "live/motion_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/stepping/scene_stepper.h"

namespace thenar {
namespace {

constexpr double kMostParts = 256;  // of a step: what moves too fast for more is let through

/// Bounds the time that one step takes, however fast things move.
void bound_steps(SceneOptions& options) {
  options.shortest = std::max(options.shortest, options.step / kMostParts);
}

/// Makes every step as long as was asked for, to the last digits, though the scene's time may be no
/// whole number of such steps.
void step_by(double step, SceneOptions& options) {
  options.step = step;
  const double adjusted = options.seconds / static_cast<double>(fixed_steps(options));
  if (std::abs(adjusted - step) > 1e-12 * step) options.seconds = step;
}

bool has_pads_of_elements(const SceneSpec& spec, const SceneRequest& request) {
  return std::any_of(spec.pads.begin(), spec.pads.end(), [&](const ScenePadSpec& pad) {
    return (request.pads.empty() ? pad.rung : request.pads) == "elements";
  });
}

}  // namespace

MotionSource scene_motion(const SceneRequest& request) {
  // Read the scene as the command does, then replace its method by steps that keep pace with the
  // clock.
  RequestedScene read = open_requested_scene(request);
  MotionSource out;
  out.name = read.spec.name;
  out.camera = read.spec.camera;
  out.warnings = read.open.built.warnings;
  SceneOptions& options = read.open.built.options;
  out.duration = options.seconds;
  if (options.method != SteppingMethod::kTimeStepping)
    out.warnings.push_back(fmt::format(
        "the scene asks for '{}': live it takes steps of {:g} ms, in which nothing bounces",
        name_in(kSteppingMethodNames, options.method), 1e3 * options.step));
  if (has_pads_of_elements(read.spec, request))
    out.warnings.emplace_back(
        "pads of finite elements: where they touch, single steps take tenths of a second; other "
        "rungs of pads are faster");
  options.method = SteppingMethod::kTimeStepping;
  if (request.step) step_by(*request.step, options);
  bound_steps(options);
  out.built = std::make_shared<const BuiltScene>(std::move(read.open.built));
  return out;
}

MotionSource world_motion(const WorldSpec& world, const std::string& data, WorldDrives drives,
                          std::optional<double> step) {
  // A world has neither a duration nor a method; steps are bounded all the same.
  BuiltScene built = build_world_scene(world, data, drives);
  if (step) step_by(*step, built.options);
  bound_steps(built.options);
  MotionSource out;
  out.name = world.name;
  out.camera = world.camera;
  out.warnings = built.warnings;
  out.built = std::make_shared<const BuiltScene>(std::move(built));
  return out;
}

}  // namespace thenar
