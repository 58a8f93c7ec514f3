#pragma once

/// Closed contacts between two steps: update, impacts and contact modes.

#include <vector>

#include "dynamics/stepping/trial_step.h"

namespace thenar {

/// Set of contacts that touch between two steps. Decides which persist, which end their approach by
/// an impact and which separate.
class TouchingContacts {
 public:
  /// @param step, options, counts, cost  must outlive the object
  TouchingContacts(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
                   SceneCost& cost)
      : step_(step), options_(options), counts_(counts), cost_(cost) {}

  /// Returns the contacts that touch, with the impulses that acted over impulse_time().
  [[nodiscard]] const std::vector<ActiveContact>& closed() const { return closed_; }
  /// Returns the time over which the impulses acted [s]; 0 before the first step.
  [[nodiscard]] double impulse_time() const { return impulse_time_; }
  /// Replaces the contacts by those of a step. @param active  swapped with the previous contacts
  void set_closed(std::vector<ActiveContact>& active, double impulse_time) {
    closed_.swap(active);
    impulse_time_ = impulse_time;
  }

  /// Keeps the found contacts that touch at a state, and resolves impacts where they approach.
  /// @param found  all contacts near the state; overwritten
  void update_with_impacts(SceneState& state, std::vector<ActiveContact>& found);

  /// Closes gaps and penetrations that the step left at contacts with a force, then updates the
  /// contacts as update_with_impacts() does.
  /// @param length  of the step [s]
  /// @return largest |gap| of contacts with a force before the correction [m]
  double close_gaps_and_update(double length, SceneState& state, std::vector<ActiveContact>& found);

 private:
  void remember_lost(const std::vector<ActiveContact>& found);
  [[nodiscard]] bool retain_closed(std::vector<ActiveContact>& found);
  void settle_modes(const SceneState& state);

  ContactStep& step_;
  const SceneOptions& options_;
  ProblemCounts& counts_;
  SceneCost& cost_;
  std::vector<ActiveContact> lost_;    // contacts with a force that the last search did not find
  std::vector<ActiveContact> closed_;  // contacts that touch
  double impulse_time_ = 0;            // time over which their impulses acted [s]
  StepOutcome outcome_;                // workspace of settle_modes()
};

}  // namespace thenar
