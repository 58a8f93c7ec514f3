#include "tests/pads/stability_trials.h"

#include <cmath>

#include <fmt/format.h>

#include "geometry/mesh_distance.h"
#include "geometry/primitives.h"
#include "geometry/tessellate.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kDeepest = 0.6;       // of the thickness of the pad in its middle [1]
constexpr double kOff = 2e-3;          // above the first touch, where a trial begins and ends [m]
constexpr double kThickness = 5.5e-3;  // of the default pad in its middle [m]

bool all_finite(const PressState& state) {
  return state.x.allFinite() && state.X_PO.p.allFinite() && state.X_PO.R.allFinite() &&
         state.normal_force.allFinite() && state.friction_force.allFinite() &&
         state.anchor.allFinite() && state.push.force.allFinite() && state.push.moment.allFinite();
}

/// Push of the object against what the bone holds, over the sum of all contact forces.
double unbalanced(const PadPress& press) {
  const PressState& state = press.state();
  const TissueBody& body = press.body();
  const Matrix3Xd u = body.node_displacements(state.x, {}), f = body.reactions(u, 0, {});
  Wrench sum = state.push;
  for (const int node : body.nodes())
    if (!body.is_hanging(node) && body.free_index(node) < 0)
      sum += wrench_of_force(body.rest_position(node) + u.col(node), f.col(node));
  // Arms of moments are some 10 mm long.
  const double scale = state.normal_force.sum() + state.friction_force.colwise().norm().sum();
  return (sum.force.norm() + sum.moment.norm() / 0.01) / std::max(scale, 1e-3);
}

/// A trial on its way.
class TrialRun {
 public:
  TrialRun(const StabilityTrial& trial, PadPress& press, PressReport& report)
      : trial_(trial), press_(press), report_(report) {}

  /// Moves the object by `way` in equal steps. @return whether all were solved
  bool move(const Vector3d& way, int steps) {
    PressGoal goal;
    goal.time = trial_.step_time;
    const Pose<double> start = press_.state().X_PO;
    for (int k = 1; k <= steps; ++k) {
      goal.X_PO = start;
      goal.X_PO.p += way * (k / (1.0 * steps));
      if (!step(goal)) return false;
    }
    return true;
  }

 private:
  bool step(const PressGoal& goal) {
    const Pose<double> from = press_.state().X_PO;
    const Vector3d push = press_.state().push.force;
    const Matrix3Xd anchor = press_.state().anchor;
    const PadPressResult result = press_.step(goal);
    const PressState& state = press_.state();
    report_.finite = report_.finite && all_finite(state) && std::isfinite(result.area) &&
                     std::isfinite(result.penetration) && std::isfinite(result.force_error) &&
                     std::isfinite(result.stick) && std::isfinite(result.solved.residual) &&
                     std::isfinite(result.solved.gap);
    report_.iterations = result.iterations;
    report_.elements = std::max(report_.elements, result.elements);
    if (result.solved.status != Status::kSolved) {
      ++report_.failed;
      if (report_.message.empty()) report_.message = result.solved.message;
      report_.told = report_.told && !result.solved.message.empty();
      report_.intact = report_.intact && state.X_PO.p == from.p && state.push.force == push;
      return false;
    }
    ++report_.solved;
    // What must hold at a solution.
    if (trial_.model.tissues[0].relaxation.empty())
      report_.unbalanced = std::max(report_.unbalanced, unbalanced(press_));
    for (Eigen::Index k = 0; k < state.normal_force.size(); ++k) {
      const double bound = trial_.object.friction * state.normal_force[k];
      const double shear = state.friction_force.col(k).norm();
      report_.pulls = std::min(report_.pulls, state.normal_force[k]);
      if (shear > 0)
        report_.beyond_cone = std::max(report_.beyond_cone, bound > 0 ? shear / bound - 1 : 1e300);
    }
    // In parts of a step that was cut, slips may turn.
    if (result.cuts == 0 && anchor.cols() == state.anchor.cols())
      see_friction(anchor, (state.X_PO.p - from.p).norm());
    report_.depth = std::max(report_.depth, result.penetration);
    report_.push = std::max(report_.push, result.push.force.norm());
    // Trapezoids: exact to rounding on a way there and back without friction.
    report_.work += 0.5 * (push + state.push.force).dot(state.X_PO.p - from.p);
    report_.most_work = std::max(report_.most_work, report_.work);
    return true;
  }

  /// Whether friction did work with the slip since the last step.
  /// @param anchor  where nodes were then, object's frame (3, nodes)
  /// @param way     of the object since then [m]
  void see_friction(const Matrix3Xd& anchor, double way) {
    const PressState& state = press_.state();
    const Matrix3Xd places = deformed_positions(press_.surface(), state.x);
    double done = 0, size = 0;
    for (Eigen::Index k = 0; k < anchor.cols(); ++k) {
      const Vector3d slip = places.col(k) - state.X_PO * Vector3d(anchor.col(k));
      done += state.friction_force.col(k).dot(slip);
      size += state.friction_force.col(k).norm() * way;
    }
    if (size > 0) report_.drives = std::max(report_.drives, done / size);
  }

  const StabilityTrial& trial_;
  PadPress& press_;
  PressReport& report_;
};

}  // namespace

PressReport run_trial(const StabilityTrial& trial) {
  PressReport report;
  PadPressOptions options;
  options.force_error = 0.05;
  options.max_elements = trial.max_elements;
  options.step.max_iterations = 30;  // a step that wanders is cut early
  // From far away towards the point that it is to meet.
  Pose<double> X{trial.R, trial.above - 0.1 * trial.along + Vector3d(0, 0, 8e-3)};
  PadPress press(trial.model, trial.object, X, options);
  try {
    (void)press.touch(trial.along);
  } catch (const std::exception& error) {
    report.touches = false;
    report.message = error.what();
    return report;
  }
  // From a little above the touch, and back to there.
  const Vector3d off = -kOff * trial.along, in = trial.depth * trial.along;
  TrialRun run(trial, press, report);
  bool good = run.move(off, 1) && run.move(-off, 1) && run.move(in, trial.steps) &&
              (trial.sideways.isZero(0) || run.move(trial.sideways, trial.steps_sideways));
  if (good && trial.back) {
    good = (trial.sideways.isZero(0) || run.move(-trial.sideways, trial.steps_sideways)) &&
           run.move(-in, trial.steps) && run.move(off, 1);
    if (good) report.left = press.state().x.lpNorm<Eigen::Infinity>();
  }
  return report;
}

PadModel trial_pad(double poisson_ratio) {
  PadModel model;
  Tissue tissue;
  tissue.shear_modulus = 12e3;
  tissue.poisson_ratio = poisson_ratio;
  model.tissues = {tissue};
  return model;
}

const std::vector<std::string>& trial_object_names() {
  static const std::vector<std::string> names{"wall",   "ball",  "pearl", "rod", "edge",
                                              "corner", "blade", "pin",   "mesh"};
  return names;
}

TrialObject trial_object(const std::string& name) {
  const Matrix3d straight = Matrix3d::Identity();
  constexpr double kQuarter = 1.5707963267948966;
  if (name == "wall") return {build_box({0.1, 0.1, 0.1}), straight};
  if (name == "ball") return {build_sphere(8e-3), straight};
  if (name == "pearl") return {build_sphere(0.8e-3), straight};
  if (name == "rod")
    return {build_cylinder(3e-3, 0.06), rotation_about<double>({1, 0, 0}, kQuarter)};
  if (name == "edge")
    return {build_box({0.02, 0.06, 0.02}), rotation_about<double>({0, 1, 0}, kQuarter / 2)};
  if (name == "corner")
    return {build_box({0.02, 0.02, 0.02}),
            rotation_about<double>({1, 0, 0}, std::atan(std::sqrt(0.5))) *
                rotation_about<double>({0, 1, 0}, kQuarter / 2)};
  if (name == "blade") return {build_box({0.5e-3, 0.06, 0.02}), straight};
  if (name == "pin") return {build_tapered_capsule(0.3e-3, 0.3e-3, 0.02), straight};
  // A mesh with edges of its own.
  return {build_mesh_distance(tessellate(*build_sphere(8e-3), 0.4e-3)), straight};
}

StabilityTrial random_trial(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto pick = [&](int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random);
  };
  StabilityTrial trial;
  const std::vector<double> ratios{0.45, 0.49, 0.499, 0.49999};
  const double nu = ratios[static_cast<std::size_t>(pick(4))];
  trial.model = trial_pad(nu);
  trial.model.element =
      pick(4) == 0 ? HexElement::kCentroidDilatation : HexElement::kMeanDilatation;
  // Skin a hundred times as stiff as the pulp, or none.
  const bool skinned = pick(4) == 0;
  if (skinned) {
    trial.model.shape.layers = {{0.4e-3}, {1.1e-3}};
    trial.model.tissues = {trial.model.tissues[0], trial.model.tissues[0], trial.model.tissues[0]};
    trial.model.tissues[0].shear_modulus = 4e3;
    trial.model.tissues[1].shear_modulus = 40e3;
    trial.model.tissues[2].shear_modulus = 400e3;
  }
  const std::string name = trial_object_names()[static_cast<std::size_t>(pick(9))];
  const TrialObject object = trial_object(name);
  const std::vector<double> frictions{0, 0, 0.3, 0.7, 1.5};
  trial.object = {object.shape, frictions[static_cast<std::size_t>(pick(5))]};
  // A direction within 45 degrees of the palm's, the object turned with it or not.
  const double tilt = uniform(0, 0.78), turn = uniform(0, 6.28);
  const Matrix3d lean =
      rotation_about<double>({std::cos(turn), std::sin(turn), 0}, pick(2) == 0 ? 0.0 : tilt);
  trial.along = lean * Vector3d(0, 0, -1);
  trial.R = (pick(2) == 0 ? lean : Matrix3d(Matrix3d::Identity())) * object.R;
  trial.above = {uniform(-4e-3, 4e-3), uniform(-2.5e-3, 2.5e-3), 0};
  trial.depth = uniform(0.05, kDeepest) * kThickness;
  trial.steps = std::vector<int>{1, 1, 4, 10}[static_cast<std::size_t>(pick(4))];
  if (pick(2) == 0) {
    trial.sideways =
        rotation_about<double>({0, 0, 1}, uniform(0, 6.28)) * Vector3d(uniform(0.2e-3, 5e-3), 0, 0);
    trial.steps_sideways = std::vector<int>{1, 5, 10}[static_cast<std::size_t>(pick(3))];
  }
  trial.back = pick(2) == 0;
  if (pick(6) == 0) trial.max_elements = 400;
  trial.name = fmt::format(
      "{} {} nu {} {} mu {} tilt {:.2f} at ({:.1f}, {:.1f}) depth {:.2f} mm in {}, aside {:.1f} mm "
      "in {}{}{}",
      name, name_of(trial.model.element), nu, skinned ? "skinned" : "plain", trial.object.friction,
      tilt, trial.above[0] * 1e3, trial.above[1] * 1e3, trial.depth * 1e3, trial.steps,
      trial.sideways.norm() * 1e3, trial.steps_sideways, trial.back ? ", back" : "",
      trial.max_elements > 1 ? ", refined" : "");
  return trial;
}

}  // namespace thenar
