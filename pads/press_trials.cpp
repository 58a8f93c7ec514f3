#include "pads/press_trials.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/units.h"
#include "geometry/primitives.h"
#include "pads/laws/soft_patch.h"
#include "pads/skin_gap.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// What the elements say of a press.
MeasuredPress measured(PadPress& press, const PadPressResult& result, const PressTrial& trial) {
  MeasuredPress out;
  out.trial = trial.name;
  out.object = trial.object.shape;
  out.X_PO = press.state().X_PO;
  const PressureMoments moments = pressure_moments(places_of(press.surface(), press.state().x),
                                                   press.state().normal, trial.along);
  out.force = trial.along.dot(result.push.force);
  out.area = result.area;
  out.aspect = moments.aspect;
  out.arm = moments.arm;
  out.force_error = result.force_error;
  // What sticking adds; what does not go along the press goes across it.
  const Eigen::Matrix3d K = (press.stiffness(1) - press.stiffness(0)).bottomRightCorner<3, 3>();
  out.shear = 0.5 * (K.trace() - trial.along.dot(K * trial.along));
  return out;
}

/// A pose whose z axis is `z`, at a distance from the origin against `along`.
Pose<double> posed(const Vector3d& z, const Vector3d& along, double distance) {
  Pose<double> X;
  const Tangents t = tangents(z);
  X.R << t.e1, t.e2, z;
  X.p = -distance * along;
  return X;
}

}  // namespace

LawTrials standard_trials(const PadShape& shape, const std::vector<double>& depths) {
  require(!depths.empty() && depths.front() > 0 && std::isfinite(depths.back()) &&
              std::is_sorted(depths.begin(), depths.end()),
          "presses need depths above 0 that rise");
  // Depths between those of the fit.
  std::vector<double> between;
  for (std::size_t i = 0; i < depths.size(); ++i)
    between.push_back(0.5 * (depths[i] + (i > 0 ? depths[i - 1] : 0)));
  const double far = 1e-3 + std::max({shape.length, shape.width, 2 * shape.height}) / 2;
  const auto plane = [&](double angle, const std::vector<double>& to) {
    const Vector3d along(-std::sin(angle), 0, -std::cos(angle));
    return PressTrial{fmt::format("plane at {:.0f} degrees", degrees(angle)),
                      {build_box({0.2, 0.2, 0.2}), 0},
                      posed(-along, along, far + 0.1),
                      along,
                      to};
  };
  const auto ball = [&](double radius, const std::vector<double>& to) {
    return PressTrial{fmt::format("ball of {:g} mm", radius / kMm),
                      {build_sphere(radius), 0},
                      posed({0, 0, 1}, {0, 0, -1}, far + radius),
                      {0, 0, -1},
                      to};
  };
  const auto cylinder = [&](const Vector3d& axis, const std::string& way,
                            const std::vector<double>& to) {
    constexpr double kRadius = 8e-3;
    return PressTrial{"cylinder of 8 mm " + way,
                      {build_cylinder(kRadius, 0.2), 0},
                      posed(axis, {0, 0, -1}, far + kRadius),
                      {0, 0, -1},
                      to};
  };
  return {
      {plane(0, depths), plane(30 * kDegree, depths), ball(5e-3, depths), ball(20e-3, depths),
       cylinder({0, 1, 0}, "across", depths)},
      {plane(15 * kDegree, between), ball(10e-3, between), cylinder({1, 0, 0}, "along", between)}};
}

MeasuredPresses measure_presses(const PadModel& model, const std::vector<PressTrial>& trials,
                                const PadPressOptions& options) {
  const std::shared_ptr<const Shape> skin = skin_solid(model.shape);
  MeasuredPresses out;
  for (const PressTrial& trial : trials) {
    require(trial.object.shape != nullptr, "the trial '{}' has no object", trial.name);
    PadPress press(model, trial.object, trial.X_PO, options);
    (void)press.touch(trial.along);
    PressGoal goal;
    const Vector3d touch = press.state().X_PO.p;
    for (const double depth : trial.depths) {
      goal.X_PO = press.state().X_PO;
      goal.X_PO.p = touch + depth * trial.along;
      const PadPressResult result = press.step(goal);
      if (result.solved.status != Status::kSolved) {
        out.failures.push_back(
            fmt::format("{}, {:g} mm: {}", trial.name, depth / kMm, result.solved.message));
        break;
      }
      MeasuredPress found = measured(press, result, trial);
      const DeepestSkin deepest =
          deepest_skin(PadChart(model.shape), *trial.object.shape, found.X_PO);
      found.depth = deepest.overlap;
      found.gap = skin_gap(*skin, *trial.object.shape, found.X_PO, deepest.place);
      out.presses.push_back(std::move(found));
    }
  }
  return out;
}

}  // namespace thenar
