#pragma once

/// Accelerations of one mechanism by every engine.

#include <functional>
#include <string>

#include <Eigen/Core>

#include "dynamics/stepping/moving_scene.h"

namespace thenar::bench {

/// An engine that holds a tree of hinges without contacts.
struct PeerMachine {
  std::string engine;
  /// Accelerations under weight at positions and speeds. (v)
  std::function<const Eigen::VectorXd&(const Eigen::VectorXd& q, const Eigen::VectorXd& v)> of;
};

// One function an engine; those that are not installed are not built.
[[nodiscard]] PeerMachine our_machine(const MovingScene& scene);
[[nodiscard]] PeerMachine simbody_machine(const MovingScene& scene);
[[nodiscard]] PeerMachine mujoco_machine(const MovingScene& scene);
[[nodiscard]] PeerMachine dart_machine(const MovingScene& scene);

}  // namespace thenar::bench
