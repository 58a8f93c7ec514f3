#include "grasp/compare/grasp_loads.h"

#include <algorithm>

#include "grasp/quality/hold_force.h"
#include "grasp/quality/task_wrenches.h"

namespace thenar {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

/// Both ways along axes `first` .. `last` of a wrench: forces 0..2, torques 3..5.
std::vector<Wrench> both_ways(int first, int last, double size) {
  std::vector<Wrench> loads;
  for (int axis = first; axis <= last; ++axis)
    for (const double sign : {-1.0, 1.0}) loads.emplace_back(sign * size * Wrench::Unit(axis));
  return loads;
}

std::vector<Wrench> loads_of(GraspTask task, double weight, double scale) {
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

}  // namespace

GraspLoads grasp_loads(const Hand& hand, const BestGrasp& grasp, const SceneBody& object,
                       double mass, const std::vector<GraspTask>& tasks) {
  std::vector<Contact> contacts;
  for (const HandContact& contact : grasp.contacts) contacts.push_back(contact.contact);
  const WrenchSet set = wrench_set(contacts, object.com, object.reach);
  GraspLoads loads;
  const ForceSet friction = free_forces(set);
  for (const Wrench& load : both_ways(0, 2, kGravity * mass))
    loads.hold = std::max(loads.hold, smallest_hold(friction, load, Squeeze::kSum).squeeze);

  const Eigen::MatrixXd T =
      torque_map(hand, grasp.q, grasp.contacts, grasp.X_WH.inverse() * object.X_WB);
  const ForceSet forces = hand_forces(set, T, hand.actuation(grasp.q));
  for (const GraspTask task : tasks) {
    const std::vector<Wrench> list = loads_of(task, kGravity * mass, object.reach);
    if (list.empty()) continue;
    const TaskMargin margin = margin_of_loads(forces, list);
    loads.margin[name_of(task)] = margin.status == ConeStatus::kInfeasible ? 0 : margin.lower;
  }
  return loads;
}

}  // namespace thenar
