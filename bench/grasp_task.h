#pragma once

/// Many grasps of superellipsoids by a Barrett hand, and how long their parts take.

#include <memory>
#include <vector>

#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "grasp/robot/robot_hand.h"

namespace thenar::bench {

/// What all threads look at and none changes.
struct GraspTask {
  RobotHand hand;
  CollisionHand collision_hand;
  std::vector<GraspSetup> setups;  // one for each object
};

/// Objects with semi-axes of 30, 40 and 50 mm and both exponents in {0.3, 1, 1.7}: nearly a box, an
/// ellipsoid, nearly an octahedron, and six between them; of glass.
[[nodiscard]] std::unique_ptr<const GraspTask> build_grasp_task();

/// Sums over grasps.
struct GraspTimes {
  double approach = 0;  // [s]
  double close = 0;     // [s]
  double contacts = 0;  // [s]
  double quality = 0;   // [s]
  int starts = 0;
  int grasped = 0;   // starts that came to contacts
  int closures = 0;  // of these, with force closure

  [[nodiscard]] double all() const { return approach + close + contacts + quality; }
  GraspTimes& operator+=(const GraspTimes& other);
};

/// Grasps number first, first + step, ... below `count` of every object; start and spread of each
/// are drawn from its own number, so that it is the same on any thread. Processor time of this
/// thread.
[[nodiscard]] GraspTimes time_grasps(const GraspTask& task, int first, int step, int count);

}  // namespace thenar::bench
