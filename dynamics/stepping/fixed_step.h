#pragma once

/// One step of a fixed length, in as many parts as surfaces ask for.

#include <vector>

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Steps by ContactStep::time_step(). Owns the room that they need; one object per thread.
class FixedStep {
 public:
  /// Takes one step in 1, 2, 4, .. equal parts, the fewest in which nothing goes through something
  /// thin (ContactStep::motion_between), or parts as short as SceneOptions::shortest.
  /// @param h      [s]
  /// @param state  from the beginning to the end of the step
  /// @param last   contacts of the part before, then of the last part of this step
  /// @param cost   counts the parts of all trials, and what the step that is kept left unsolved
  /// @param progress  told and asked before each part but the first
  /// @return the length of a part [s]; 0: it was stopped, and is where it began
  double take(ContactStep& step, double h, const SceneOptions& options, SceneState& state,
              std::vector<ActiveContact>& last, SceneCost& cost, const Progress& progress = {});

 private:
  StepOutcome outcome_;
};

/// Multiplies impulses, as of contacts whose step had another length.
void scale_impulses(std::vector<ActiveContact>& list, double factor);

/// Returns true if positions, speeds and states of elements are finite.
[[nodiscard]] bool is_finite(const SceneState& state);

/// Contacts of a step that do not open, as runs keep them. @param h  over which impulses acted [s];
/// 0: no step was made, and there are none
[[nodiscard]] std::vector<ContactSample> contact_samples(const std::vector<ActiveContact>& active,
                                                         double h);

}  // namespace thenar
