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
  std::shared_ptr<const Shape> shape;  // in its own frame
  double friction = 0;                 // Coulomb, of the exact cone [1]
};

/// Goal of a step: how far the object goes.
struct PressGoal {
  Pose<double> X_PO;                // of the object at the end
  std::optional<double> force;      // instead: moved from there along `along` until the
  Eigen::Vector3d along{0, 0, -1};  // object's push along it is so large [N]; unit (3)
  double time = 0;                  // of the step, for relaxation [s]
};

struct PressOptions {
  double force_tolerance = 1e-9;  // of residuals, over the sum of contact forces [1]
  double gap_tolerance = 1e-9;    // of touching nodes [m]
  int max_iterations = 60;
  std::function<bool()> stop;  // asked before each iteration: true ends the step; empty: never
};

/// Outcome of a step.
struct [[nodiscard]] PressOutcome {
  Status status = Status::kStalled;
  std::string message;
  int iterations = 0;
  double residual = 0;  // largest entry of forces out of balance [N]
  double gap = 0;       // largest |gap| of a touching node [m]
  Wrench push;          // of the object on the body, about the body's origin
};

}  // namespace thenar
