#include "data/io/scene/scene_keys.h"

#include "base/error.h"
#include "data/io/world/world_keys.h"

namespace thenar::internal {
namespace {

/// Dimensions of the quantities of a coordinate.
struct CoordinateUnits {
  Dimension value, speed, effort, stiffness, damping;
};
CoordinateUnits units_of_coordinate(bool turns) {
  if (turns)
    return {Dimension::kAngle, Dimension::kAngularSpeed, Dimension::kMoment,
            Dimension::kAngularStiffness, Dimension::kAngularDamping};
  return {Dimension::kLength, Dimension::kSpeed, Dimension::kForce, Dimension::kLinearStiffness,
          Dimension::kLinearDamping};
}

/// `from` and `to` of what acts for a time.
template <typename Spec>
void read_span(TomlTable& table, Spec& spec) {
  spec.from = table.number_or(Dimension::kTime, "from", spec.from, Range::kNotNegative);
  spec.to = table.number_or(Dimension::kTime, "to", spec.to);
  if (spec.to <= spec.from)
    table.fail(fmt::format("wanted 'to' after 'from', got {:g} s to {:g} s", spec.from, spec.to),
               "to");
}

/// Two different names.
std::vector<std::string> read_between(TomlTable& table) {
  std::vector<std::string> between = table.texts("between");
  if (between.size() != 2)
    table.fail(fmt::format("wanted two names in 'between', got {}", between.size()), "between");
  if (between[0] == between[1])
    table.fail(fmt::format("'{}' cannot touch itself", between[0]), "between");
  return between;
}

/// Reads the keys of a hinge or slide beside its axis.
void read_coordinate(TomlTable& table, SceneJointSpec& joint) {
  // A hinge has radians and N m, a slide metres and newtons; the file states degrees or
  // millimetres.
  const CoordinateUnits units = units_of_coordinate(joint.kind == JointKind::kHinge);
  joint.start = table.number_or(units.value, "start", 0);
  joint.speed = table.number_or(units.speed, "speed", 0);
  if (table.has(units.value, "range")) {
    const std::vector<double> range = table.numbers(units.value, "range", 2);
    joint.lower = range[0];
    joint.upper = range[1];
    if (joint.lower > joint.upper)
      table.fail(
          fmt::format("wanted 'range' from low to high, got {:g} to {:g}", range[0], range[1]),
          "range");
  }
  // Springs, damping and dry friction act on the coordinate.
  if (joint.start < joint.lower || joint.start > joint.upper)
    table.fail("wanted 'start' within 'range'", "start");
  joint.stiffness = table.number_or(units.stiffness, "stiffness", 0, Range::kNotNegative);
  joint.rest = table.number_or(units.value, "rest", 0);
  joint.damping = table.number_or(units.damping, "damping", 0, Range::kNotNegative);
  joint.friction = table.number_or(units.effort, "friction", 0, Range::kNotNegative);
}

}  // namespace

SceneJointSpec read_scene_joint(TomlTable& owner, JointKind kind) {
  SceneJointSpec joint;
  joint.kind = kind;
  joint.line = owner.line();
  std::optional<TomlTable> table = owner.table("joint");
  if (!table) return joint;
  joint.line = table->line();
  joint.kind = table->choice("kind", kJointKindNames);
  joint.parent = table->text_or("parent", "");
  if (joint.kind == JointKind::kFree && !joint.parent.empty())
    table->fail("what is free has no parent", "parent");
  // Each kind has keys of its own.
  const bool moves_along_axis = joint.kind == JointKind::kHinge || joint.kind == JointKind::kSlide;
  if (moves_along_axis) joint.axis = read_direction(*table, "axis");
  if (joint.kind == JointKind::kHinge || joint.kind == JointKind::kBall)
    joint.point = table->vector(Dimension::kLength, "point");
  if (moves_along_axis) read_coordinate(*table, joint);
  if (joint.kind == JointKind::kBall)
    joint.spin = table->vector_or(Dimension::kAngularSpeed, "angular_velocity", joint.spin);
  table->done();
  return joint;
}

SceneVelocity read_scene_velocity(TomlTable& owner, JointKind kind) {
  SceneVelocity velocity;
  for (const auto& [dimension, key] : {std::pair{Dimension::kSpeed, "velocity"},
                                       std::pair{Dimension::kAngularSpeed, "angular_velocity"}})
    if (owner.has(dimension, key) && kind != JointKind::kFree)
      owner.fail(fmt::format("only what is free has '{}': give its joint a speed", key), key);
  velocity.linear = owner.vector_or(Dimension::kSpeed, "velocity", velocity.linear);
  velocity.angular =
      owner.vector_or(Dimension::kAngularSpeed, "angular_velocity", velocity.angular);
  return velocity;
}

SceneForceSpec read_scene_force(TomlTable& table) {
  SceneForceSpec force;
  force.line = table.line();
  force.body = table.text("body");
  force.name = table.text_or("name", force.body);
  if (table.has(Dimension::kLength, "point"))
    force.point = table.vector(Dimension::kLength, "point");
  force.force = table.vector_or(Dimension::kForce, "force", force.force);
  force.moment = table.vector_or(Dimension::kMoment, "moment", force.moment);
  if (force.force.isZero(0) && force.moment.isZero(0))
    table.fail("[[force]] needs a 'force' or a 'moment' that is not zero");
  read_span(table, force);
  return force;
}

SceneDriveSpec read_scene_drive(TomlTable& table, const std::string& folder) {
  SceneDriveSpec drive;
  drive.line = table.line();
  drive.coordinate = table.text("coordinate");
  drive.name = table.text_or("name", drive.coordinate);
  // Its units say whether it turns or slides.
  const auto has_any = [&](const CoordinateUnits& units) {
    return table.has(units.effort, "effort") || table.has(units.value, "target") ||
           table.has(units.stiffness, "stiffness") || table.has(units.damping, "damping") ||
           table.has(units.speed, "speed") || table.has(units.effort, "max_effort");
  };
  const bool turns = has_any(units_of_coordinate(true)),
             slides = has_any(units_of_coordinate(false));
  if (turns && slides)
    table.fail("wanted the units of a turn (Nm, deg ..) or those of a slide (N, mm ..), got both");
  if (!turns && !slides) table.fail("[[drive]] needs an 'effort', or a 'target' with 'stiffness'");
  drive.turns = turns;
  // Read the drive: an effort, or a spring to a target with damping, up to the largest effort.
  const CoordinateUnits units = units_of_coordinate(turns);
  drive.effort = table.number_or(units.effort, "effort", 0);
  drive.stiffness = table.number_or(units.stiffness, "stiffness", 0, Range::kNotNegative);
  drive.damping = table.number_or(units.damping, "damping", 0, Range::kNotNegative);
  drive.target = table.number_or(units.value, "target", 0);
  drive.speed = table.number_or(units.speed, "speed", 0);
  drive.max_effort = number_if(table, units.effort, "max_effort", Range::kNotNegative);
  if (drive.stiffness == 0 && table.has(units.value, "target"))
    table.fail("a 'target' needs a 'stiffness'", "target");
  // A file states the target over time.
  if (table.has("target_file")) {
    drive.target_file = table.text("target_file");
    (void)file_beside(table, "target_file", folder);
    if (drive.stiffness == 0) table.fail("a 'target_file' needs a 'stiffness'", "target_file");
    if (table.has(units.value, "target") || table.has(units.speed, "speed"))
      table.fail("a 'target_file' says all of the target: no 'target' and no 'speed' beside it",
                 "target_file");
  }
  read_span(table, drive);
  return drive;
}

SceneMuscleSpec read_scene_muscle(TomlTable& table, bool tensions, const std::string& folder) {
  SceneMuscleSpec muscle;
  muscle.line = table.line();
  muscle.hand = table.text("hand");
  muscle.tensions = tensions;
  const char* key = tensions ? "tension" : "excitation";
  const std::string file_key = std::string(key) + "_file";
  muscle.value = tensions ? table.named(Dimension::kForce, key, Range::kNotNegative)
                          : table.named(Dimension::kNumber, key, Range::kFraction);
  if (table.has(file_key)) {
    muscle.file = table.text(file_key);
    (void)file_beside(table, file_key, folder);
  }
  if (muscle.value.empty() == muscle.file.empty())
    table.fail(fmt::format("{} needs '{}' or '{}'", table.title(), key, file_key));
  if (!tensions) muscle.rung = table.text_or("rung", muscle.rung);
  read_span(table, muscle);
  return muscle;
}

SceneFrictionSpec read_scene_friction(TomlTable& table) {
  SceneFrictionSpec friction;
  friction.line = table.line();
  if (table.has("between")) friction.between = read_between(table);
  friction.coefficient = number_if(table, Dimension::kNumber, "coefficient", Range::kNotNegative);
  friction.torsion_radius =
      number_if(table, Dimension::kLength, "torsion_radius", Range::kNotNegative);
  friction.restitution = number_if(table, Dimension::kNumber, "restitution", Range::kFraction);
  if (!friction.coefficient && !friction.torsion_radius && !friction.restitution)
    table.fail("[[friction]] needs 'coefficient', 'torsion_radius' or 'restitution'");
  return friction;
}

SceneApartSpec read_scene_apart(TomlTable& table) { return {read_between(table), table.line()}; }

SteppingSpec read_stepping(TomlTable& table) {
  // Method and duration are common to all methods; the rest has defaults that depend on the method.
  SteppingSpec stepping;
  stepping.line = table.line();
  stepping.method = table.text_or("method", stepping.method);
  stepping.duration = table.number(Dimension::kTime, "duration", Range::kPositive);
  stepping.sample = table.number_or(Dimension::kTime, "sample", stepping.sample, Range::kPositive);
  if (stepping.duration / stepping.sample > kMaxSceneSamples)
    table.fail(fmt::format("wanted at most {:g} samples, got {:g} s in steps of {:g} s",
                           kMaxSceneSamples, stepping.duration, stepping.sample),
               "sample");
  const auto if_stated = [&](Dimension dimension, const char* key) {
    return number_if(table, dimension, key, Range::kPositive);
  };
  // Each of these belongs to some methods only, and is kept unset if it is not stated.
  stepping.step = if_stated(Dimension::kTime, "step");
  stepping.longest = if_stated(Dimension::kTime, "longest_step");
  stepping.tolerance = if_stated(Dimension::kNumber, "tolerance");
  stepping.recovery = if_stated(Dimension::kSpeed, "recovery");
  stepping.modulus = if_stated(Dimension::kStress, "modulus");
  stepping.stiffness = if_stated(Dimension::kLinearStiffness, "stiffness");
  stepping.dissipation = if_stated(Dimension::kInverseSpeed, "dissipation");
  stepping.layer = if_stated(Dimension::kLength, "layer");
  stepping.transition = if_stated(Dimension::kSpeed, "transition_speed");
  stepping.friction_ramp = table.text_or("friction_ramp", "");
  table.done();
  return stepping;
}

}  // namespace thenar::internal
