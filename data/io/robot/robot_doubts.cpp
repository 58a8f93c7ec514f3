#include "data/io/robot/robot_doubts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/lists.h"
#include "base/units.h"
#include "base/words.h"

namespace thenar {
namespace {

constexpr double kMaxLength = 10;  // largest shape or offset; larger ones are in another unit [m]
// Largest travel of a slide from 0; that of a slide that carries the whole robot, a vehicle [m]
constexpr double kMaxTravel = 1, kMaxWay = 100;
constexpr double kMaxTurn = 4 * kPi;  // largest range of a hinge between its limits [rad]
constexpr double kFarAbove = 20;      // Ratio of a placeholder to the efforts of others [1]
// Least efforts of placeholders [N m], [N]
constexpr double kMinTorque = 100, kMinForce = 1000;

/// Longest side of a mesh, otherwise the largest size of a shape, such as a radius [m].
double across(const ShapeSpec& shape) {
  if (shape.kind != ShapeKind::kMesh) return shape.size.maxCoeff();
  return (shape.mesh.vertices.rowwise().maxCoeff() - shape.mesh.vertices.rowwise().minCoeff())
      .maxCoeff();
}

/// Shapes of implausible size, and joints far from their parents.
void doubt_sizes(const RobotSpec& robot, std::vector<std::string>& doubts) {
  // No link of a hand is longer than this, so larger numbers are most likely millimetres.
  for (const RobotLink& link : robot.links)
    for (const ShapeSpec& shape : link.shapes) {
      const double size = across(shape);
      if (!(size > kMaxLength)) continue;
      doubts.push_back(
          shape.kind == ShapeKind::kMesh
              ? fmt::format("a mesh of link '{}' is {:.4g} m across: are its numbers millimetres, "
                            "and its scale (0.001) not given?",
                            link.name, size)
              : fmt::format("a {} of link '{}' has a size of {:.4g} m: are its numbers "
                            "millimetres? Lengths are read as metres",
                            name_of(shape.kind), link.name, size));
    }
  for (const RobotJoint& joint : robot.joints)
    if (joint.X_PJ.p.norm() > kMaxLength)
      doubts.push_back(fmt::format(
          "joint '{}' lies {:.4g} m from its parent's frame: are its numbers millimetres? Lengths "
          "are read as metres",
          joint.name, joint.X_PJ.p.norm()));
}

/// Returns whether a joint carries every link that has shapes.
bool carries_all(const RobotSpec& robot, const RobotJoint& carrier) {
  std::set<std::string> carried{carrier.child};
  for (const RobotJoint& joint : robot.joints)
    if (carried.count(joint.parent) > 0) carried.insert(joint.child);
  return all_of(robot.links, [&](const RobotLink& link) {
    return link.shapes.empty() || carried.count(link.name) > 0;
  });
}

void doubt_joints(const RobotSpec& robot, std::vector<std::string>& doubts) {
  std::vector<std::string> stuck, far;
  double farthest = 0;
  for (const RobotJoint& joint : robot.joints) {
    const double range = joint.upper - joint.lower;
    if (joint.kind == RobotJointKind::kRevolute && range > kMaxTurn && std::isfinite(range))
      doubts.push_back(
          fmt::format("hinge '{}' turns by {:.4g} degrees: are its limits degrees? Angles are read "
                      "as radians",
                      joint.name, degrees(range)));
    const double travel = std::max(std::abs(joint.lower), std::abs(joint.upper));
    if (slides(joint) && travel > (carries_all(robot, joint) ? kMaxWay : kMaxTravel)) {
      far.push_back(joint.name);
      farthest = std::max(farthest, travel);
    }
    if (!joint.dof.empty() && range == 0) stuck.push_back(joint.name);
  }
  if (!far.empty())
    doubts.push_back(
        fmt::format("{} {} {:.4g} m: are {} limits millimetres? Lengths are read as metres",
                    quoted_list("joint", far), far.size() == 1 ? "slides by" : "slide by up to",
                    farthest, far.size() == 1 ? "its" : "their"));
  if (!stuck.empty())
    doubts.push_back(fmt::format("{} cannot move: the upper limit is the lower one",
                                 quoted_list("joint", stuck)));
}

/// Returns whether a text has a name as a word of its own.
bool names(const std::string& text, const std::string& name) {
  const auto part_of_word = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    if (!(at > 0 && part_of_word(at - 1)) && !part_of_word(at + name.size())) return true;
  return false;
}

/// Warns of efforts of 0 beside others.
void doubt_missing_efforts(RobotSpec& robot) {
  std::vector<std::string> missing;
  for (const RobotDof& dof : robot.dofs) {
    const bool said = any_of(robot.warnings, [&](const std::string& warning) {
      return warning.find("unknown") != std::string::npos && names(warning, dof.name);
    });
    if (dof.max_effort == 0 && !said) missing.push_back(dof.name);
  }
  if (!missing.empty())
    robot.warnings.push_back(fmt::format("{} {} no effort, unlike others: it is unknown",
                                         quoted_list("joint", missing),
                                         missing.size() == 1 ? "has" : "have"));
}

/// Joints of one kind, hinges or slides, whose efforts are equal, round, and far beyond the others.
std::vector<RobotDof*> far_above_others(RobotSpec& robot, bool sliding) {
  // Find the largest effort of this kind of joint, and the largest below it.
  double most = 0, next = 0;
  for (const RobotDof& dof : robot.dofs)
    if (slides(robot, dof) == sliding) most = std::max(most, dof.max_effort);
  std::vector<RobotDof*> above;
  for (RobotDof& dof : robot.dofs) {
    if (slides(robot, dof) != sliding) continue;
    if (dof.max_effort == most)
      above.push_back(&dof);
    else
      next = std::max(next, dof.max_effort);
  }
  // A placeholder is large, a multiple of ten, and far beyond what other joints state.
  const bool placeholder = most >= (sliding ? kMinForce : kMinTorque) && std::fmod(most, 10) == 0 &&
                           next > 0 && most >= kFarAbove * next;
  if (!placeholder || above.size() < 2) above.clear();
  return above;
}

/// Marks efforts as placeholders that are too large for any hand, and all the same or round, or the
/// same in several joints and far above those of the others.
void doubt_placeholders(RobotSpec& robot) {
  const auto all = [&](const auto& is) { return all_of(robot.dofs, is); };
  const bool large = all([&](const RobotDof& dof) {
    return dof.max_effort >= (slides(robot, dof) ? kMinForce : kMinTorque);
  });
  const double first = robot.dofs.front().max_effort;
  const bool equal = all([&](const RobotDof& dof) { return dof.max_effort == first; });
  const bool round = all([](const RobotDof& dof) { return std::fmod(dof.max_effort, 10) == 0; });
  if (large && (equal || round)) {
    double least = first;
    for (RobotDof& dof : robot.dofs) {
      dof.nominal_effort = true;
      least = std::min(least, dof.max_effort);
    }
    robot.warnings.push_back(fmt::format(
        "efforts of {:.4g} {}in all joints are treated as placeholders: they are unknown", least,
        equal ? "" : "and more "));
    return;
  }
  // Beside true values.
  for (const bool sliding : {false, true}) {
    std::vector<std::string> names;
    double effort = 0;
    for (RobotDof* dof : far_above_others(robot, sliding)) {
      dof->nominal_effort = true;
      effort = dof->max_effort;
      names.push_back(dof->name);
    }
    if (!names.empty())
      robot.warnings.push_back(
          fmt::format("efforts of {:.4g} at {}, far above all others, are treated as placeholders: "
                      "they are unknown",
                      effort, quoted_list("joint", names)));
  }
}

}  // namespace

std::vector<std::string> robot_doubts(const RobotSpec& robot) {
  std::vector<std::string> doubts;
  doubt_sizes(robot, doubts);
  doubt_joints(robot, doubts);
  return doubts;
}

std::vector<std::string> mass_doubts(const RobotSpec& robot) {
  // Links with shapes but without mass; the first link is the base, whose mass does not matter.
  std::vector<std::string> massless;
  bool any = false;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const RobotLink& link = robot.links[i];
    any = any || link.mass > 0;
    if (i > 0 && !(link.mass > 0) && !link.shapes.empty()) massless.push_back(link.name);
  }
  const bool moves = any_of(
      robot.joints, [](const RobotJoint& joint) { return joint.kind != RobotJointKind::kFixed; });
  if (!any && moves && !massless.empty())
    return {"no link has a mass: nothing tells how the robot moves, or how heavy it is"};
  if (!any || massless.empty()) return {};
  return {fmt::format("{} {} shapes and no mass", quoted_list("link", massless),
                      massless.size() == 1 ? "has" : "have")};
}

void doubt_efforts(RobotSpec& robot) {
  if (robot.dofs.empty()) return;
  if (all_of(robot.dofs, [](const RobotDof& dof) { return dof.max_effort == 0; })) {
    const bool said = any_of(robot.warnings, [](const std::string& w) {
      return w.find("unknown effort") != std::string::npos;
    });
    if (!said) robot.warnings.emplace_back("no joint has an effort: all are of unknown effort");
    return;
  }
  doubt_missing_efforts(robot);
  doubt_placeholders(robot);
}

}  // namespace thenar
