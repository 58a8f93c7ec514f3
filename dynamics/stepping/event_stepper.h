#pragma once

/// A scene that goes on by steps between events: contacts that close, modes that change, forces
/// that begin or end to act.

#include <vector>

#include "dynamics/stepping/fixed_step.h"
#include "dynamics/stepping/scene_sleep.h"
#include "dynamics/stepping/step_control.h"
#include "dynamics/stepping/touching_contacts.h"
#include "dynamics/stepping/trial_step.h"

namespace thenar {

/// Steps by kEvents: see simulate_scene().
class EventStepper {
 public:
  /// @param options, cost  outlive it
  EventStepper(const MovingScene& scene, const SceneOptions& options, SceneCost& cost);

  /// Ends approaches at the start by impacts.
  void begin();

  /// Goes on by one step, or through a pile of events, or a rest.
  /// @param stop  instant at which it must end at the latest [s]
  /// @return false if no step can be made: the state is no number
  [[nodiscard]] bool go_on(double stop);

  [[nodiscard]] const SceneState& state() const { return state_; }
  /// The state and its contacts as runs keep them.
  [[nodiscard]] SceneSample sample();
  /// Energies at a state.
  [[nodiscard]] SceneEnergy energy_at(const SceneState& state) {
    return step_.energy(state);
  }

 private:
  [[nodiscard]] double next_stop(double stop) const;
  [[nodiscard]] bool is_chattering();
  void pass_events(double stop);
  void pass_time(double stop);
  [[nodiscard]] double step_once(double wanted, double left, double stop);
  [[nodiscard]] bool find_length(double& length);
  [[nodiscard]] double doubt_of(double length, int& unsolved);
  void accept(double length, double end);
  void keep_account(SceneState& end);
  void wake_at_switches();
  [[nodiscard]] double moved_by(const StepTrial& trial, double length) const;

  ContactStep step_;
  FixedStep fixed_;
  const SceneOptions& options_;
  SceneCost& cost_;
  std::vector<double> switches_;  // instants at which something begins or ends to act [s]
  SceneState state_;
  ProblemCounts counts_;
  StepTrials trials_;
  TouchingContacts touching_;
  StepControl control_;
  SceneSleep sleep_;
  double length_ = 0;       // of the next step, if nothing else bounds it [s]
  bool was_solved_ = true;  // the last step
  int since_mark_ = 0;      // steps that are judged
  double mark_ = -1;        // when they began [s]
};

}  // namespace thenar
