#include "grasp/compare/grasp_loads.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"
#include "base/numbers.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/limits/joint_limits.h"

namespace thenar {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s^2]
constexpr double kEpsilonGap = 0.05;    // relative accuracy of hand_epsilon() [1]
// Growth of a load at twice the slack from which it is due to the slack alone [1]
constexpr double kMaxSlackGrowth = 1.5;
constexpr double kPreloadSlack = 1e-6;     // slack of hand_forces() if its programs stall [1]
constexpr double kTorqueRounding = 1e-12;  // torque of unit forces that counts as zero [m]

/// Returns wrenches of both signs along axes `first` .. `last`: forces 0..2, torques 3..5.
std::vector<ScaledWrench> loads_along_axes(int first, int last, double size) {
  std::vector<ScaledWrench> loads;
  for (int axis = first; axis <= last; ++axis)
    for (const double sign : {-1.0, 1.0}) loads.push_back((sign * size) * ScaledWrench::unit(axis));
  return loads;
}

/// Returns the value, with a reason if it is zero, NaN or infinite. @param size  load at value 1
/// [N]
ExplainedLoad explained_load(const HandForceInputs& forces, Status status, double value,
                             const std::vector<ScaledWrench>& loads, double size) {
  // The order matters: a stalled solver or an unknown effort leaves the value unknown.
  if (is_undecided(status)) return {kNaN, "the solver did not converge (numerical trouble)"};
  const std::string unknown = explain_unknown_effort(forces);
  if (!unknown.empty()) return {kNaN, unknown};
  if (status == Status::kInfeasible || value * size < kNegligibleLoad)
    return {0, explain_zero_margin(forces, loads)};
  return {value, std::isinf(value) ? kSupportedByStructure : ""};
}

/// Computes the part of a load that efforts and friction resist without structure [the load's
/// unit]; NaN: unknown.
/// @param whole  load with structure
double active_part(const HandForceInputs& held_by, const ForceSet& forces,
                   const std::vector<ScaledWrench>& loads, double whole) {
  if (whole == 0 || std::isnan(whole) || forces.passive_contacts.empty()) return whole;
  TaskMargin active = margin_of_loads(active_only(forces), loads);
  // If the program stalls, one wall may take the whole preload: try again with slack.
  if (is_undecided(active.status)) {
    const auto margin_with = [&](double slack) {
      return margin_of_loads(
          active_only(hand_forces(held_by.set, held_by.T, held_by.actuation, slack)), loads);
    };
    active = margin_with(kPreloadSlack);
    if (active.status == Status::kSolved)
      if (const TaskMargin more = margin_with(2 * kPreloadSlack);
          more.status == Status::kSolved && more.lower > kMaxSlackGrowth * active.upper)
        return 0;
  }
  if (active.status == Status::kInfeasible) return 0;
  if (active.status != Status::kSolved) return kNaN;
  const double part = std::min(active.lower, whole);
  return part * loads.front().norm() < kNegligibleLoad ? 0 : part;
}

}  // namespace

std::vector<ScaledWrench> task_loads(GraspTask task, double weight, double scale) {
  switch (task) {
    case GraspTask::kHoldWeight:
      return loads_along_axes(0, 2, weight);
    case GraspTask::kPull:
      return loads_along_axes(2, 2, 1.0);
    case GraspTask::kTurn:
      return loads_along_axes(5, 5, 1.0 / scale);
    case GraspTask::kForceClosure:
      break;
  }
  return {};
}

std::optional<ScaledWrench> unsupported_load(const ForceSet& forces) {
  for (const ScaledWrench& load : loads_along_axes(0, 5, 1)) {
    const WrenchSupport margin = load_margin(forces, load);
    if (margin.status == Status::kInfeasible ||
        (margin.status == Status::kSolved && margin.value < kNegligibleLoad))
      return load;
  }
  return {};
}

HandForceInputs hand_force_inputs(const HeldObject& held, const GraspBody& object) {
  return {held.hand.layout(),
          wrench_set(contacts_without_hand(held.contacts), object.com, object.torque_scale),
          torque_map(held.hand, held.q, held.contacts, held.X_HO),
          actuation_with_joint_limits(held.hand, held.q)};
}

GraspLoads grasp_loads(const HeldObject& held, const GraspBody& object, double mass,
                       const std::vector<GraspTask>& tasks) {
  const HandForceInputs held_by = hand_force_inputs(held, object);
  GraspLoads loads;
  // Grasp force that holds the weight by friction alone, along every axis.
  const ForceSet friction = free_forces(held_by.set);
  for (const ScaledWrench& load : loads_along_axes(0, 2, kEarthGravity * mass))
    loads.min_grasp_force =
        std::max(loads.min_grasp_force,
                 minimum_grasp_force(friction, load, GraspForceObjective::kSum).objective);
  const ScaledWrench standing{-kEarthGravity * mass * object.X_WB.R.transpose().col(2), {0, 0, 0}};
  loads.standing_grasp_force =
      minimum_grasp_force(friction, standing, GraspForceObjective::kSum).objective;

  // Margins of the tasks within the actuation of the hand.
  const ForceSet forces = hand_forces(held_by.set, held_by.T, held_by.actuation);
  for (const GraspTask task : tasks) {
    const std::vector<ScaledWrench> list =
        task_loads(task, kEarthGravity * mass, object.torque_scale);
    if (list.empty()) continue;
    const TaskMargin margin = margin_of_loads(forces, list);
    const ExplainedLoad result =
        explained_load(held_by, margin.status, margin.lower, list, list.front().norm());
    const double active = active_part(held_by, forces, list, result.value);
    loads.with_structure[name_of(task)] = result.value;
    loads.margin[name_of(task)] = active;
    const bool is_resisted_by_structure = result.message.empty() && active == 0;
    if (const std::string reason = is_resisted_by_structure ? kBorneByStructure : result.message;
        !reason.empty())
      loads.reasons[name_of(task)] = reason;
  }
  return loads;
}

ExplainedLoad hand_epsilon(const HeldObject& held, const GraspBody& object) {
  const HandForceInputs held_by = hand_force_inputs(held, object);
  // Unknown efforts and unsupported loads need no search.
  const std::string unknown = explain_unknown_effort(held_by);
  if (!unknown.empty()) return {kNaN, unknown};
  BallOptions options;
  options.gap = kEpsilonGap;
  const ForceSet forces = hand_forces(held_by.set, held_by.T, held_by.actuation);
  if (const std::optional<ScaledWrench> load = unsupported_load(forces))
    return {0, explain_zero_margin(held_by, {*load})};
  // A stalled search still has a certified lower bound.
  const InscribedBall ball = inscribed_ball(forces, options);
  const bool known = is_undecided(ball.status) && ball.lower > kNegligibleLoad;  // less accurate
  return explained_load(held_by, known ? Status::kSolved : ball.status, ball.lower,
                        {ball.worst_load}, 1);
}

namespace {

using Eigen::Index;

bool carries_force(const HandForceInputs& forces, Index coordinate) {
  return forces.T.cols() > 0 && forces.T.row(coordinate).cwiseAbs().maxCoeff() > kTorqueRounding;
}

/// Returns the actuation with an additional motor of any strength at each of some joints.
Actuation with_motors(Actuation actuation, const std::vector<int>& joints) {
  for (const int joint : joints) {
    append_column(actuation.B, Eigen::VectorXd::Unit(actuation.tau_0.size(), joint));
    append_entry(actuation.lower, -kInfinity);
    append_entry(actuation.upper, kInfinity);
  }
  return actuation;
}

/// Returns whether the forces resist all loads.
bool holds(const ForceSet& forces, const std::vector<ScaledWrench>& loads) {
  const TaskMargin margin = margin_of_loads(forces, loads);
  // The smallest load of the list gives a limit in newtons.
  double size = kInfinity;
  for (const ScaledWrench& load : loads) size = std::min(size, load.norm());
  return margin.status == Status::kSolved && margin.lower * size >= kNegligibleLoad;
}

/// Returns whether the loads are resisted with unlimited motors at some joints.
bool holds_driven(const HandForceInputs& forces, const std::vector<ScaledWrench>& loads,
                  const std::vector<int>& joints) {
  return holds(hand_forces(forces.set, forces.T, with_motors(forces.actuation, joints)), loads);
}

/// Returns a minimal set of joints that must be driven together: none of them can be left out.
std::vector<int> minimal_motors(const HandForceInputs& forces,
                                const std::vector<ScaledWrench>& loads, std::vector<int> joints) {
  // Try without each joint, from the fingertips inwards.
  for (std::size_t i = joints.size(); i-- > 0;) {
    std::vector<int> fewer = joints;
    fewer.erase(fewer.begin() + i);
    if (holds_driven(forces, loads, fewer)) joints.swap(fewer);
  }
  return joints;
}

}  // namespace

std::string explain_unknown_effort(const HandForceInputs& forces) {
  const Actuation& a = forces.actuation;
  for (Index k = 0; k < a.B.cols(); ++k) {
    // Unlimited actuators count if they move a joint that carries contact force and is not locked.
    if (std::isfinite(a.lower(k)) && std::isfinite(a.upper(k))) continue;
    for (Index j = 0; j < a.B.rows(); ++j)
      if (a.B(j, k) != 0 && carries_force(forces, j) && !is_locked(a.reactions, j))
        return fmt::format("the effort of '{}' is unknown", forces.layout.actuators[k]);
  }
  return "";
}

std::string explain_zero_margin(const HandForceInputs& forces,
                                const std::vector<ScaledWrench>& loads) {
  // Try friction alone, then unlimited motors at all joints that carry contact force.
  if (!holds(free_forces(forces.set), loads)) return "friction at the contacts cannot resist it";
  std::vector<int> joints;
  for (Index j = 0; j < forces.T.rows(); ++j)
    if (carries_force(forces, j)) joints.push_back(static_cast<int>(j));
  if (!holds_driven(forces, loads, joints)) return "no actuator presses these contacts";
  // Name a minimal set of joints whose motors are missing.
  const auto quoted = [&](int j) { return fmt::format("'{}'", forces.layout.coordinates[j]); };
  return fmt::format("needs more motor torque at {}",
                     fmt::join(transformed(minimal_motors(forces, loads, joints), quoted), ", "));
}

}  // namespace thenar
