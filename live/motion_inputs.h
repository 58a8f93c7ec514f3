#pragma once

/// Inputs of a moving scene, set by name: efforts, targets, tensions and excitations.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "dynamics/stepping/scene_stepper.h"

namespace thenar {

/// Largest inputs of a motion. Larger values are mistakes, and would make steps very slow.
inline constexpr double kMaxMotionEffort = 1e4;   // largest magnitude of an effort [N m] or [N]
inline constexpr double kMaxMotionTarget = 1e3;   // largest magnitude of a target [rad] or [m]
inline constexpr double kMaxMotionTension = 5e3;  // largest tension of a muscle [N]

/// Changes of a scene's inputs by name; inputs that are not named keep their values.
struct MotionInputs {
  std::map<std::string, double> efforts;      // coordinate -> effort, replaces drives [N m] or [N]
  std::map<std::string, double> targets;      // coordinate -> target of its drive [rad] or [m]
  std::map<std::string, double> tensions;     // muscle, "human/index/FDP2" -> tension [N]
  std::map<std::string, double> excitations;  // muscle -> excitation 0..1 [1]
  std::vector<std::string> release;           // coordinates to return to the scene's own drives
};

/// Kinds of inputs of a motion.
enum class MotionInputKind { kEffort, kTarget, kTension, kExcitation };
inline constexpr std::array kMotionInputKindNames{
    EnumName{MotionInputKind::kEffort, "effort"}, EnumName{MotionInputKind::kTarget, "target"},
    EnumName{MotionInputKind::kTension, "tension"},
    EnumName{MotionInputKind::kExcitation, "excitation"}};

/// Input of a motion that can be set, and its current value.
struct MotionInput {
  std::string name;
  MotionInputKind kind = MotionInputKind::kEffort;
  std::string unit;             // "N m", "N", "rad", "m", "1"
  double lower = 0, upper = 0;  // limits of the drive, joint or muscle; infinite: unknown
  std::optional<double> set;    // value that was set; absent: the scene's own
};

/// Inputs of one scene and the values that are set. All steppers passed to a table must be
/// steppers of that scene.
class MotionInputTable {
 public:
  explicit MotionInputTable(const SceneStepper& stepper);

  /// Returns the names of the scene's coordinates, in their order.
  [[nodiscard]] const std::vector<std::string>& coordinates() const { return coordinates_; }

  /// Sets inputs of a stepper; sets none if any is invalid.
  /// @throws InputError for an unknown name (with the nearest one), or a value out of range or
  ///         above the largest inputs
  void set(const MotionInputs& inputs, SceneStepper& stepper);
  /// Returns all inputs with their current values.
  [[nodiscard]] std::vector<MotionInput> list(const SceneStepper& stepper) const;
  /// Clears efforts and targets, as SceneStepper::reset() does.
  void clear();

 private:
  [[nodiscard]] int coordinate_index(const std::string& name) const;
  [[nodiscard]] const ElementControl& control_named(const std::string& name,
                                                    MotionInputKind kind) const;
  void check_controls(const std::map<std::string, double>& values, MotionInputKind kind) const;
  void check_inputs(const MotionInputs& inputs, const SceneStepper& stepper) const;

  std::vector<std::string> coordinates_;
  std::map<int, double> efforts_, targets_;         // values that are set, by coordinate
  std::map<std::string, int> coordinate_indices_;   // index of each coordinate, by name
  std::map<std::string, ElementControl> controls_;  // unit and range of each control, by name
};

}  // namespace thenar
