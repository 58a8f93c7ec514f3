#pragma once

/// Inputs of a moving scene, set by name: efforts, targets, tensions and excitations.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/stepping/scene_stepper.h"

namespace thenar {

/// Largest inputs of a motion: beyond them is a mistake, and steps take longer than anybody waits.
inline constexpr double kLargestEffort = 1e4;   // [N m], of sliding coordinates [N]
inline constexpr double kFarthestTarget = 1e3;  // either way from zero [rad] or [m]
inline constexpr double kLargestTension = 5e3;  // [N]

/// Inputs that drive a scene from now on, by names; inputs that are not named keep their values.
struct MotionInputs {
  std::map<std::string, double> efforts;      // of coordinates, in place of drives [N m] or [N]
  std::map<std::string, double> targets;      // of drives [rad] or [m]
  std::map<std::string, double> tensions;     // of muscles: "human/index/FDP2" [N]
  std::map<std::string, double> excitations;  // of muscles, 0..1 [1]
  std::vector<std::string> release;           // coordinates that go back to the scene's drives
};

/// Input of a motion that may be set.
struct MotionInput {
  std::string name;
  std::string kind;             // "effort", "target", "tension", "excitation"
  std::string unit;             // "N m", "N", "rad", "m", "1"
  double lower = 0, upper = 0;  // of the thing itself; infinite: no limit is known
  std::optional<double> set;    // absent: it is as the scene has it
};

/// The inputs of one scene, and what they are set to. Steppers are those of this scene.
class MotionSwitches {
 public:
  explicit MotionSwitches(const SceneStepper& stepper);

  /// Names of the scene's coordinates, in their order.
  [[nodiscard]] const std::vector<std::string>& coordinates() const { return coordinates_; }

  /// Sets inputs of a stepper, all or, where one is refused, none.
  /// @throws InputError with the nearest name of what is not there, or where a value is impossible
  ///         or beyond the largest inputs above.
  void set(const MotionInputs& inputs, SceneStepper& stepper);
  /// Returns every input, and what it is set to.
  [[nodiscard]] std::vector<MotionInput> list(const SceneStepper& stepper) const;
  /// Forgets efforts and targets, as a stepper does that is reset.
  void clear();

 private:
  [[nodiscard]] int coordinate_named(const std::string& name) const;
  [[nodiscard]] const ElementControl& control_named(const std::string& name,
                                                    const std::string& unit) const;
  void check_controls(const std::map<std::string, double>& values, const std::string& unit) const;
  void check(const MotionInputs& inputs, const SceneStepper& stepper) const;

  std::vector<std::string> coordinates_;
  std::map<int, double> efforts_, targets_;         // that are set, by coordinate
  std::map<std::string, int> index_of_;             // of coordinates
  std::map<std::string, ElementControl> controls_;  // what each may be set to
};

}  // namespace thenar
