#pragma once

/// What loads a grasp holds.

#include <map>
#include <string>
#include <vector>

#include "grasp/compare/comparison.h"

namespace thenar {

struct GraspLoads {
  double hold = 0;                       // as BestGrasp
  std::map<std::string, double> margin;  // as BestGrasp
};

/// Loads of tasks about the object's centre of mass, along its own axes: weight both ways along
/// each of the three, a pull of 1 N along +-z, a torque of 1 N m about +-z. Efforts may be those
/// that hold the joints at the posture, as hand_forces() has them; a load that needs no effort, a
/// palm's, has no limit.
/// @param mass  of the object [kg], under 9.81 m/s^2
[[nodiscard]] GraspLoads grasp_loads(const Hand& hand, const BestGrasp& grasp,
                                     const SceneBody& object, double mass,
                                     const std::vector<GraspTask>& tasks);

}  // namespace thenar
