#pragma once

/// A scene that goes on step by step, while what drives it may be changed between steps.

#include <map>
#include <string>
#include <vector>

#include "dynamics/stepping/fixed_step.h"

namespace thenar {

/// State of a stepper. go_to() a copy returns to it.
struct SceneInstant {
  SceneState state;
  std::vector<ActiveContact> active;  // of the last step, impulses over `part`
  double part = 0;                    // length of that step's parts [s]; 0: no step yet
  long steps = 0;                     // since the start
};

/// Steps of fixed length, those of simulate_scene() by kTimeStepping: without inputs, the same bits
/// at the same instants. The length is SceneOptions::step, adjusted as there so that `seconds` are
/// a whole number of steps; after these it goes on. What begins or ends to act divides a step.
///
/// The same scene, inputs and steps give the same bits.
class SceneStepper {
 public:
  /// @throws InputError as ContactStep, or if an option is impossible.
  explicit SceneStepper(const MovingScene& scene, const SceneOptions& options = {});

  /// One step. Where the state is not finite any more, nothing happens.
  /// @param progress  told and asked between parts of a step that is divided
  /// @return false if it was stopped: then it goes back to where the step began, by go_to()
  bool step(const Progress& progress = {});
  [[nodiscard]] const SceneInstant& now() const { return now_; }
  [[nodiscard]] double length() const { return length_; }  // of a step [s]
  [[nodiscard]] const MovingScene& scene() const { return step_.scene(); }
  [[nodiscard]] const TreeModel& model() const { return step_.model(); }

  /// The present as runs keep it: contacts with forces, energies.
  [[nodiscard]] SceneSample sample();
  /// Contacts at the present that elements stand for, as those of pads.
  [[nodiscard]] std::vector<ContactSample> element_contacts();
  /// Another instant of this stepper as runs keep it.
  [[nodiscard]] SceneSample sample_of(const SceneInstant& instant);
  /// Poses of all bodies at an instant.
  void poses(const SceneInstant& instant, std::vector<Pose<double>>& out);
  /// Computes the effort of drives at a coordinate at an instant, by the present inputs [N m] or
  /// [N].
  [[nodiscard]] double effort(int coordinate, const SceneInstant& instant) const;
  /// Returns the values that elements report at the present, such as tensions of muscles.
  [[nodiscard]] std::vector<ElementValue> readings() { return step_.readings(now_.state); }

  /// The largest effort of a coordinate: that of the scene's drives, or of its motor; infinite
  /// where neither is known [N m] or [N].
  [[nodiscard]] double largest_effort(int coordinate) const;
  /// The first drive of the scene at a coordinate that has stiffness; null: there is none.
  [[nodiscard]] const SceneDrive* stiff_drive(int coordinate) const;

  /// Drives a coordinate by this effort alone from now on, in place of its drives. It is cut to the
  /// largest effort of these, or of the motor where that is known.
  /// @throws InputError if there is no such coordinate, or the effort is not finite.
  void set_effort(int coordinate, double effort);
  /// Sets the target of a coordinate's drive from now on: the first drive of the scene that has
  /// stiffness, at all times. @param target  [rad] or [m]
  /// @throws InputError if no drive of the coordinate has stiffness, or the target is not finite.
  void set_target(int coordinate, double target);
  /// Gives the coordinate back to the drives of the scene.
  void release(int coordinate);
  /// Numbers of elements that may be set, with what they are set to: see ForceElement::controls().
  [[nodiscard]] std::vector<ElementControl> controls() const { return step_.controls(); }
  /// @throws InputError if there is no control of that name, or it cannot have that value.
  void set_control(const std::string& name, double value);

  /// Back to the start; no input is set any more.
  void reset();
  /// Continues from an instant of this scene, with all inputs as they are now. Contacts begin with
  /// its impulses; the memory of pairs of bodies and of elements beyond the state begins anew, so
  /// that the continuation depends on the instant and the inputs alone, and differs from the
  /// earlier one by the error of a step.
  /// @throws InputError if the instant is of another scene.
  void go_to(const SceneInstant& instant);

  /// Returns the cost of steps since the beginning, or since take_cost().
  [[nodiscard]] const SceneCost& cost() const { return cost_; }
  /// Returns the cost, and counts from zero from now on.
  SceneCost take_cost();

 private:
  [[nodiscard]] std::size_t checked(int coordinate) const;
  [[nodiscard]] bool part_step(double end, const Progress& progress);
  void use_drives();
  void use_controls();

  ContactStep step_;
  SceneOptions options_;
  FixedStep fixed_;
  std::vector<SceneDrive> drives_;       // of the scene
  std::map<int, SceneDrive> overrides_;  // by coordinate: in place of its drives
  std::map<std::string, double> controls_;
  std::vector<double> switches_;  // [s]
  double length_ = 0;             // of a step [s]
  SceneInstant now_;
  SceneInstant before_;  // a step; its room
  SceneCost cost_;
};

/// Computes the number of steps into which simulate_scene() divides a scene's time, by
/// kTimeStepping.
[[nodiscard]] long fixed_steps(const SceneOptions& options);

}  // namespace thenar
