#include "grasp/compare/grasp_loads.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "grasp/quality/hold_force.h"
#include "grasp/quality/stops.h"
#include "grasp/quality/task_wrenches.h"

namespace thenar {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kGap = 0.05;      // of hand_epsilon(), as a part of it [1]

/// Both ways along axes `first` .. `last` of a wrench: forces 0..2, torques 3..5.
std::vector<Wrench> both_ways(int first, int last, double size) {
  std::vector<Wrench> loads;
  for (int axis = first; axis <= last; ++axis)
    for (const double sign : {-1.0, 1.0}) loads.emplace_back(sign * size * Wrench::Unit(axis));
  return loads;
}

/// The value, and where it is zero, NaN or infinite the reason. @param size  of a load at value 1
/// [N]
Limited limited(const HeldForces& forces, ConeStatus status, double value,
                const std::vector<Wrench>& loads, double size) {
  if (status == ConeStatus::kStalled) return {kNaN, "the programme did not converge"};
  const std::string unknown = unknown_effort(forces);
  if (!unknown.empty()) return {kNaN, unknown};
  if (status == ConeStatus::kInfeasible || value * size < kNoLoad)
    return {0, why_nothing_holds(forces, loads)};
  return {value, std::isinf(value) ? kBorneByStructure : ""};
}

}  // namespace

std::vector<Wrench> task_loads(GraspTask task, double weight, double scale) {
  switch (task) {
    case GraspTask::kHoldWeight:
      return both_ways(0, 2, weight);
    case GraspTask::kPull:
      return both_ways(2, 2, 1.0);
    case GraspTask::kTurn:
      return both_ways(5, 5, 1.0 / scale);
    case GraspTask::kForceClosure:
      break;
  }
  return {};
}

Wrench unborne_load(const ForceSet& forces) {
  for (const Wrench& load : both_ways(0, 5, 1)) {
    const Reach reach = largest_load(forces, load);
    if (reach.status == ConeStatus::kSolved && reach.value < kNoLoad) return load;
    if (reach.status == ConeStatus::kInfeasible) return load;
  }
  return Wrench::Zero();
}

HeldForces forces_of(const Held& held, const SceneBody& object) {
  return {held.hand.layout(), wrench_set(plain(held.contacts), object.com, object.reach),
          torque_map(held.hand, held.q, held.contacts, held.X_HO),
          actuation_with_stops(held.hand, held.q)};
}

GraspLoads grasp_loads(const Held& held, const SceneBody& object, double mass,
                       const std::vector<GraspTask>& tasks) {
  const HeldForces held_by = forces_of(held, object);
  GraspLoads loads;
  const ForceSet friction = free_forces(held_by.set);
  for (const Wrench& load : both_ways(0, 2, kGravity * mass))
    loads.hold = std::max(loads.hold, smallest_hold(friction, load, Squeeze::kSum).squeeze);

  const ForceSet forces = hand_forces(held_by.set, held_by.T, held_by.actuation);
  for (const GraspTask task : tasks) {
    const std::vector<Wrench> list = task_loads(task, kGravity * mass, object.reach);
    if (list.empty()) continue;
    const TaskMargin margin = margin_of_loads(forces, list);
    const Limited result = limited(held_by, margin.status, margin.lower, list, list.front().norm());
    loads.margin[name_of(task)] = result.value;
    if (!result.reason.empty()) loads.reasons[name_of(task)] = result.reason;
  }
  return loads;
}

Limited hand_epsilon(const Held& held, const SceneBody& object) {
  const HeldForces held_by = forces_of(held, object);
  const std::string unknown = unknown_effort(held_by);
  if (!unknown.empty()) return {kNaN, unknown};
  BallOptions options;
  options.gap = kGap;
  const ForceSet forces = hand_forces(held_by.set, held_by.T, held_by.actuation);
  const Wrench unborne = unborne_load(forces);
  if (!unborne.isZero(0)) return {0, why_nothing_holds(held_by, {unborne})};
  const InscribedBall ball = inscribed_ball(forces, options);
  const bool known = ball.status == ConeStatus::kStalled && ball.lower > kNoLoad;  // less sharply
  return limited(held_by, known ? ConeStatus::kSolved : ball.status, ball.lower, {ball.worst_load},
                 1);
}

}  // namespace thenar
