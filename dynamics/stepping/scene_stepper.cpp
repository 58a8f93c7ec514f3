#include "dynamics/stepping/scene_stepper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {
namespace {

constexpr double kSameInstant = 1e-6;  // difference of equal instants over the step length [1]

}  // namespace

long fixed_steps(const SceneOptions& options) {
  return std::max(1L, std::lround(options.duration / options.step_length));
}

SceneStepper::SceneStepper(const MovingScene& scene, const SceneOptions& options)
    : step_(scene),
      fixed_(options),
      scene_drives_(scene.drives),
      switching_times_(switching_times(scene)) {
  check_scene_options(options);
  step_.set_solver_options(options.contacts);
  length_ = options.duration / static_cast<double>(fixed_steps(options));
  now_.state = step_.initial_state();
}

bool SceneStepper::step(const Progress& progress) {
  if (!is_finite(now_.state)) return true;
  before_ = now_;
  // End the step at a switching time that differs from its regular end by rounding alone.
  double end = length_ * static_cast<double>(now_.steps + 1);
  const double near = kSameInstant * length_;
  const auto behind =
      std::lower_bound(switching_times_.begin(), switching_times_.end(), end + near);
  if (behind != switching_times_.begin() && *(behind - 1) > end - near) end = *(behind - 1);
  // Step from switching time to switching time, then to the end.
  bool whole = true;
  try {
    for (auto t = std::upper_bound(switching_times_.begin(), switching_times_.end(), now_.state.t);
         whole && t != switching_times_.end() && *t < end; ++t)
      whole = step_to(*t, progress);
    whole = whole && step_to(end, progress);
  } catch (const Stopped&) {
    whole = false;
  }
  // Undo a stopped step.
  if (whole)
    ++now_.steps;
  else
    go_to(before_);
  return whole;
}

bool SceneStepper::step_to(double end, const Progress& progress) {
  const bool is_first = now_.state.t == 0;
  // Take a step of fixed length with the forces active at its start.
  step_.select_active_forces(now_.state.t);
  now_.part = fixed_.take_step(step_, end - now_.state.t, now_.state, now_.active, cost_, progress);
  if (now_.part == 0) return false;
  // Accept the end; record limit excess and penetration, except that of the initial state.
  now_.state.t = end;
  if (is_finite(now_.state)) step_.accept_step(now_.state);
  ++cost_.steps;
  update_limit_excess(scene().mechanism, model().layout, now_.state.q, cost_.limit_excess);
  for (const ActiveContact& contact : now_.active)
    if (!is_first && contact.kind == ActiveContact::Kind::kContact)
      cost_.max_penetration = std::max(cost_.max_penetration, -contact.gap);
  return true;
}

std::vector<ContactSample> SceneStepper::element_contacts() {
  std::vector<ContactSample> out;
  step_.add_element_contacts(now_.state, out);
  return out;
}

SceneSample SceneStepper::sample() { return sample_of(now_); }

SceneSample SceneStepper::sample_of(const SceneInstant& instant) {
  return make_sample(step_, instant.state, instant.active, instant.part);
}

void SceneStepper::poses(const SceneInstant& instant, std::vector<Pose<double>>& out) {
  step_.compute_poses(instant.state, out);
}

double SceneStepper::effort(int coordinate, const SceneInstant& instant) const {
  const MechanismLayout& layout = model().layout;
  const std::size_t c = checked_coordinate(coordinate);
  const SceneState& state = instant.state;
  double sum = 0;
  for (const SceneDrive& drive : scene().drives)
    if (drive.coordinate == coordinate && drive.when.contains(state.t))
      sum += drive_effort(drive, state.q[layout.coordinate_q[c]], state.v[layout.coordinate_v[c]],
                          state.t, state.t);
  return sum;
}

// Inputs: efforts, targets and controls.

std::size_t SceneStepper::checked_coordinate(int coordinate) const {
  require(coordinate >= 0 && coordinate < static_cast<int>(scene().mechanism.coordinates.size()),
          "there is no coordinate {}", coordinate);
  return static_cast<std::size_t>(coordinate);
}

double SceneStepper::max_effort(int coordinate) const {
  const std::size_t c = checked_coordinate(coordinate);
  // Take the largest effort of the coordinate's drives, otherwise that of its motor.
  double max_effort = 0;
  for (const SceneDrive& drive : scene_drives_)
    if (drive.coordinate == coordinate) max_effort = std::max(max_effort, drive.max_effort);
  if (max_effort > 0) return max_effort;
  const double of_motor = scene().mechanism.coordinates[c].max_effort;
  return of_motor > 0 ? of_motor : kInfinity;
}

const SceneDrive* SceneStepper::first_stiff_drive(int coordinate) const {
  return find_where(scene_drives_, [&](const SceneDrive& drive) {
    return drive.coordinate == coordinate && drive.stiffness > 0;
  });
}

void SceneStepper::set_effort(int coordinate, double effort) {
  const std::string& name = scene().mechanism.coordinates[checked_coordinate(coordinate)].name;
  require(std::isfinite(effort), "effort of '{}': wanted a finite number, got {}", name, effort);
  // Override the drives by one with a constant bias and no stiffness.
  SceneDrive drive;
  drive.coordinate = coordinate;
  drive.bias = effort;
  drive.max_effort = max_effort(coordinate);
  overrides_[coordinate] = drive;
  apply_drives();
}

void SceneStepper::set_target(int coordinate, double target) {
  const std::string& name = scene().mechanism.coordinates[checked_coordinate(coordinate)].name;
  require(std::isfinite(target), "target of '{}': wanted a finite number, got {}", name, target);
  const SceneDrive* stiff = first_stiff_drive(coordinate);
  require(stiff != nullptr, "no drive with stiffness moves '{}': set its effort instead", name);
  // Override the drives by the stiff one with a constant target.
  SceneDrive drive = *stiff;
  drive.target = target;
  drive.speed = 0;
  drive.when = {};
  drive.table = nullptr;
  overrides_[coordinate] = drive;
  apply_drives();
}

void SceneStepper::release(int coordinate) {
  (void)checked_coordinate(coordinate);
  if (overrides_.erase(coordinate) > 0) apply_drives();
}

void SceneStepper::apply_drives() {
  // Collect the scene's drives of other coordinates, then the overrides.
  std::vector<SceneDrive> drives;
  for (const SceneDrive& drive : scene_drives_)
    if (overrides_.count(drive.coordinate) == 0) drives.push_back(drive);
  for (const auto& [coordinate, drive] : overrides_) drives.push_back(drive);
  step_.set_drives(std::move(drives));
}

void SceneStepper::set_control(const std::string& name, double value) {
  step_.set_element_control(name, value);
  set_controls_[name] = value;
}

// Snapshots.

void SceneStepper::reset() {
  overrides_.clear();
  apply_drives();
  set_controls_.clear();
  step_.clear_memory();
  now_ = {step_.initial_state(), {}, 0, 0};
}

void SceneStepper::go_to(const SceneInstant& instant) {
  const SceneState& state = instant.state;
  const SceneState& here = now_.state;
  require(state.q.size() == here.q.size() && state.v.size() == here.v.size() &&
              state.z.size() == here.z.size(),
          "wanted an instant of this scene: {} positions and {} states, got {} and {}",
          here.q.size(), here.z.size(), state.q.size(), state.z.size());
  // Clear memory, then restore the snapshot; `instant` may alias now_.
  const SceneInstant copy = instant;
  step_.clear_memory();
  for (const auto& [name, value] : set_controls_) step_.set_element_control(name, value);
  now_ = copy;
  if (now_.steps > 0 && is_finite(now_.state)) step_.accept_step(now_.state);
}

SceneCost SceneStepper::take_cost() { return std::exchange(cost_, {}); }

}  // namespace thenar
