#include "grasp/compare/load_reason.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/numbers.h"
#include "grasp/quality/stops.h"

namespace thenar {
namespace {

using Eigen::Index;

bool feels(const HeldForces& forces, Index coordinate) {
  return forces.T.cols() > 0 && forces.T.row(coordinate).cwiseAbs().maxCoeff() > 1e-12;
}

/// The same with a motor of any strength at each of some joints.
Actuation with_motors(Actuation actuation, const std::vector<int>& joints) {
  for (const int joint : joints) {
    const Index old = actuation.B.cols();
    actuation.B.conservativeResize(actuation.tau_0.size(), old + 1);
    actuation.B.col(old) = Eigen::VectorXd::Unit(actuation.tau_0.size(), joint);
    actuation.lower.conservativeResize(old + 1);
    actuation.lower(old) = -kInfinity;
    actuation.upper.conservativeResize(old + 1);
    actuation.upper(old) = kInfinity;
  }
  return actuation;
}

bool holds(const ForceSet& forces, const std::vector<Wrench>& loads) {
  const TaskMargin margin = margin_of_loads(forces, loads);
  double size = kInfinity;
  for (const Wrench& load : loads) size = std::min(size, load.norm());
  return margin.status == ConeStatus::kSolved && margin.lower * size >= kNoLoad;
}

bool holds_driven(const HeldForces& forces, const std::vector<Wrench>& loads,
                  const std::vector<int>& joints) {
  return holds(hand_forces(forces.set, forces.T, with_motors(forces.actuation, joints)), loads);
}

/// Joints that must be driven all together: none of them can be left out.
std::vector<int> least_motors(const HeldForces& forces, const std::vector<Wrench>& loads,
                              std::vector<int> joints) {
  for (std::size_t i = joints.size(); i-- > 0;) {
    std::vector<int> fewer = joints;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (holds_driven(forces, loads, fewer)) joints.swap(fewer);
  }
  return joints;
}

}  // namespace

std::string unknown_effort(const HeldForces& forces) {
  const Actuation& a = forces.actuation;
  for (Index k = 0; k < a.B.cols(); ++k) {
    if (std::isfinite(a.lower(k)) && std::isfinite(a.upper(k))) continue;
    for (Index j = 0; j < a.B.rows(); ++j)
      if (a.B(j, k) != 0 && feels(forces, j) && !is_locked(a.reactions, j))
        return fmt::format("the effort of '{}' is unknown",
                           forces.layout.actuators[static_cast<std::size_t>(k)]);
  }
  return "";
}

std::string why_nothing_holds(const HeldForces& forces, const std::vector<Wrench>& loads) {
  if (!holds(free_forces(forces.set), loads)) return "friction at the contacts cannot bear it";
  std::vector<int> joints;
  for (Index j = 0; j < forces.T.rows(); ++j)
    if (feels(forces, j)) joints.push_back(static_cast<int>(j));
  if (!holds_driven(forces, loads, joints)) return "nothing presses on what its joints bear";
  std::vector<std::string> names;
  for (const int joint : least_motors(forces, loads, joints))
    names.push_back(
        fmt::format("'{}'", forces.layout.coordinates[static_cast<std::size_t>(joint)]));
  return fmt::format("no effort balances {}", fmt::join(names, ", "));
}

}  // namespace thenar
