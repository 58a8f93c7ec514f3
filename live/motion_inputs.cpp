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
    if (is_scalar(joint.kind) && joint.coordinate == coordinate)
      return joint.kind == JointKind::kSlide;
  return false;
}

/// @throws InputError, also for what is no number
void check_size(const std::map<std::string, double>& values, const std::string& kind,
                const std::string& unit, double most) {
  for (const auto& [name, value] : values)
    require(std::abs(value) <= most, "{} of '{}': wanted a number within {:g} {}, got {}", kind,
            name, most, unit, value);
}

}  // namespace

MotionSwitches::MotionSwitches(const SceneStepper& stepper) {
  // Names of coordinates and controls; a tension may be set up to kLargestTension at most.
  const std::vector<MechanismCoordinate>& coordinates = stepper.scene().mechanism.coordinates;
  for (std::size_t c = 0; c < coordinates.size(); ++c) {
    coordinates_.push_back(coordinates[c].name);
    index_of_[coordinates[c].name] = static_cast<int>(c);
  }
  for (ElementControl& control : stepper.controls()) {
    if (control.unit == "N") control.upper = std::min(control.upper, kLargestTension);
    controls_[control.name] = control;
  }
}

void MotionSwitches::clear() {
  efforts_.clear();
  targets_.clear();
}

int MotionSwitches::coordinate_named(const std::string& name) const {
  const auto found = index_of_.find(name);
  if (found != index_of_.end()) return found->second;
  return static_cast<int>(index_of_name(name, coordinates_, "coordinate"));
}

const ElementControl& MotionSwitches::control_named(const std::string& name,
                                                    const std::string& unit) const {
  const auto found = controls_.find(name);
  if (found != controls_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, control] : controls_)
    if (control.unit == unit) names.push_back(known);
  return controls_.at(names[index_of_name(name, names, unit == "N" ? "tension" : "excitation")]);
}

void MotionSwitches::check_controls(const std::map<std::string, double>& values,
                                    const std::string& unit) const {
  for (const auto& [name, value] : values) {
    const ElementControl& control = control_named(name, unit);
    require(control.unit == unit, "'{}' {}", name,
            unit == "N" ? "contracts by itself: set its excitation"
                        : "is pulled by a given tension: set that");
    require(value >= control.lower && value <= control.upper, "'{}' must be {} to {:g} {}, got {}",
            name, control.lower, control.upper, unit, value);
  }
}

void MotionSwitches::check(const MotionInputs& inputs, const SceneStepper& stepper) const {
  for (const auto& [name, value] : inputs.efforts) (void)coordinate_named(name);
  for (const std::string& name : inputs.release) (void)coordinate_named(name);
  check_size(inputs.efforts, "effort", "N m or N", kLargestEffort);
  check_size(inputs.targets, "target", "rad or m", kFarthestTarget);
  for (const auto& [name, value] : inputs.targets)
    require(stepper.first_stiff_drive(coordinate_named(name)) != nullptr,
            "no drive with stiffness moves '{}': set its effort instead", name);
  check_controls(inputs.tensions, "N");
  check_controls(inputs.excitations, "1");
  // An effort takes the place of a target, and a target that of an effort.
  for (const auto& [name, value] : inputs.efforts)
    for (const auto& [other, target] : inputs.targets)
      require(coordinate_named(name) != coordinate_named(other), "'{}' has an effort and a target",
              name);
}

void MotionSwitches::set(const MotionInputs& inputs, SceneStepper& stepper) {
  // Everything is looked at before anything is set.
  check(inputs, stepper);
  for (const std::string& name : inputs.release) {
    const int c = coordinate_named(name);
    stepper.release(c);
    efforts_.erase(c);
    targets_.erase(c);
  }
  for (const auto& [name, value] : inputs.efforts) {
    const int c = coordinate_named(name);
    stepper.set_effort(c, value);
    efforts_[c] = value;
    targets_.erase(c);
  }
  for (const auto& [name, value] : inputs.targets) {
    const int c = coordinate_named(name);
    stepper.set_target(c, value);
    targets_[c] = value;
    efforts_.erase(c);
  }
  for (const auto& [name, value] : inputs.tensions)
    stepper.set_control(control_named(name, "N").name, value);
  for (const auto& [name, value] : inputs.excitations)
    stepper.set_control(control_named(name, "1").name, value);
}

std::vector<MotionInput> MotionSwitches::list(const SceneStepper& stepper) const {
  const auto given = [](const std::map<int, double>& values, int coordinate) {
    const auto found = values.find(coordinate);
    return found == values.end() ? std::nullopt : std::optional<double>(found->second);
  };
  std::vector<MotionInput> out;
  const std::vector<CoordinateRange> ranges = coordinate_ranges(stepper.scene());
  for (std::size_t c = 0; c < coordinates_.size(); ++c) {
    const std::string& name = coordinates_[c];
    const int index = static_cast<int>(c);
    const bool slides = slides_along(stepper.scene(), index);
    const double most = stepper.max_effort(index);
    out.push_back({name, "effort", slides ? "N" : "N m", -most, most, given(efforts_, index)});
    if (stepper.first_stiff_drive(index) != nullptr)
      out.push_back({name, "target", slides ? "m" : "rad", ranges[c].lower, ranges[c].upper,
                     given(targets_, index)});
  }
  for (const ElementControl& control : stepper.controls())
    out.push_back({control.name, control.unit == "N" ? "tension" : "excitation", control.unit,
                   control.lower, control.upper, control.set});
  return out;
}

}  // namespace thenar
