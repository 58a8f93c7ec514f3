#include "data/io/robot/graspit_drives.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <regex>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/units.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/robot/import_couplings.h"

namespace thenar {
namespace {

constexpr std::size_t kLongestDrive = 200;  // largest number of letters of a drive

}  // namespace

GraspitDrive parse_graspit_drive(const std::string& text) {
  // Patterns: a plain number, or ratio * dK * ratio + offset.
  static const std::string number = R"(([0-9]+\.?[0-9]*(?:[eE][+-]?[0-9]+)?|\.[0-9]+))";
  static const std::regex driven(R"(\s*(?:([+-]?)\s*)" + number +
                                 R"(\s*\*\s*)?d([0-9]+)\s*(?:\*\s*([+-]?)\s*)" + number +
                                 R"()?\s*(?:(\+?)\s*([+-]?)\s*)" + number + R"()?\s*)");
  static const std::regex plain(R"(\s*([+-]?)\s*)" + number + R"(\s*)");
  std::smatch part;
  GraspitDrive drive;
  // Such expressions are matched by recursion, one step a letter.
  require(text.size() <= kLongestDrive, "wanted a number or 'dK*ratio+offset', got {} letters",
          text.size());
  const auto value = [&](std::size_t sign, std::size_t digits, double otherwise) {
    if (!part[digits].matched) return otherwise;
    return (part[sign] == "-" ? -1 : 1) * std::strtod(part[digits].str().c_str(), nullptr);
  };
  // A constant.
  if (std::regex_match(text, part, plain)) {
    drive.offset = value(1, 2, 0);
    return drive;
  }
  require(std::regex_match(text, part, driven) && part[3].length() < 6,
          "wanted a number or 'dK*ratio+offset', got '{}'", text);
  // A driven parameter: factors before and after dK multiply.
  drive.dof = std::stoi(part[3].str());
  drive.ratio = value(1, 2, 1) * value(4, 5, 1);
  drive.offset = value(7, 8, 0);
  // GraspIt! itself ignores an offset without '+'.
  require(!part[8].matched || part[6] == "+" || part[7] != "",
          "wanted '+' or '-' before the offset, got '{}'", text);
  drive.ignored = part[8].matched && part[6] != "+";
  return drive;
}

}  // namespace thenar

namespace thenar::internal {

void note_others(UnreadElements& unread, const pugi::xml_node& node,
                 const std::set<std::string>& read) {
  for (const pugi::xml_node child : node.children())
    if (child.type() == pugi::node_element && read.count(child.name()) == 0)
      unread.note(child, fmt::format("<{}> in <{}> is not read", child.name(), node.name()));
}

double GraspitDrives::number(const pugi::xml_node& parent, const char* name,
                             double otherwise) const {
  const pugi::xml_node node = parent.child(name);
  return node ? file_.numbers(node, 1)[0] : otherwise;
}

void GraspitDrives::add_dof(const pugi::xml_node& node) {
  note_others(unread_, node, {"defaultVelocity", "maxEffort", "breakAwayTorque"});
  RobotDof dof;
  dof.name = fmt::format("d{}", robot_.dofs.size());
  // The kind of coupling.
  const std::string type = node.attribute("type").as_string("r");
  if (type == "b") {
    dof.kind = DriveCoupling::kBreakaway;
    dof.breakaway = number(node, "breakAwayTorque", 0);
  } else if (type == "c") {
    dof.kind = DriveCoupling::kCompliant;
  } else if (type != "r") {
    file_.fail(node, fmt::format(R"(wanted <dof type="r", "b" or "c">, got '{}')", type));
  }
  // Speed and effort; limits follow from the joints.
  dof.speed = number(node, "defaultVelocity", 0);
  dof.max_effort = number(node, "maxEffort", 0);  // its unit depends on its joints
  dof.lower = -std::numeric_limits<double>::infinity();
  dof.upper = std::numeric_limits<double>::infinity();
  robot_.dofs.push_back(dof);
}

GraspitDrive GraspitDrives::drive(const pugi::xml_node& joint, const char* name) {
  const pugi::xml_node node = joint.child(name);
  // The driven parameter, or a constant.
  if (!node) file_.fail(joint, fmt::format("<joint> wants <{}>", name));
  try {
    const GraspitDrive drive = parse_graspit_drive(file_.text(node));
    if (drive.dof >= static_cast<int>(robot_.dofs.size()))
      file_.fail(node, fmt::format("'{}' names degree of freedom {} of {}", file_.text(node),
                                   drive.dof, robot_.dofs.size()));
    if (drive.ignored)
      unread_.note(
          node, fmt::format(
                    "'{}' has an offset without '+': read as it is, though GraspIt! itself takes 0",
                    file_.text(node)));
    return drive;
  } catch (const InputError& error) {
    file_.fail(node, error.what());
  }
}

RobotJoint GraspitDrives::read_joint(const pugi::xml_node& node) {
  note_others(unread_, node,
              {"theta", "d", "a", "alpha", "minValue", "maxValue", "viscousFriction",
               "CoulombFriction", "springStiffness", "restValue"});
  const std::string type = node.attribute("type").as_string("Revolute");
  if (type != "Revolute" && type != "Prismatic")
    file_.fail(node,
               fmt::format(R"(wanted <joint type="Revolute" or "Prismatic">, got '{}')", type));
  // Exactly one of theta and d may be driven.
  const bool turns = type == "Revolute";
  const GraspitDrive theta = drive(node, "theta"), d = drive(node, "d");
  const GraspitDrive& driven = turns ? theta : d;
  if ((turns ? d : theta).dof >= 0)
    file_.fail(node,
               fmt::format("only {} of a {} joint can be driven", turns ? "theta" : "d", type));
  // The four factors of Denavit and Hartenberg.
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  const Pose<double> turn{rotation_about<double>(z, theta.offset * kDegree), {0, 0, 0}};
  const Pose<double> along{Eigen::Matrix3d::Identity(), d.offset * kGraspitLength * z};
  const Pose<double> across{rotation_about<double>(x, number(node, "alpha", 0) * kDegree),
                            number(node, "a", 0) * kGraspitLength * x};
  // The motion lies between the factors before it and behind it.
  RobotJoint joint;
  joint.X_PJ = turns ? turn : turn * along;
  joint.X_JC = turns ? along * across : across;
  joint.kind = driven.dof < 0 ? RobotJointKind::kFixed
               : turns        ? RobotJointKind::kRevolute
                              : RobotJointKind::kPrismatic;
  if (driven.dof >= 0) set_drive(joint, node, driven, turns);
  return joint;
}

void GraspitDrives::set_drive(RobotJoint& joint, const pugi::xml_node& node,
                              const GraspitDrive& driven, bool turns) {
  // Units by the kind of joint.
  const double unit = turns ? kDegree : kGraspitLength;
  const double effort = turns ? kGraspitMoment : kGraspitForce / kGraspitLength;
  joint.dof = robot_.dofs[static_cast<std::size_t>(driven.dof)].name;
  joint.ratio = driven.ratio;
  if (joint.ratio == 0) file_.fail(node, "a joint cannot follow with ratio 0");
  for (const char* limit : {"minValue", "maxValue"})
    if (!node.child(limit)) file_.fail(node, fmt::format("<joint> wants <{}>", limit));
  // Limits hold for ratio * d, in either order.
  const double a = unit * number(node, "minValue", 0), b = unit * number(node, "maxValue", 0);
  joint.lower = std::min(a, b);
  joint.upper = std::max(a, b);
  joint.damping = effort * number(node, "viscousFriction", 0);
  joint.friction = (turns ? kGraspitMoment : kGraspitForce) * number(node, "CoulombFriction", 0);
  joint.stiffness = effort * number(node, "springStiffness", 0);
  joint.rest = unit * number(node, "restValue", 0);
}

void GraspitDrives::settle() {
  for (RobotDof& dof : robot_.dofs) {
    // Negative efforts are unknown.
    if (dof.max_effort < 0) {
      robot_.warnings.push_back(
          fmt::format("maxEffort of '{}' is {:.6g}: treated as unknown", dof.name, dof.max_effort));
      dof.max_effort = 0;
    }
    // The range is the intersection of the joints' ranges.
    bool turns = true, drives = false;
    for (const RobotJoint& joint : robot_.joints) {
      if (joint.dof != dof.name) continue;
      if (!drives) turns = joint.kind == RobotJointKind::kRevolute;
      drives = true;
      const JointRange range = range_through(joint);
      dof.lower = std::max(dof.lower, range.lower);
      dof.upper = std::min(dof.upper, range.upper);
    }
    // Units by the first joint.
    dof.max_effort *= turns ? kGraspitMoment : kGraspitForce;
    dof.nominal_effort = dof.max_effort > 0;  // the format's efforts are round placeholders
    if (!drives) {
      dof.lower = dof.upper = 0;
      robot_.warnings.push_back(fmt::format("'{}' drives no joint", dof.name));
    }
    if (dof.lower > dof.upper)
      throw DataError(
          file_.path(), 1,
          fmt::format("limits of the joints that '{}' drives leave no way to move", dof.name));
  }
}

}  // namespace thenar::internal
