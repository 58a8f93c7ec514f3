#pragma once

/// Detection of a scene at rest that will stay at rest.

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Returns true if no velocity is above 1e-11 rad/s or m/s.
[[nodiscard]] bool is_still(const SceneState& state);

/// Counter of consecutive steps at rest.
class SceneSleep {
 public:
  /// Returns true if nothing moved in the last three steps.
  [[nodiscard]] bool is_asleep() const { return steps_ >= 3; }
  /// Restarts the count: something has switched.
  void wake() { steps_ = 0; }

  /// Updates the count after an accepted step; sets the velocities of a scene at rest to zero.
  /// @param was_still  is_still() before the step
  /// @param slides     a contact slides
  /// @param gap        largest |gap| of contacts with a force before its correction [m]
  /// @param touch      largest gap that counts as closed [m]
  void observe_step(ContactStep& step, bool was_still, bool slides, double gap, double touch,
                    SceneState& state);

 private:
  int steps_ = 0;  // number of consecutive steps at rest
};

}  // namespace thenar
