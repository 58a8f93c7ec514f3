#pragma once

/// Steps of a fixed length, subdivided where surfaces could pass through each other.

#include <vector>

#include "base/progress.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Fixed steps by ContactStep::take_midpoint_step(). Owns their workspace; one object per thread.
class FixedStep {
 public:
  explicit FixedStep(const SceneOptions& options) : options_(options) {}

  /// Takes one step in 1, 2, 4, .. equal parts: the fewest whose ContactStep::tunnelling_ratio() is
  /// at most 1, or parts no longer than SceneOptions::min_step.
  /// @param h         length of the whole step [s]
  /// @param state     state at the start, replaced by that at the end
  /// @param last      contacts of the previous part, replaced by those of the last part
  /// @param cost      counts the parts of all trials, and the unsolved problems of the final one
  /// @param progress  called before each part of a subdivided step; may request a stop
  /// @return length of a part [s]; 0: stopped, state and contacts are those of the start
  double take_step(ContactStep& step, double h, SceneState& state, std::vector<ActiveContact>& last,
                   SceneCost& cost, const Progress& progress = {});

 private:
  SceneOptions options_;
  StepOutcome outcome_;
};

/// Multiplies the impulses of contacts, to convert them to a step of another length.
void scale_impulses(std::vector<ActiveContact>& list, double factor);

/// Returns true if positions, velocities and element states are finite.
[[nodiscard]] bool is_finite(const SceneState& state);

/// Converts the contacts of a step that are not open to samples with mean forces.
/// @param h  time over which the impulses acted [s]; 0: no step was taken, the result is empty
[[nodiscard]] std::vector<ContactSample> contact_samples(const std::vector<ActiveContact>& active,
                                                         double h);

/// Returns a sample of a state, with energies and with the contacts of the step that ended there
/// and of elements. @param h  time over which the impulses acted [s]
[[nodiscard]] SceneSample make_sample(ContactStep& step, const SceneState& state,
                                      const std::vector<ActiveContact>& active, double h);

}  // namespace thenar
