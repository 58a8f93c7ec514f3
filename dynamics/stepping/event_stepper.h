#pragma once

/// Event-driven time stepper: steps of variable length between closing gaps, changes of contact
/// mode and switching times of forces.
///
/// One step, EventStepper::take_step():
///   1. EventStepper passes over a chattering contact (FixedStep) or a scene at rest (SceneSleep).
///   2. StepControl chooses the trial length: error estimate, expected mode change, next stop.
///   3. StepTrials::try_step() integrates a trial. Without closed contacts FreeStep takes one step
///      of order eight; otherwise Extrapolation combines columns of 1, 2, .. n Euler substeps.
///   4. ContactStep::take_euler_substep() takes each substep (see contact_step.h).
///   5. StepTrials reports the error, the instant of a closing gap and that of a mode change; force
///      elements add their own error. EventStepper accepts the trial, or rejects it and lets
///      StepControl shorten it.
///   6. TouchingContacts closes the remaining gaps by projection, resolves impacts and determines
///      the contact modes for the next step.
///   7. Force elements accept the step, SceneSleep checks for rest, StepControl sets the next
///   length.

#include <vector>

#include "dynamics/stepping/fixed_step.h"
#include "dynamics/stepping/scene_sleep.h"
#include "dynamics/stepping/step_control.h"
#include "dynamics/stepping/touching_contacts.h"
#include "dynamics/stepping/trial_step.h"

namespace thenar {

/// Time stepper for SteppingMethod::kEvents; simulate_scene() describes the method.
class EventStepper {
 public:
  /// @param options, cost  must outlive the stepper
  /// @throws InputError as ContactStep
  EventStepper(const MovingScene& scene, const SceneOptions& options, SceneCost& cost);

  /// Resolves the impacts of contacts that approach at the start. Call once, before take_step().
  void resolve_initial_impacts();

  /// Advances the state by one step, by a burst of fixed steps if contacts chatter, or to the next
  /// switching time if the scene rests.
  /// @param stop  latest end of the step [s]
  /// @return false if no step is possible because the state has become infinite or NaN
  [[nodiscard]] bool take_step(double stop);

  [[nodiscard]] const SceneState& state() const { return state_; }
  /// Returns the current state with its contact forces and energies.
  [[nodiscard]] SceneSample sample();
  /// Computes the energies at a state.
  [[nodiscard]] SceneEnergy energy_at(const SceneState& state) { return step_.energy(state); }

 private:
  [[nodiscard]] double next_stop(double stop) const;
  [[nodiscard]] bool is_chattering();
  void skip_chattering(double stop);
  void skip_rest(double stop);
  [[nodiscard]] double take_adaptive_step(double wanted, double left, double stop);
  [[nodiscard]] bool find_accepted_length(double& length);
  [[nodiscard]] double trial_error(double length, int& unsolved_trials);
  void accept_trial(double length, double end);
  void update_energy_account(SceneState& end);
  void wake_at_switches();
  [[nodiscard]] double max_displacement(const StepTrial& trial, double length) const;

  ContactStep step_;
  FixedStep fixed_;
  const SceneOptions& options_;
  SceneCost& cost_;
  std::vector<double> switching_times_;  // instants at which forces, drives or laws switch [s]
  SceneState state_;
  ProblemCounts counts_;
  StepTrials trials_;
  TouchingContacts touching_;
  StepControl control_;
  SceneSleep sleep_;
  double next_length_ = 0;    // proposed length of the next step [s]
  bool was_solved_ = true;    // the previous step solved all its contact problems
  int steps_since_mark_ = 0;  // steps counted by is_chattering() since mark_time_
  double mark_time_ = -1;     // start of the steps that is_chattering() judges [s]
};

}  // namespace thenar
