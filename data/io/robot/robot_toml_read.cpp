// Robots from TOML.

#include "base/error.h"
#include "data/io/robot/robot_parts.h"

namespace thenar {
namespace {

/// What a file says whose robot has no source: numbers must cite something.
const std::string kUnstated = "unstated";

void read_approach(TomlTable& top, RobotSpec& robot) {
  std::optional<TomlTable> table = top.table("approach");
  robot.approach_stated = table.has_value();
  if (!table) return;
  robot.approach.point = table->vector_or(Dimension::kLength, "point", {0, 0, 0});
  robot.approach.direction = internal::read_unit(*table, "direction");
  table->done();
}

}  // namespace

RobotSpec parse_robot(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  RobotSpec robot;
  robot.name = top.text("name");
  robot.description = top.text_or("description", "");
  robot.source = top.source() == kUnstated ? "" : top.source();
  robot.licence = top.text_or("licence", "");
  robot.closing_stated =
      !top.has("closing") || top.choice("closing", {"stated", "unstated"}) == "stated";
  if (top.has("warnings")) robot.warnings = top.texts("warnings");
  if (top.has("open_loops")) robot.open_loops = top.texts("open_loops");
  read_approach(top, robot);
  for (TomlTable& table : top.tables("link"))
    robot.links.push_back(internal::read_robot_link(table, path));
  for (TomlTable& table : top.tables("dof")) robot.dofs.push_back(internal::read_robot_dof(table));
  for (TomlTable& table : top.tables("joint"))
    robot.joints.push_back(internal::read_robot_joint(table));
  for (TomlTable& table : top.tables("dh_chain"))
    for (RobotJoint& joint : internal::read_robot_dh_chain(table))
      robot.joints.push_back(std::move(joint));
  top.done();
  try {
    check_robot(robot);
  } catch (const InputError& error) {
    top.fail(error.what());
  }
  return robot;
}

RobotSpec read_robot(const std::string& path) { return parse_robot(read_text_file(path), path); }

}  // namespace thenar
