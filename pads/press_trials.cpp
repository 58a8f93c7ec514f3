#include "pads/press_trials.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/primitives.h"
#include "pad_laws/soft_patch.h"
#include "pads/pad_press.h"
#include "pads/skin_gap.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Measures force, area, moments of pressure, errors and shear stiffness of a solved press.
MeasuredPress measured(PadPress& press, const PadPressResult& result, const PressTrial& trial) {
  MeasuredPress out;
  out.trial = trial.name;
  out.object = trial.object.shape;
  out.X_PO = press.state().X_PO;
  const PressureMoments moments =
      pressure_moments(deformed_positions(press.surface(), press.state().x),
                       press.state().normal_force, trial.along);
  out.force = trial.along.dot(result.push.force);
  out.area = result.area;
  out.aspect = moments.aspect;
  out.arm = moments.arm;
  out.force_error = result.force_error;
  out.penetration = result.penetration;
  // Compute the tangential stiffness that sticking adds, the mean over two directions.
  const Eigen::Matrix3d K = (press.stiffness(1) - press.stiffness(0)).bottomRightCorner<3, 3>();
  out.shear = 0.5 * (K.trace() - trial.along.dot(K * trial.along));
  return out;
}

/// Returns whether enough nodes touch to form a patch. For a disc under uniform pressure the arm is
/// 0.38 times the root of its area; for a single node it is a rounding error.
bool is_patch(const MeasuredPress& press, Eigen::Index nodes) {
  constexpr Eigen::Index kMinNodes = 4;
  constexpr double kMinArmRatio = 0.1;  // least arm of the pressure over the root of the area [1]
  return press.force > 0 && press.area > 0 && press.depth > 0 && press.shear > 0 &&
         nodes >= kMinNodes && press.arm > kMinArmRatio * std::sqrt(press.area);
}

/// Returns the trial of a frictionless shape whose z axis is `z`, at a distance from the origin
/// opposite to `along`.
PressTrial trial_by(const std::string& name, const std::shared_ptr<const Shape>& shape,
                    const Vector3d& z, const Vector3d& along, double distance,
                    const std::vector<double>& depths) {
  return {name, {shape, 0}, frame_with_z(z, -distance * along), along, depths};
}

/// Presses the pad in one trial, depth by depth.
/// @param report  called with the share that is done [1]
void press_to_depths(const PadModel& model, const PressTrial& trial, const PadPressOptions& options,
                     const std::function<void(double)>& report, MeasuredPresses& out) {
  const std::shared_ptr<const Shape> skin = skin_solid(model.shape);
  PadPress press(model, trial.object, trial.X_PO, options);
  // Move to the first touch, from which depths count.
  (void)press.touch(trial.along);
  PressGoal goal;
  const Vector3d touch = press.state().X_PO.p;
  for (std::size_t i = 0; i < trial.depths.size(); ++i) {
    report(static_cast<double>(i) / static_cast<double>(trial.depths.size()));
    const double depth = trial.depths[i];
    goal.X_PO = press.state().X_PO;
    goal.X_PO.p = touch + depth * trial.along;
    // Press to the depth; a press that fails ends the trial.
    const PadPressResult result = press.step(goal);
    if (result.solved.status == Status::kStopped) {
      out.status = Status::kStopped;
      return;
    }
    if (result.solved.status != Status::kSolved) {
      out.failures.push_back(
          fmt::format("{}, {:g} mm: {}{}", trial.name, depth / kMm, result.solved.message,
                      i + 1 < trial.depths.size() ? "; no deeper one was tried" : ""));
      return;
    }
    // Measure depth and gap of the undeformed surfaces, the arguments of laws.
    MeasuredPress found = measured(press, result, trial);
    const DeepestSkin deepest =
        deepest_skin(PadChart(model.shape), *trial.object.shape, found.X_PO);
    found.depth = deepest.overlap;
    found.gap = skin_gap(*skin, *trial.object.shape, found.X_PO, deepest.place);
    if (is_patch(found, (press.state().normal_force.array() > 0).count()))
      out.presses.push_back(std::move(found));
    else
      out.failures.push_back(fmt::format("{}, {:g} mm: too few nodes touch for it to have a patch",
                                         trial.name, depth / kMm));
  }
}

}  // namespace

std::vector<double> trial_depths(const PadShape& shape) {
  constexpr double kTrialParts = 11, kPerNanometre = 1e9;  // [1], [1/m]
  const double thickness = PadChart(shape).thickness(0, 0);
  std::vector<double> depths;
  for (const double part : {1, 2, 3, 4})
    depths.push_back(std::round(part * thickness / kTrialParts * kPerNanometre) / kPerNanometre);
  return depths;
}

LawTrials standard_trials(const PadShape& shape, const std::vector<double>& depths) {
  require(!depths.empty() && depths.front() > 0 && std::isfinite(depths.back()) &&
              std::is_sorted(depths.begin(), depths.end()),
          "presses need depths above 0 that rise");
  // Set the depths of the check between those of the fit.
  std::vector<double> between;
  for (std::size_t i = 0; i < depths.size(); ++i)
    between.push_back(0.5 * (depths[i] + (i > 0 ? depths[i - 1] : 0)));
  // Start objects outside the reach of the skin.
  const double far = 1e-3 + reach_of(shape);
  const auto plane = [&](double angle, const std::vector<double>& to) {
    const Vector3d along(-std::sin(angle), 0, -std::cos(angle));
    return trial_by(fmt::format("plane at {:.0f} degrees", degrees(angle)),
                    build_box({0.2, 0.2, 0.2}), -along, along, far + 0.1, to);
  };
  const auto ball = [&](double radius, const std::vector<double>& to) {
    return trial_by(fmt::format("ball of {:g} mm", radius / kMm), build_sphere(radius), {0, 0, 1},
                    {0, 0, -1}, far + radius, to);
  };
  const auto cylinder = [&](const Vector3d& axis, const std::string& way,
                            const std::vector<double>& to) {
    constexpr double kRodRadius = 8e-3;  // radius of the cylinder [m]
    return trial_by("cylinder of 8 mm " + way, build_cylinder(kRodRadius, 0.2), axis, {0, 0, -1},
                    far + kRodRadius, to);
  };
  return {
      {plane(0, depths), plane(30 * kDegree, depths), ball(5e-3, depths), ball(20e-3, depths),
       cylinder({0, 1, 0}, "across", depths)},
      {plane(15 * kDegree, between), ball(10e-3, between), cylinder({1, 0, 0}, "along", between)}};
}

MeasuredPresses measure_presses(const PadModel& model, const std::vector<PressTrial>& trials,
                                PadPressOptions options, const Progress& progress) {
  options.step.stop = progress.stop_requested;
  MeasuredPresses out;
  for (std::size_t i = 0; i < trials.size() && out.status != Status::kStopped; ++i) {
    require(trials[i].object.shape != nullptr, "the trial '{}' has no object", trials[i].name);
    const auto share = [&](double part) {
      return (static_cast<double>(i) + part) / static_cast<double>(trials.size());
    };
    press_to_depths(
        model, trials[i], options,
        [&](double part) { progress(share(part), "pressing by " + trials[i].name); }, out);
  }
  return out;
}

}  // namespace thenar
