#include "dynamics/human/joint_stops.h"

#include <utility>

#include "base/error.h"
#include "hand/passive_moment.h"

namespace thenar {

JointStops::JointStops(std::string name, Skeleton skeleton, CoordinateIndices indices,
                       const JointResistance& resistance)
    : name_(std::move(name)),
      limits_(std::move(skeleton)),
      indices_(std::move(indices)),
      resistance_(resistance) {
  const std::size_t joints = limits_.limits.size();
  require(indices_.q.size() == joints && indices_.v.size() == joints,
          "{} joints stand at {} positions and {} speeds", joints, indices_.q.size(),
          indices_.v.size());
  for (CoordinateLimits& limits : limits_.limits) limits.stiffness = 0;
}

bool JointStops::add_action(const ElementInput& at, ElementAction& out) {
  if (at.need == ElementNeed::kStates) return true;
  for (std::size_t i = 0; i < limits_.limits.size(); ++i) {
    // Add stop torque and passive moment, and their stiffness.
    const CoordinateLimits& limits = limits_.limits[i];
    const double angle = at.q[indices_.q[i]];
    const int v = indices_.v[i];
    out.tau[v] += stop_torque(resistance_, limits, angle) + passive_moment(limits, angle);
    if (at.need == ElementNeed::kAll)
      out.stiffness(v, v) -=
          stop_derivative(resistance_, limits, angle) + passive_moment_slope(limits, angle);
  }
  return true;
}

double JointStops::energy(const ElementInput& at) {
  return resistance_energy(limits_, resistance_, at.q(indices_.q));
}

}  // namespace thenar
