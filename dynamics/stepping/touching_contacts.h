#pragma once

/// Contacts that touch between two steps: which go on, which end their approach, which leave.

#include <vector>

#include "dynamics/stepping/trial_step.h"

namespace thenar {

class TouchingContacts {
 public:
  /// @param step, options, counts, cost  outlive it
  TouchingContacts(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
                   SceneCost& cost)
      : step_(step), options_(options), counts_(counts), cost_(cost) {}

  /// Contacts that touch, with impulses over impulse_time().
  [[nodiscard]] const std::vector<ActiveContact>& closed() const { return closed_; }
  /// Time over which their impulses acted [s]; 0: no step was made.
  [[nodiscard]] double impulse_time() const { return impulse_time_; }
  /// Takes the contacts of a step. @param active  becomes the contacts before
  void take(std::vector<ActiveContact>& active, double impulse_time) {
    closed_.swap(active);
    impulse_time_ = impulse_time;
  }

  /// Keeps what touches of all that was found at a state, and ends its approach.
  /// @param found  its room is used
  void touch_and_bounce(SceneState& state, std::vector<ActiveContact>& found);

  /// Closes gaps that have opened or overlap since a trial was inspected, and ends approaches.
  /// @param length  of the step [s]
  /// @return the largest gap of contacts with a force, before it was closed [m]
  double touch_again(double length, SceneState& state, std::vector<ActiveContact>& found);

 private:
  void note_lost(const std::vector<ActiveContact>& found);
  [[nodiscard]] bool keep_closed(std::vector<ActiveContact>& found);
  void settle_modes(const SceneState& state);

  ContactStep& step_;
  const SceneOptions& options_;
  ProblemCounts& counts_;
  SceneCost& cost_;
  std::vector<ActiveContact> lost_, closed_;
  double impulse_time_ = 0;
  StepOutcome outcome_;
};

}  // namespace thenar
