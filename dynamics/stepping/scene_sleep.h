#pragma once

/// Rest of a scene: whether nothing moves and nothing will.

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Returns whether speeds are those of a scene at rest.
[[nodiscard]] bool is_still(const SceneState& state);

/// Counts the last steps that changed nothing.
class SceneSleep {
 public:
  /// Returns whether the scene sleeps: nothing moved in the last three steps.
  [[nodiscard]] bool sleeps() const { return steps_ >= 3; }
  void wake() { steps_ = 0; }

  /// Observes a step that was accepted; a scene that stays at rest gets speeds of zero.
  /// @param was_still  before the step
  /// @param gap  largest of contacts with a force that was closed in it [m];  @param touch  [m]
  void observe(ContactStep& step, bool was_still, bool slides, double gap, double touch,
               SceneState& state);

 private:
  int steps_ = 0;  // that changed nothing
};

}  // namespace thenar
