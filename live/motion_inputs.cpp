#include "live/motion_inputs.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"
#include "live/scene_picture.h"

namespace thenar {
namespace {

/// Returns true if the first joint of a coordinate slides.
bool slides_along(const MovingScene& scene, int coordinate) {
  for (const MechanismJoint& joint : scene.mechanism.joints)
    if (is_moved_by(joint, coordinate)) return joint.kind == JointKind::kSlide;
  return false;
}

/// Checks that values are numbers within +/- `limit`. @throws InputError otherwise, also for NaN
void check_magnitudes(const std::map<std::string, double>& values, MotionInputKind kind,
                      const std::string& unit, double limit) {
  for (const auto& [name, value] : values)
    require(std::abs(value) <= limit, "{} of '{}': wanted a number within {:g} {}, got {}",
            name_in(kMotionInputKindNames, kind), name, limit, unit, value);
}

/// Returns the kind of a control: muscles are pulled by a tension [N], or contract.
MotionInputKind kind_of(const ElementControl& control) {
  return control.unit == "N" ? MotionInputKind::kTension : MotionInputKind::kExcitation;
}

}  // namespace

MotionInputTable::MotionInputTable(const SceneStepper& stepper) {
  // Index the coordinates and the controls by name, and limit tensions to kMaxMotionTension.
  const std::vector<MechanismCoordinate>& coordinates = stepper.scene().mechanism.coordinates;
  for (std::size_t c = 0; c < coordinates.size(); ++c) {
    coordinates_.push_back(coordinates[c].name);
    coordinate_indices_[coordinates[c].name] = static_cast<int>(c);
  }
  for (ElementControl& control : stepper.controls()) {
    if (kind_of(control) == MotionInputKind::kTension)
      control.upper = std::min(control.upper, kMaxMotionTension);
    controls_[control.name] = control;
  }
}

void MotionInputTable::clear() {
  efforts_.clear();
  targets_.clear();
}

int MotionInputTable::coordinate_index(const std::string& name) const {
  const auto found = coordinate_indices_.find(name);
  if (found != coordinate_indices_.end()) return found->second;
  return static_cast<int>(index_of_name(name, coordinates_, "coordinate"));
}

const ElementControl& MotionInputTable::control_named(const std::string& name,
                                                      MotionInputKind kind) const {
  const auto found = controls_.find(name);
  if (found != controls_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, control] : controls_)
    if (kind_of(control) == kind) names.push_back(known);
  return controls_.at(names[index_of_name(name, names, name_in(kMotionInputKindNames, kind))]);
}

void MotionInputTable::check_controls(const std::map<std::string, double>& values,
                                      MotionInputKind kind) const {
  for (const auto& [name, value] : values) {
    const ElementControl& control = control_named(name, kind);
    require(kind_of(control) == kind, "'{}' {}", name,
            kind == MotionInputKind::kTension ? "contracts by itself: set its excitation"
                                              : "is pulled by a given tension: set that");
    require(value >= control.lower && value <= control.upper, "'{}' must be {} to {:g} {}, got {}",
            name, control.lower, control.upper, control.unit, value);
  }
}

void MotionInputTable::check_inputs(const MotionInputs& inputs, const SceneStepper& stepper) const {
  // Check names and ranges.
  for (const auto& [name, value] : inputs.efforts) (void)coordinate_index(name);
  for (const std::string& name : inputs.release) (void)coordinate_index(name);
  check_magnitudes(inputs.efforts, MotionInputKind::kEffort, "N m or N", kMaxMotionEffort);
  check_magnitudes(inputs.targets, MotionInputKind::kTarget, "rad or m", kMaxMotionTarget);
  for (const auto& [name, value] : inputs.targets)
    require(stepper.first_stiff_drive(coordinate_index(name)) != nullptr,
            "no drive with stiffness moves '{}': set its effort instead", name);
  check_controls(inputs.tensions, MotionInputKind::kTension);
  check_controls(inputs.excitations, MotionInputKind::kExcitation);
  // A coordinate has either an effort or a target.
  for (const auto& [name, value] : inputs.efforts)
    for (const auto& [other, target] : inputs.targets)
      require(coordinate_index(name) != coordinate_index(other), "'{}' has an effort and a target",
              name);
}

void MotionInputTable::set(const MotionInputs& inputs, SceneStepper& stepper) {
  // Check all inputs before setting any.
  check_inputs(inputs, stepper);
  // Release coordinates, then set efforts and targets, which replace each other.
  for (const std::string& name : inputs.release) {
    const int c = coordinate_index(name);
    stepper.release(c);
    efforts_.erase(c);
    targets_.erase(c);
  }
  for (const auto& [name, value] : inputs.efforts) {
    const int c = coordinate_index(name);
    stepper.set_effort(c, value);
    efforts_[c] = value;
    targets_.erase(c);
  }
  for (const auto& [name, value] : inputs.targets) {
    const int c = coordinate_index(name);
    stepper.set_target(c, value);
    targets_[c] = value;
    efforts_.erase(c);
  }
  // Set tensions and excitations.
  for (const auto& [name, value] : inputs.tensions)
    stepper.set_control(control_named(name, MotionInputKind::kTension).name, value);
  for (const auto& [name, value] : inputs.excitations)
    stepper.set_control(control_named(name, MotionInputKind::kExcitation).name, value);
}

std::vector<MotionInput> MotionInputTable::list(const SceneStepper& stepper) const {
  const auto given = [](const std::map<int, double>& values, int coordinate) {
    const auto found = values.find(coordinate);
    return found == values.end() ? std::nullopt : std::optional<double>(found->second);
  };
  // List the effort of each coordinate, and the target of its drive if that has stiffness.
  std::vector<MotionInput> out;
  const std::vector<CoordinateRange> ranges = coordinate_ranges(stepper.scene());
  for (std::size_t c = 0; c < coordinates_.size(); ++c) {
    const std::string& name = coordinates_[c];
    const int index = static_cast<int>(c);
    const bool slides = slides_along(stepper.scene(), index);
    const double limit = stepper.max_effort(index);
    out.push_back({name, MotionInputKind::kEffort, slides ? "N" : "N m", -limit, limit,
                   given(efforts_, index)});
    if (stepper.first_stiff_drive(index) != nullptr)
      out.push_back({name, MotionInputKind::kTarget, slides ? "m" : "rad", ranges[c].lower,
                     ranges[c].upper, given(targets_, index)});
  }
  // List the tensions and excitations of muscles.
  for (const ElementControl& control : stepper.controls())
    out.push_back(
        {control.name, kind_of(control), control.unit, control.lower, control.upper, control.set});
  return out;
}

}  // namespace thenar
