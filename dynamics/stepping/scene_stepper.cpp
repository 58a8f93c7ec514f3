#include "dynamics/stepping/scene_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/progress_parts.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {
namespace {

constexpr double kSameInstant = 1e-6;  // instants that differ by less of a step are one [1]

}  // namespace

long fixed_steps(const SceneOptions& options) {
  return std::max(1L, std::lround(options.seconds / options.step));
}

SceneStepper::SceneStepper(const MovingScene& scene, const SceneOptions& options)
    : step_(scene), options_(options), drives_(scene.drives), switches_(switching_times(scene)) {
  check_scene_options(options);
  step_.solve_contacts_by(options.contacts);
  length_ = options.seconds / static_cast<double>(fixed_steps(options));
  now_.state = step_.start();
}

bool SceneStepper::step(const Progress& progress) {
  if (!is_finite(now_.state)) return true;
  before_ = now_;
  // A step ends where something begins or ends to act; what differs by rounding is one instant.
  double end = length_ * static_cast<double>(now_.steps + 1);
  const double near = kSameInstant * length_;
  const auto behind = std::lower_bound(switches_.begin(), switches_.end(), end + near);
  if (behind != switches_.begin() && *(behind - 1) > end - near) end = *(behind - 1);
  // Parts between switches; a stop takes the whole step back.
  bool whole = true;
  try {
    for (auto t = std::upper_bound(switches_.begin(), switches_.end(), now_.state.t);
         whole && t != switches_.end() && *t < end; ++t)
      whole = part_step(*t, progress);
    whole = whole && part_step(end, progress);
  } catch (const Stopped&) {
    whole = false;
  }
  if (whole)
    ++now_.steps;
  else
    go_to(before_);
  return whole;
}

bool SceneStepper::part_step(double end, const Progress& progress) {
  const bool is_first = now_.state.t == 0;
  // Step of a fixed length with the forces of its beginning.
  step_.act_as_at(now_.state.t);
  now_.part =
      fixed_.take(step_, end - now_.state.t, options_, now_.state, now_.active, cost_, progress);
  if (now_.part == 0) return false;
  // Accept the end, and note limits and depths; a depth in the first part is the scene's own.
  now_.state.t = end;
  if (is_finite(now_.state)) step_.accept(now_.state);
  ++cost_.steps;
  note_limits(scene().mechanism, model().layout, now_.state.q, cost_.beyond);
  for (const ActiveContact& contact : now_.active)
    if (!is_first && contact.kind == ActiveContact::Kind::kContact)
      cost_.deepest = std::max(cost_.deepest, -contact.gap);
  return true;
}

std::vector<ContactSample> SceneStepper::element_contacts() {
  std::vector<ContactSample> out;
  step_.add_element_contacts(now_.state, out);
  return out;
}

SceneSample SceneStepper::sample() { return sample_of(now_); }

SceneSample SceneStepper::sample_of(const SceneInstant& instant) {
  const SceneState& state = instant.state;
  SceneSample out;
  out.t = state.t;
  out.q = state.q;
  out.v = state.v;
  out.z = state.z;
  out.contacts = contact_samples(instant.active, instant.part);
  step_.add_element_contacts(state, out.contacts);
  out.energy = step_.energy(state);
  out.w = state.w;
  return out;
}

void SceneStepper::poses(const SceneInstant& instant, std::vector<Pose<double>>& out) {
  step_.poses(instant.state, out);
}

double SceneStepper::effort(int coordinate, const SceneInstant& instant) const {
  const MechanismLayout& layout = model().layout;
  const std::size_t c = checked(coordinate);
  const SceneState& state = instant.state;
  double sum = 0;
  for (const SceneDrive& drive : scene().drives)
    if (drive.coordinate == coordinate && drive.when.holds(state.t))
      sum += drive_effort(drive, state.q[layout.coordinate_q[c]], state.v[layout.coordinate_v[c]],
                          state.t, state.t);
  return sum;
}

// Inputs.

std::size_t SceneStepper::checked(int coordinate) const {
  require(coordinate >= 0 && coordinate < static_cast<int>(scene().mechanism.coordinates.size()),
          "there is no coordinate {}", coordinate);
  return static_cast<std::size_t>(coordinate);
}

double SceneStepper::largest_effort(int coordinate) const {
  const std::size_t c = checked(coordinate);
  // Largest effort of the coordinate's drives, or else of its motor.
  double most = 0;
  for (const SceneDrive& drive : drives_)
    if (drive.coordinate == coordinate) most = std::max(most, drive.max_effort);
  if (most > 0) return most;
  const double of_motor = scene().mechanism.coordinates[c].max_effort;
  return of_motor > 0 ? of_motor : std::numeric_limits<double>::infinity();
}

const SceneDrive* SceneStepper::stiff_drive(int coordinate) const {
  const auto found = std::find_if(drives_.begin(), drives_.end(), [&](const SceneDrive& drive) {
    return drive.coordinate == coordinate && drive.stiffness > 0;
  });
  return found == drives_.end() ? nullptr : &*found;
}

void SceneStepper::set_effort(int coordinate, double effort) {
  const std::string& name = scene().mechanism.coordinates[checked(coordinate)].name;
  require(std::isfinite(effort), "effort of '{}': wanted a finite number, got {}", name, effort);
  // The effort as a drive without stiffness, in place of the scene's drives.
  SceneDrive drive;
  drive.coordinate = coordinate;
  drive.bias = effort;
  drive.max_effort = largest_effort(coordinate);
  overrides_[coordinate] = drive;
  use_drives();
}

void SceneStepper::set_target(int coordinate, double target) {
  const std::string& name = scene().mechanism.coordinates[checked(coordinate)].name;
  require(std::isfinite(target), "target of '{}': wanted a finite number, got {}", name, target);
  const SceneDrive* stiff = stiff_drive(coordinate);
  require(stiff != nullptr, "no drive with stiffness moves '{}': set its effort instead", name);
  // The stiff drive with a constant target, in place of the scene's drives.
  SceneDrive drive = *stiff;
  drive.target = target;
  drive.speed = 0;
  drive.when = {};
  drive.table = nullptr;
  overrides_[coordinate] = drive;
  use_drives();
}

void SceneStepper::release(int coordinate) {
  (void)checked(coordinate);
  if (overrides_.erase(coordinate) > 0) use_drives();
}

void SceneStepper::use_drives() {
  // Drives of the scene, but those of coordinates that are overridden.
  std::vector<SceneDrive> drives;
  for (const SceneDrive& drive : drives_)
    if (overrides_.count(drive.coordinate) == 0) drives.push_back(drive);
  for (const auto& [coordinate, drive] : overrides_) drives.push_back(drive);
  step_.set_drives(std::move(drives));
}

void SceneStepper::set_control(const std::string& name, double value) {
  step_.set_control(name, value);
  controls_[name] = value;
}

void SceneStepper::use_controls() {
  for (const auto& [name, value] : controls_) step_.set_control(name, value);
}

// Back and forth.

void SceneStepper::reset() {
  overrides_.clear();
  use_drives();
  controls_.clear();
  step_.forget();
  now_ = {step_.start(), {}, 0, 0};
}

void SceneStepper::go_to(const SceneInstant& instant) {
  const SceneState& state = instant.state;
  const SceneState& here = now_.state;
  require(state.q.size() == here.q.size() && state.v.size() == here.v.size() &&
              state.z.size() == here.z.size(),
          "wanted an instant of this scene: {} positions and {} states, got {} and {}",
          here.q.size(), here.z.size(), state.q.size(), state.z.size());
  const SceneInstant copy = instant;  // it may be the present
  step_.forget();
  use_controls();
  now_ = copy;
  if (now_.steps > 0 && is_finite(now_.state)) step_.accept(now_.state);
}

SceneCost SceneStepper::take_cost() { return std::exchange(cost_, {}); }

}  // namespace thenar
