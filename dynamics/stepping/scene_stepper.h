#pragma once

/// Interactive simulation of a scene in fixed steps, with inputs that may change between steps.

#include <map>
#include <string>
#include <vector>

#include "dynamics/stepping/fixed_step.h"

namespace thenar {

/// Snapshot of a stepper, to which go_to() returns.
struct SceneInstant {
  SceneState state;
  std::vector<ActiveContact> active;  // contacts of the last step, impulses over `part`
  double part = 0;                    // length of the parts of the last step [s]; 0: no step yet
  long steps = 0;                     // number of steps since the start
};

/// Stepper of fixed step length: the steps of simulate_scene() by kTimeStepping, which it
/// reproduces bit for bit if no input is set. The length is SceneOptions::step_length, adjusted so
/// that `seconds` is a whole number of steps; stepping may continue beyond that. Switching times
/// divide a step.
///
/// Results are bitwise reproducible for the same scene, inputs and steps.
class SceneStepper {
 public:
  /// Starts at the scene's initial state. @throws InputError as ContactStep, or if an option is out
  /// of range.
  explicit SceneStepper(const MovingScene& scene, const SceneOptions& options = {});

  /// Advances by one step; does nothing if the state is not finite.
  /// @param progress  called between the parts of a divided step; may request a stop
  /// @return false if stopped: the stepper has then returned to the start of the step by go_to()
  bool step(const Progress& progress = {});
  /// Returns the present state and contacts.
  [[nodiscard]] const SceneInstant& now() const { return now_; }
  /// Returns the step length [s].
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const MovingScene& scene() const { return step_.scene(); }
  [[nodiscard]] const TreeModel& model() const { return step_.model(); }

  /// Returns the present state with contact forces and energies.
  [[nodiscard]] SceneSample sample();
  /// Returns the present contacts that elements model, such as those of pads.
  [[nodiscard]] std::vector<ContactSample> element_contacts();
  /// Returns a snapshot of this stepper with contact forces and energies.
  [[nodiscard]] SceneSample sample_of(const SceneInstant& instant);
  /// Computes the poses of all bodies at a snapshot. @param out  (bodies)
  void poses(const SceneInstant& instant, std::vector<Pose<double>>& out);
  /// Computes the total effort of the drives of a coordinate at a snapshot, with the present inputs
  /// [N m] or [N].
  [[nodiscard]] double effort(int coordinate, const SceneInstant& instant) const;
  /// Returns the present values that elements report, such as tensions of muscles.
  [[nodiscard]] std::vector<ElementValue> readings() { return step_.element_readings(now_.state); }

  /// Returns the largest effort of a coordinate: that of the scene's drives, otherwise that of its
  /// motor; infinite if neither is known [N m] or [N].
  [[nodiscard]] double max_effort(int coordinate) const;
  /// Returns the first drive of the scene at a coordinate that has stiffness; null if none has.
  [[nodiscard]] const SceneDrive* first_stiff_drive(int coordinate) const;

  /// Replaces the drives of a coordinate by a constant effort, limited to max_effort().
  /// @param effort  [N m] or [N]
  /// @throws InputError if there is no such coordinate, or the effort is not finite.
  void set_effort(int coordinate, double effort);
  /// Replaces the drives of a coordinate by first_stiff_drive() with a constant target, active at
  /// all times. @param target  [rad] or [m]
  /// @throws InputError if no drive of the coordinate has stiffness, or the target is not finite.
  void set_target(int coordinate, double target);
  /// Restores the scene's drives of a coordinate. @throws InputError if there is no such
  /// coordinate.
  void release(int coordinate);
  /// Returns the controls of all elements with their present settings: ForceElement::controls().
  [[nodiscard]] std::vector<ElementControl> controls() const { return step_.element_controls(); }
  /// Sets a control of an element.
  /// @throws InputError if there is no control of that name, or the value is out of range.
  void set_control(const std::string& name, double value);

  /// Returns to the initial state and clears all inputs.
  void reset();
  /// Returns to a snapshot and keeps the present inputs. The snapshot's impulses warm-start the
  /// contacts; the memory of collision pairs and elements is cleared, so that the continuation
  /// depends on the snapshot and the inputs alone, and differs from the earlier one by the error of
  /// a step.
  /// @throws InputError if the instant is of another scene.
  void go_to(const SceneInstant& instant);

  /// Returns the cost of all steps since construction or take_cost().
  [[nodiscard]] const SceneCost& cost() const { return cost_; }
  /// Returns the cost and resets it to zero.
  SceneCost take_cost();

 private:
  [[nodiscard]] std::size_t checked_coordinate(int coordinate) const;
  [[nodiscard]] bool step_to(double end, const Progress& progress);
  void apply_drives();

  ContactStep step_;
  FixedStep fixed_;
  std::vector<SceneDrive> scene_drives_;        // drives of the scene
  std::map<int, SceneDrive> overrides_;         // drive that replaces the scene's, by coordinate
  std::map<std::string, double> set_controls_;  // values that were set, by name of the control
  std::vector<double> switching_times_;         // switching times of the scene [s]
  double length_ = 0;                           // step length [s]
  SceneInstant now_;                            // present
  SceneInstant before_;                         // start of the step in progress
  SceneCost cost_;
};

/// Computes the number of steps into which kTimeStepping divides the simulated time.
[[nodiscard]] long fixed_steps(const SceneOptions& options);

}  // namespace thenar
