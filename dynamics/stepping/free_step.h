#pragma once

/// Steps of a scene on which no contact, limit or dry friction acts.

#include <array>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Fehlberg's explicit Runge-Kutta method of order eight, with an estimate of its error.
/// Source: [Fehlberg1968] table X.
class FreeStep {
 public:
  static constexpr std::size_t kStages = 13;

  /// @param start  any state of the scene
  explicit FreeStep(const SceneState& start);

  /// Error of a step.
  struct Error {
    double q;           // of positions [m], [rad]
    double v;           // of speeds [m/s], [rad/s]
    double z;           // of states of elements
    bool acted = true;  // all elements could act
  };

  /// Moves a state by h. Quaternions have length 1 afterwards.
  Error step(ContactStep& scene, double h, SceneState& state);

 private:
  std::array<Eigen::VectorXd, kStages> q_rate_, v_rate_, z_rate_;
  SceneState at_;
};

}  // namespace thenar
