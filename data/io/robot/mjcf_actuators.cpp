#include "data/io/robot/mjcf_actuators.h"

#include <algorithm>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/lists.h"

namespace thenar::internal {
namespace {

/// Largest forces: of the force range; or gear times gain times the controls, for motors and
/// general actuators that act like motors.
EffortRange effort_of(const MjcfElement& actuator, const std::string& kind) {
  const std::vector<double> gear = actuator.numbers("gear");
  const double ratio = gear.empty() ? 1 : gear[0];
  const auto within = [&](const char* range, double gain) {
    const std::vector<double> ends = actuator.numbers(range);
    if (ends.size() != 2) return EffortRange{};
    return EffortRange{std::max(0.0, std::max(ends[0], ends[1])),
                       std::max(0.0, -std::min(ends[0], ends[1]))}
        .through(gain * ratio);
  };
  // A force range is explicit.
  if (actuator.text("forcelimited") != "false" && actuator.has("forcerange"))
    return within("forcerange", 1);
  // Otherwise the control range decides, if the gain is constant.
  if (actuator.text("ctrllimited") == "false") return {};
  if (kind == "motor") return within("ctrlrange", 1);
  const std::string gain = actuator.text("gaintype", "fixed"),
                    bias = actuator.text("biastype", "none");
  if (kind != "general" || gain != "fixed" || bias != "none") return {};
  const std::vector<double> gains = actuator.numbers("gainprm");
  return within("ctrlrange", gains.empty() ? 1 : gains[0]);
}

/// Limits of a tendon's length by MuJoCo's rules, if it has any.
std::optional<JointRange> limits_of(const MjcfSource& source, const pugi::xml_node& tendon) {
  const MjcfElement element(source, tendon, "");
  const std::vector<double> range = element.numbers("range");
  const std::string limited = element.text("limited", "auto");
  if (range.size() != 2) return {};
  if (limited != "true" && !(limited == "auto" && source.compiler.auto_limits)) return {};
  return JointRange{std::min(range[0], range[1]), std::max(range[0], range[1])};
}

/// Joints of a tendon with their coefficients.
FixedTendon read_fixed_tendon(const MjcfSource& source, const RobotSpec& robot,
                              const pugi::xml_node& node) {
  FixedTendon tendon{node.attribute("name").value(), {}, source.file.line(node), {}};
  tendon.limits = limits_of(source, node);
  for (const pugi::xml_node term : node.children("joint")) {
    const std::string name = required_text(source.file, term, "joint");
    if (!has_joint(source, robot, term, name)) continue;
    tendon.terms.push_back({name, number_or(source.file, term, "coef", 1)});
  }
  return tendon;
}

}  // namespace

EffortRange EffortRange::through(double ratio) const {
  return ratio < 0 ? EffortRange{-ratio * down, -ratio * up}
                   : EffortRange{ratio * up, ratio * down};
}

EffortRange& EffortRange::operator+=(const EffortRange& other) {
  up += other.up;
  down += other.down;
  return *this;
}

bool has_joint(const MjcfSource& source, const RobotSpec& robot, const pugi::xml_node& node,
               const std::string& name) {
  if (find_named(robot.joints, name) != nullptr) return true;
  const std::string what =
      fmt::format("<{}> names joint '{}', and there is no such hinge or slide", node.name(), name);
  if (!source.incomplete) source.file.fail(node, what);
  source.unread.note(node, what + ": it is left out");
  return false;
}

std::vector<FixedTendon> read_fixed_tendons(const MjcfSource& source, const RobotSpec& robot) {
  std::vector<FixedTendon> tendons;
  for (const pugi::xml_node section : source.file.root().children("tendon"))
    for (const pugi::xml_node node : section.children()) {
      if (node.type() != pugi::node_element) continue;
      // Spatial tendons are not read.
      if (std::string(node.name()) != "fixed") {
        source.unread.note(node, fmt::format("<{}> tendon '{}' is not read", node.name(),
                                             node.attribute("name").value()));
        continue;
      }
      tendons.push_back(read_fixed_tendon(source, robot, node));
    }
  return tendons;
}

std::vector<MjcfActuator> read_actuators(const MjcfSource& source, const RobotSpec& robot,
                                         const std::vector<FixedTendon>& tendons) {
  std::vector<MjcfActuator> actuators;
  for (const pugi::xml_node section : source.file.root().children("actuator"))
    for (const pugi::xml_node node : section.children()) {
      if (node.type() != pugi::node_element) continue;
      const MjcfElement element(source, node, "");
      // Target of the actuator, which must exist.
      MjcfActuator actuator;
      actuator.name = element.text("name");
      actuator.joint = element.text("joint", element.text("jointinparent"));
      actuator.tendon = element.text("tendon");
      actuator.effort = effort_of(element, node.name());
      if (!actuator.joint.empty() && !has_joint(source, robot, node, actuator.joint)) continue;
      if (actuator.joint.empty() && find_named(tendons, actuator.tendon) == nullptr) {
        source.unread.note(node, fmt::format("<{}> '{}' drives no joint and no fixed tendon",
                                             node.name(), actuator.name));
        continue;
      }
      actuators.push_back(std::move(actuator));
    }
  return actuators;
}

}  // namespace thenar::internal
