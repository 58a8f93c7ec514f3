// Robots to TOML.

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/robot/robot_parts.h"
#include "data/io/toml_text.h"
#include "data/io/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using internal::Measures;
using internal::measures_of;
using internal::same_bits;

void add(std::string& text, const std::string& line) { text += line + "\n"; }

const char* mark(bool guessed) { return guessed ? "  # guessed" : ""; }

void add_text(std::string& text, const std::string& key, const std::string& value,
              bool guessed = false) {
  if (!value.empty()) add(text, key + " = " + toml_quoted(value) + mark(guessed));
}

/// Adds a number, unless the reader assumes it anyway.
void add_number(std::string& text, const std::string& key, double value, double assumed = 0) {
  if (value != assumed || std::signbit(value) != std::signbit(assumed))
    add(text, key + " = " + toml_number(value));
}

void add_pose(std::string& text, const std::string& key, const Pose<double>& X) {
  const std::vector<std::string> lines = toml_of(X);
  if (!lines.empty()) add(text, fmt::format("{} = {{{}}}", key, fmt::join(lines, ", ")));
}

/// Citation keys; keys that are not in data/sources.bib cite themselves.
std::string source_lines(const std::string& source) {
  if (source.empty())
    return "source = \"unstated\"\n\n[sources]\nunstated = \"where it came from says none\"\n";
  const std::vector<std::string> keys = keys_in(source);
  std::string text = "source = " + toml_list(keys) + "\n", own;
  const std::vector<std::string>& known = known_sources();
  for (auto key = keys.begin(); key != keys.end(); ++key)
    if (std::find(known.begin(), known.end(), *key) == known.end() &&
        std::find(keys.begin(), key, *key) == key)
      own += toml_quoted(*key) + " = " + toml_quoted(*key) + "\n";
  return own.empty() ? text : text + "\n[sources]\n" + own;
}

std::string link_lines(const RobotLink& link, const RobotLink& stated) {
  std::string text = "\n[[link]]\nname = " + toml_quoted(link.name) + "\n";
  add_text(text, "digit", link.digit, link.digit != stated.digit);
  add_text(text, "material", link.material, link.material != stated.material);
  add_number(text, "mass_kg", link.mass);
  // Mass, centre and inertia as far as they are not zero.
  if (!same_bits(link.com, Vector3d(0, 0, 0))) add(text, "com_m = " + toml_list(link.com));
  const Eigen::Matrix3d& I = link.inertia;
  if (!same_bits(I, Eigen::Matrix3d(Eigen::Matrix3d::Zero())))
    add(text, "inertia_kg_m2 = " +
                  toml_list(same_bits(I, Eigen::Matrix3d(I.transpose()))
                                ? std::vector<double>{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                                                      I(1, 2)}
                                : std::vector<double>{I(0, 0), I(0, 1), I(0, 2), I(1, 0), I(1, 1),
                                                      I(1, 2), I(2, 0), I(2, 1), I(2, 2)}));
  // Shapes as tables of their own.
  for (const ShapeSpec& shape : link.shapes) {
    add(text, "\n[[link.shape]]");
    for (const std::string& line : toml_of(shape)) add(text, line);
  }
  return text;
}

std::string joint_lines(const RobotJoint& joint) {
  // Names and kind.
  const Measures& in = measures_of(slides(joint));
  std::string text = "\n[[joint]]\nname = " + toml_quoted(joint.name) + "\n";
  add(text, "kind = " + toml_quoted(name_of(joint.kind)));
  add(text, "parent = " + toml_quoted(joint.parent));
  add(text, "child = " + toml_quoted(joint.child));
  // What drives it.
  add_text(text, "dof", joint.dof);
  add_number(text, "ratio", joint.ratio, 1);
  if (!same_bits(joint.axis, Vector3d(0, 0, 1))) add(text, "axis = " + toml_list(joint.axis));
  // Limits, and the numbers that differ from the reader's defaults.
  if (joint.kind != RobotJointKind::kFixed || joint.lower != 0 || joint.upper != 0)
    add(text, fmt::format("{} = {}", si_key("range", in.value),
                          toml_list(std::vector<double>{joint.lower, joint.upper})));
  add_number(text, si_key("offset", in.value), joint.offset);
  if (!joint.curve.empty()) add(text, "curve = " + toml_list(joint.curve));
  add_number(text, si_key("rest", in.value), joint.rest);
  add_number(text, si_key("damping", in.damping), joint.damping);
  add_number(text, si_key("friction", in.effort), joint.friction);
  add_number(text, si_key("stiffness", in.stiffness), joint.stiffness);
  // Frames at both ends.
  add_pose(text, "frame", joint.X_PJ);
  add_pose(text, "child_frame", joint.X_JC);
  return text;
}

/// A `speed` that is guessed is marked as such; where no way of closing is stated it is a `rate`.
std::string speed_line(const RobotDof& dof, bool closing_stated, bool closing_guessed) {
  std::string text;
  if (closing_guessed)
    add(text, "speed = " + toml_number(dof.speed) + mark(true));
  else
    add_number(text, closing_stated ? "speed" : "rate", dof.speed);
  return text;
}

std::string dof_lines(const RobotDof& dof, const RobotDof& stated, const Measures& in,
                      const std::string& speed) {
  std::string text = "\n[[dof]]\nname = " + toml_quoted(dof.name) + "\n";
  add(text, fmt::format("kind = \"{}\"", name_in(kDriveCouplingNames, dof.kind)));
  add(text, fmt::format("{} = {}", si_key("range", in.value),
                        toml_list(std::vector<double>{dof.lower, dof.upper})));
  text += speed;
  if (dof.open)
    add(text, fmt::format("{} = {}{}", si_key("open", in.value), toml_number(*dof.open),
                          mark(dof.open != stated.open)));
  add_number(text, si_key("max_effort", in.effort), dof.max_effort);
  add_number(text, si_key("breakaway", in.effort), dof.breakaway);
  add_number(text, si_key("stiffness", in.stiffness), dof.stiffness);
  if (!dof.backdrivable) add(text, "backdrive = \"held\"");
  if (dof.nominal_effort) add(text, "effort_is = \"nominal\"");
  return text;
}

std::string approach_lines(const RobotApproach& approach, const RobotSpec& stated) {
  const bool guessed = !stated.approach_stated || approach.point != stated.approach.point ||
                       approach.direction != stated.approach.direction;
  return fmt::format("\n[approach]{}\npoint_m = {}\ndirection = {}\n", mark(guessed),
                     toml_list(approach.point), toml_list(approach.direction));
}

/// Refuses numbers so large that our own reader would refuse them.
void require_size(double value, Dimension dimension, const std::string& whose, const char* what) {
  const double most = largest_of(dimension);
  require(std::abs(value) <= most,
          "wanted the {} of {} of at most {} in size, got {:g}: a robot's file may hold no more",
          what, whose, with_si_unit(most, dimension), value);
}

void require_size(const Vector3d& p, const std::string& whose, const char* what) {
  for (int i = 0; i < 3; ++i) require_size(p[i], Dimension::kLength, whose, what);
}

void require_link_size(const RobotLink& link) {
  const std::string whose = fmt::format("link '{}'", link.name);
  require_size(link.mass, Dimension::kMass, whose, "mass");
  require_size(link.com, whose, "centre of mass");
  require_size(link.inertia.cwiseAbs().maxCoeff(), Dimension::kInertia, whose, "inertia");
  for (const ShapeSpec& shape : link.shapes) {
    require_size(shape.X_BS.p, "a shape of " + whose, "position");
    require_size(shape.size, "a shape of " + whose, "size");
    if (shape.mesh_file.empty())
      for (const auto& p : shape.mesh.vertices.colwise())
        require_size(Vector3d(p), "a mesh of " + whose, "vertex");
  }
}

void require_joint_size(const RobotJoint& joint) {
  const std::string whose = fmt::format("joint '{}'", joint.name);
  // Dimensions by the kind of joint.
  const Measures& in = measures_of(slides(joint));
  require_size(joint.lower, in.value, whose, "lower limit");
  require_size(joint.upper, in.value, whose, "upper limit");
  require_size(joint.offset, in.value, whose, "offset");
  require_size(joint.rest, in.value, whose, "rest");
  require_size(joint.damping, in.damping, whose, "damping");
  require_size(joint.friction, in.effort, whose, "friction");
  require_size(joint.stiffness, in.stiffness, whose, "stiffness");
  require_size(joint.ratio, Dimension::kNumber, whose, "ratio");
  for (const double each : joint.curve) require_size(each, Dimension::kNumber, whose, "curve");
  require_size(joint.X_PJ.p, whose, "position");
  require_size(joint.X_JC.p, "the child of " + whose, "position");
}

void require_dof_size(const RobotDof& dof, bool slides) {
  const std::string whose = fmt::format("degree of freedom '{}'", dof.name);
  const Measures& in = measures_of(slides);
  require_size(dof.lower, in.value, whose, "lower limit");
  require_size(dof.upper, in.value, whose, "upper limit");
  require_size(dof.speed, Dimension::kNumber, whose, "speed");
  require_size(dof.max_effort, in.effort, whose, "effort");
  require_size(dof.breakaway, in.effort, whose, "breakaway torque");
  require_size(dof.stiffness, in.stiffness, whose, "stiffness");
}

void require_sizes(const RobotSpec& robot) {
  for (const RobotLink& link : robot.links) require_link_size(link);
  for (const RobotJoint& joint : robot.joints) require_joint_size(joint);
  for (const RobotDof& dof : robot.dofs) require_dof_size(dof, slides(robot, dof));
  require_size(robot.approach.point, fmt::format("robot '{}'", robot.name), "approach");
}

}  // namespace

std::string robot_toml(const RobotSpec& robot, const RobotSpec* stated) {
  // A file that could not be read again is not written.
  check_robot(robot);
  require_sizes(robot);
  const RobotSpec& before = stated == nullptr ? robot : *stated;
  const bool closing_guessed = robot.closing_stated && !before.closing_stated;
  // Header.
  std::string text = "name = " + toml_quoted(robot.name) + "\n";
  add_text(text, "description", robot.description);
  add_text(text, "licence", robot.licence);
  if (!robot.warnings.empty()) add(text, "warnings = " + toml_list(robot.warnings));
  if (!robot.open_loops.empty()) add(text, "open_loops = " + toml_list(robot.open_loops));
  if (!robot.closing_stated && !any_speed(robot)) add(text, "closing = \"unstated\"");
  text += source_lines(robot.source);
  // Approach, links, degrees of freedom, joints.
  if (robot.approach_stated) text += approach_lines(robot.approach, before);
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    text += link_lines(robot.links[i], before.links[i]);
  for (std::size_t i = 0; i < robot.dofs.size(); ++i)
    text += dof_lines(robot.dofs[i], before.dofs[i], measures_of(slides(robot, robot.dofs[i])),
                      speed_line(robot.dofs[i], robot.closing_stated, closing_guessed));
  for (const RobotJoint& joint : robot.joints) text += joint_lines(joint);
  return text;
}

// Robots from TOML.
namespace {

/// Citation of a robot without source, because numbers must cite something.
const std::string kUnstated = "unstated";

void read_approach(TomlTable& top, RobotSpec& robot) {
  std::optional<TomlTable> table = top.table("approach");
  robot.approach_stated = table.has_value();
  if (!table) return;
  robot.approach.point = table->vector_or(Dimension::kLength, "point", {0, 0, 0});
  robot.approach.direction = internal::read_unit(*table, "direction");
  table->done();
}

/// Motors. A rate says how fast a motor closes, and a speed also which way: rates without any
/// speed leave the closing unstated.
void read_dofs(TomlTable& top, RobotSpec& robot) {
  bool any_speed = false;
  std::optional<TomlTable> rate_alone;
  for (TomlTable& table : top.tables("dof")) {
    const bool speed = table.has("speed");
    any_speed = any_speed || speed;
    if (table.has("rate") && !speed && !rate_alone) rate_alone = table;
    robot.dofs.push_back(internal::read_robot_dof(table));
  }
  if (!rate_alone) return;
  if (any_speed)
    rate_alone->fail(
        "wanted a speed, negative where downwards closes and 0 where it stays, as other motors "
        "have one, got a rate alone");
  robot.closing_stated = false;
}

}  // namespace

RobotSpec parse_robot(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  RobotSpec robot;
  // Header.
  robot.name = top.text("name");
  robot.description = top.text_or("description", "");
  robot.source = top.source() == kUnstated ? "" : top.source();
  robot.licence = top.text_or("licence", "");
  robot.closing_stated =
      !top.has("closing") || top.choice("closing", {"stated", "unstated"}) == "stated";
  if (top.has("warnings")) robot.warnings = top.texts("warnings");
  if (top.has("open_loops")) robot.open_loops = top.texts("open_loops");
  // Approach and parts.
  read_approach(top, robot);
  read_each(top, "link", robot.links, internal::read_robot_link, path);
  read_dofs(top, robot);
  read_each(top, "joint", robot.joints, internal::read_robot_joint);
  for (TomlTable& table : top.tables("dh_chain"))
    for (RobotJoint& joint : internal::read_robot_dh_chain(table))
      robot.joints.push_back(std::move(joint));
  top.done();
  // Errors of the whole robot are reported at the file.
  internal::check_here(top, [&] { check_robot(robot); });
  return robot;
}

RobotSpec read_robot(const std::string& path) {
  RobotSpec robot = parse_robot(read_text_file(path), path);
  robot.files = digests_of({path});
  for (const RobotLink& link : robot.links) robot.files.merge(mesh_files(link.shapes, path));
  return robot;
}

}  // namespace thenar
