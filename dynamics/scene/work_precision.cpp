#include "dynamics/scene/work_precision.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar {
namespace {

/// Runs a scene several times and keeps the shortest time.
WorkPoint measure_point(const MovingScene& scene, const SceneOptions& options, double setting,
                        int repeats, const std::function<double(const SceneSample&)>& error) {
  WorkPoint point;
  point.method = options.method;
  point.setting = setting;
  point.cpu_seconds = kInfinity;
  // All runs give the same result.
  for (int i = 0; i < repeats; ++i) {
    const SceneRun run = simulate_scene(scene, options);
    point.cpu_seconds = std::min(point.cpu_seconds, run.cost.cpu_seconds);
    point.error = error(run.samples.back());
    point.steps = run.cost.steps;
    point.status = run.status;
  }
  return point;
}

}  // namespace

std::vector<WorkPoint> work_precision(const MovingScene& scene, SceneOptions options,
                                      const WorkSettings& settings,
                                      const std::function<double(const SceneSample&)>& error) {
  require(settings.repeats >= 1, "wanted at least one run, got {}", settings.repeats);
  options.sample_interval = options.duration;
  std::vector<WorkPoint> points;
  // Vary the tolerance of events, then the step length of time stepping.
  options.method = SteppingMethod::kEvents;
  for (const double tolerance : settings.tolerances) {
    options.tolerance = tolerance;
    points.push_back(measure_point(scene, options, tolerance, settings.repeats, error));
  }
  options.method = SteppingMethod::kTimeStepping;
  for (const double step : settings.steps) {
    options.step_length = step;
    points.push_back(measure_point(scene, options, step, settings.repeats, error));
  }
  return points;
}

double rolled_angle(double start, double seconds, double distance, double gravity) {
  require(start > 0 && start < kPi, "wanted a start between 0 and pi rad, got {}", start);
  require(seconds >= 0 && distance > 0 && gravity > 0,
          "wanted a time from 0 s on, a distance and a gravity above 0, got {} s, {} m, {} m/s^2",
          seconds, distance, gravity);
  // Elliptic integral F(psi), which decreases linearly in time.
  const double modulus = std::cos(0.5 * start);
  const double integral =
      std::comp_ellint_1(modulus) - std::sqrt(5 * gravity / (7 * distance)) * seconds;
  require(integral >= 0, "the ball is at the bottom before {} s", seconds);
  // Invert F, which increases with psi, by bisection to machine precision.
  double low = 0, high = 0.5 * kPi;
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (std::ellint_1(modulus, middle) < integral ? low : high) = middle;
  return 2 * std::acos(modulus * std::sin(high));
}

}  // namespace thenar
