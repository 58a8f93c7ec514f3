#pragma once

/// Object, goal, options and outcome of one step of a press.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "solvers/status.h"

namespace thenar {

/// A rigid object that presses on a body.
struct RigidObject {
  std::shared_ptr<const Shape> shape;  // surface in the object's own frame
  double friction = 0;                 // Coulomb coefficient of the exact cone [1]
};

/// Goal of a step: a pose of the object, or a force that it reaches from that pose.
struct PressGoal {
  Pose<double> X_PO;                // pose of the object at the end, in the body's frame
  std::optional<double> force;      // force of the object along `along` [N]: the object moves from
                                    // X_PO along that direction until it presses as hard
  Eigen::Vector3d along{0, 0, -1};  // direction of `force`, unit (3)
  double time = 0;                  // duration of the step, for relaxation [s]
};

struct PressOptions {
  double force_tolerance = 1e-9;  // residual forces over the sum of contact forces [1]
  double gap_tolerance = 1e-9;    // gaps of touching nodes [m]
  int max_iterations = 60;
  std::function<bool()> stop;  // called before each iteration: true ends the step; empty: never
};

/// Outcome of a step.
struct [[nodiscard]] PressOutcome {
  Status status = Status::kStalled;
  std::string message;  // reason for a failure
  int iterations = 0;
  double residual = 0;  // largest component of the unbalanced forces [N]
  double gap = 0;       // largest |gap| of a touching node [m]
  Wrench push;          // wrench of the object on the body, about the body's origin
};

/// Returns an outcome with the reason of its failure.
[[nodiscard]] inline PressOutcome failed_by(PressOutcome out, const std::string& reason) {
  out.message = reason;
  return out;
}

}  // namespace thenar
