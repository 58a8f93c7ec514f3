#include "dynamics/scene/scene_drives.h"

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"
#include "data/io/toml_node.h"
#include "dynamics/scene/target_table.h"

namespace thenar {
namespace {

/// Reads the target table of a drive; null if it has none.
std::shared_ptr<const TargetTable> read_target_table(const SceneSpec& scene,
                                                     const SceneDriveSpec& spec) {
  if (spec.target_file.empty()) return nullptr;
  const std::string path = linked_path(scene.folder, spec.target_file);
  return std::make_shared<TargetTable>(
      without_straight_knots(parse_target_table(read_text_file(path), path, spec)));
}

/// Sets the contact compliance that the file states.
void set_compliance(const SceneSpec& spec, ContactCompliance& out) {
  const SteppingSpec& stepping = spec.stepping;
  out.modulus = stepping.modulus.value_or(out.modulus);
  out.stiffness = stepping.stiffness.value_or(out.stiffness);
  out.dissipation = stepping.dissipation.value_or(out.dissipation);
  out.layer = stepping.layer.value_or(out.layer);
  out.transition = stepping.transition.value_or(out.transition);
  if (stepping.friction_ramp.empty()) return;
  out.ramp = at_line(spec.path, stepping.line, [&] {
    return value_in(kFrictionRampNames, stepping.friction_ramp, "friction ramp");
  });
}

}  // namespace

void add_forces(const SceneSpec& spec, BuiltScene& built) {
  for (const SceneForceSpec& force : spec.forces) {
    const int body = at_line(spec.path, force.line,
                             [&] { return body_named(built.scene.mechanism, force.body); });
    const Eigen::Vector3d& com = built.scene.mechanism.bodies[body].mass.com;
    built.scene.forces.push_back(
        {body, force.point.value_or(com), force.force, force.moment, {force.from, force.to}});
    built.force_names.push_back(force.name);
  }
}

void add_drives(const SceneSpec& spec, BuiltScene& built) {
  const Mechanism& mechanism = built.scene.mechanism;
  const std::vector<std::string> names = names_of(mechanism.coordinates);
  for (const SceneDriveSpec& drive : spec.drives) {
    SceneDrive out;
    out.coordinate = at_line(spec.path, drive.line, [&] {
      return static_cast<int>(index_of_name(drive.coordinate, names, "coordinate"));
    });
    // Check that the units of the drive fit the kind of its joint.
    const MechanismJoint* joint = find_where(
        mechanism.joints, [&](const auto& each) { return is_moved_by(each, out.coordinate); });
    const bool turns = joint->kind == JointKind::kHinge;
    if (turns != drive.turns)
      throw DataError(spec.path, drive.line,
                      fmt::format("'{}' {}, but the drive has units of what {}", drive.coordinate,
                                  turns ? "turns" : "slides", turns ? "slides" : "turns"));
    // Copy the drive; its largest effort is by default that of the motor.
    const double known = mechanism.coordinates[out.coordinate].max_effort;
    out.bias = drive.effort;
    out.stiffness = drive.stiffness;
    out.damping = drive.damping;
    out.target = drive.target;
    out.speed = drive.speed;
    out.max_effort = drive.max_effort.value_or(known > 0 ? known : kInfinity);
    out.when = {drive.from, drive.to};
    out.table = read_target_table(spec, drive);
    built.scene.drives.push_back(out);
    built.drive_names.push_back(drive.name);
  }
}

void set_stepping(const SceneSpec& spec, BuiltScene& built) {
  const SteppingSpec& stepping = spec.stepping;
  SceneOptions& options = built.options;
  options.method = at_line(spec.path, stepping.line, [&] {
    return value_in(kSteppingMethodNames, stepping.method, "method");
  });
  // Step lengths, samples and tolerances.
  options.duration = stepping.duration;
  options.sample_interval = stepping.sample;
  options.step_length = stepping.step.value_or(options.step_length);
  options.max_step = stepping.longest.value_or(options.max_step);
  options.tolerance = stepping.tolerance.value_or(options.tolerance);
  options.recovery = stepping.recovery.value_or(options.recovery);
  set_compliance(spec, built.options.compliance);
}

}  // namespace thenar
