#include "data/io/robot/graspit_robot.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/outside_path.h"
#include "base/units.h"
#include "data/io/graspit/graspit_link.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/import_mesh.h"
#include "data/io/robot/import_xml.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using internal::JointRange;
using internal::UnreadElements;

constexpr std::size_t kLongestDrive = 200;  // largest number of letters of a drive

/// Number of joints of its chain that a link uses.
const std::map<std::string, int> kJointsOfLink{
    {"Fixed", 0}, {"Revolute", 1}, {"Prismatic", 1}, {"Universal", 2}, {"Ball", 3}};

/// Names of elements; files differ in their case: <DOF>, <coulombFriction>.
const std::string kElements =
    "robot palm dof chain joint link theta d a alpha minValue maxValue transform translation "
    "rotation rotationMatrix fullTransform maxEffort defaultVelocity breakAwayTorque "
    "viscousFriction CoulombFriction springStiffness restValue approachDirection "
    "referenceLocation direction";

/// Translates a GraspIt! robot, element by element.
class GraspitTranslation {
 public:
  GraspitTranslation(const XmlFile& file, RobotSpec& robot)
      : file_(file), unread_(file), robot_(robot) {}

  void run() {
    const pugi::xml_node top = file_.root();
    // The robot's name; some files state a class instead.
    robot_.name = top.attribute("type").value();
    if (robot_.name.empty() || robot_.name == "Hand" ||
        robot_.name == "Robot")  // classes, no names
      robot_.name = fs::path(file_.path()).stem();
    note_others(top, {"palm", "dof", "chain", "approachDirection"});
    // The palm is the base; chains hang on it.
    const pugi::xml_node palm = top.child("palm");
    if (!palm) file_.fail(top, "wanted a <palm>");
    add_link(palm, "palm", "");
    for (const pugi::xml_node node : top.children("dof")) add_dof(node);
    for (const pugi::xml_node node : top.children("chain")) add_chain(node);
    settle_dofs();
    robot_.files.merge(meshes_.files());
    // Approach, and elements that were not read.
    const pugi::xml_node approach = top.child("approachDirection");
    robot_.approach_stated = !approach.child("direction").empty();
    if (approach) set_approach(approach);
    const std::vector<std::string> warnings = unread_.warnings();
    robot_.warnings.insert(robot_.warnings.end(), warnings.begin(), warnings.end());
  }

 private:
  void note_others(const pugi::xml_node& node, const std::set<std::string>& read) {
    for (const pugi::xml_node child : node.children())
      if (child.type() == pugi::node_element && read.count(child.name()) == 0)
        unread_.note(child, fmt::format("<{}> in <{}> is not read", child.name(), node.name()));
  }

  [[nodiscard]] double number(const pugi::xml_node& parent, const char* name,
                              double otherwise) const {
    const pugi::xml_node node = parent.child(name);
    return node ? file_.numbers(node, 1)[0] : otherwise;
  }

  [[nodiscard]] std::string find_body(const std::string& name) const {
    if (outside_fault(name, OutsideUse::kRead)) return "";
    const fs::path folder = fs::path(file_.path()).parent_path();
    // GraspIt! keeps bodies in a folder of their own.
    for (const fs::path& path : {folder / "iv" / name, folder / name})
      if (may_link(folder.string(), path.string()) && is_file(path)) return path.string();
    return "";
  }

  std::string add_link(const pugi::xml_node& node, const std::string& name,
                       const std::string& digit) {
    RobotLink link;
    link.name = internal::add_unique_name(names_, name);
    link.digit = digit;
    // A missing body is a link without shape and mass.
    const std::string written = file_.text(node), path = find_body(written);
    if (path.empty()) {
      robot_.warnings.push_back(fmt::format(
          "MISSING BODY '{}': link '{}' goes without shape and mass", written, link.name));
    } else {
      fill(link, read_graspit_link(path));
      robot_.files.merge(digests_of({path}));
    }
    robot_.links.push_back(link);
    return link.name;
  }

  void fill(RobotLink& link, const GraspitLink& body) {
    // Material and mass, then the shape.
    link.material = body.material;
    link.mass = body.mass;
    link.com = body.com;
    if (body.inertia) link.inertia = *body.inertia;
    robot_.warnings.insert(robot_.warnings.end(), body.warnings.begin(), body.warnings.end());
    if (body.geometry_file.empty()) return;
    ShapeSpec shape;
    const internal::MeshPlacement placement{body.geometry_scale * Eigen::Matrix3d::Identity(),
                                            {0, 0, 0}};
    shape.X_BS = body.X_LG;
    if (internal::try_mesh(shape, fs::absolute(body.geometry_file), placement,
                           {file_.path(), meshes_}, link.name, robot_.warnings))
      link.shapes.push_back(std::move(shape));
  }

  void add_dof(const pugi::xml_node& node) {
    note_others(node, {"defaultVelocity", "maxEffort", "breakAwayTorque"});
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

  void settle_dofs() {
    for (RobotDof& dof : robot_.dofs) {
      // Negative efforts are unknown.
      if (dof.max_effort < 0) {
        robot_.warnings.push_back(fmt::format("maxEffort of '{}' is {:.6g}: taken for unknown",
                                              dof.name, dof.max_effort));
        dof.max_effort = 0;
      }
      // The range is the intersection of the joints' ranges.
      bool turns = true, drives = false;
      for (const RobotJoint& joint : robot_.joints) {
        if (joint.dof != dof.name) continue;
        if (!drives) turns = joint.kind == RobotJointKind::kRevolute;
        drives = true;
        const JointRange range = internal::range_through(joint);
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

  void add_chain(const pugi::xml_node& chain) {
    note_others(chain, {"transform", "joint", "link"});
    // With several chains each is a finger.
    const int number_of_chain = ++chains_;
    const bool fingers = static_cast<bool>(file_.root().child("chain").next_sibling("chain"));
    const std::string label = fmt::format("chain{}", number_of_chain);
    const std::string digit = fingers ? fmt::format("finger {}", number_of_chain) : "";
    // The chain starts on the palm.
    carrier_ = robot_.links.front().name;
    X_carrier_ = graspit_transform(file_, chain.child("transform"), robot_.warnings);

    pugi::xml_node joint = chain.child("joint");
    int index = 0;
    // Each link takes its joints from the list of the chain.
    for (const pugi::xml_node link : chain.children("link")) {
      const int wanted = joints_of(link);
      const std::string stem = fs::path(file_.text(link)).stem();
      const std::string name = add_link(link, fmt::format("{} {}", label, stem), digit);
      if (wanted == 0) add_fixed(fmt::format("{} mount", name), name);
      for (int i = 1; i <= wanted; ++i) {
        // Joints of several axes get links without mass between them.
        if (!joint) file_.fail(link, "its chain has no joint left for this link");
        const std::string child = i == wanted ? name : add_between(name, i, digit);
        add_joint(joint, fmt::format("{} joint{}", label, ++index), child);
        joint = joint.next_sibling("joint");
      }
    }
    for (; joint; joint = joint.next_sibling("joint"))
      unread_.note(joint, "<joint> that carries no link is left out");
  }

  [[nodiscard]] int joints_of(const pugi::xml_node& link) const {
    const std::string type = link.attribute("dynamicJointType").as_string("Revolute");
    const auto found = kJointsOfLink.find(type);
    if (found == kJointsOfLink.end())
      file_.fail(link, fmt::format("unknown dynamicJointType '{}'", type));
    return found->second;
  }

  std::string add_between(const std::string& name, int i, const std::string& digit) {
    RobotLink link;
    link.name = internal::add_unique_name(names_, fmt::format("{} after {}", name, i));
    link.digit = digit;
    robot_.links.push_back(link);
    return link.name;
  }

  void attach(RobotJoint joint, const std::string& name, const std::string& child) {
    joint.name = name;
    joint.parent = carrier_;
    joint.child = child;
    joint.X_PJ = X_carrier_ * joint.X_PJ;
    robot_.joints.push_back(joint);
    carrier_ = child;
    X_carrier_ = {};
  }

  void add_fixed(const std::string& name, const std::string& child) {
    RobotJoint joint;
    joint.kind = RobotJointKind::kFixed;
    attach(joint, name, child);
  }

  [[nodiscard]] GraspitDrive drive(const pugi::xml_node& joint, const char* name) {
    const pugi::xml_node node = joint.child(name);
    // The driven parameter, or a constant.
    if (!node) file_.fail(joint, fmt::format("<joint> wants <{}>", name));
    try {
      const GraspitDrive drive = parse_graspit_drive(file_.text(node));
      if (drive.dof >= static_cast<int>(robot_.dofs.size()))
        file_.fail(node, fmt::format("'{}' names degree of freedom {} of {}", file_.text(node),
                                     drive.dof, robot_.dofs.size()));
      if (drive.ignored)
        unread_.note(node, fmt::format("'{}' has an offset without '+': read as it stands, though "
                                       "GraspIt! itself takes 0",
                                       file_.text(node)));
      return drive;
    } catch (const InputError& error) {
      file_.fail(node, error.what());
    }
  }

  /// Joint with frame Rz(theta) Tz(d) Tx(a) Rx(alpha), of which theta or d is driven.
  void add_joint(const pugi::xml_node& node, const std::string& name, const std::string& child) {
    note_others(node, {"theta", "d", "a", "alpha", "minValue", "maxValue", "viscousFriction",
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
    attach(joint, name, child);
  }

  void set_drive(RobotJoint& joint, const pugi::xml_node& node, const GraspitDrive& driven,
                 bool turns) {
    // Units by the kind of joint.
    const double unit = turns ? kDegree : kGraspitLength;
    const double effort = turns ? kGraspitMoment : kGraspitForce / kGraspitLength;
    joint.dof = robot_.dofs[driven.dof].name;
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

  void set_approach(const pugi::xml_node& node) {
    note_others(node, {"referenceLocation", "direction"});
    if (const pugi::xml_node at = node.child("referenceLocation")) {
      const std::vector<double> v = file_.numbers(at, 3);
      robot_.approach.point = kGraspitLength * Eigen::Vector3d(v[0], v[1], v[2]);
    }
    if (const pugi::xml_node along = node.child("direction")) {
      const std::vector<double> v = file_.numbers(along, 3);
      const Eigen::Vector3d direction(v[0], v[1], v[2]);
      if (direction.isZero(0)) file_.fail(along, "<direction> has no length");
      robot_.approach.direction = direction.normalized();
    }
  }

  const XmlFile& file_;
  UnreadElements unread_;
  RobotSpec& robot_;
  std::set<std::string> names_;
  int chains_ = 0;
  std::string carrier_;     // link that carries the next joint
  Pose<double> X_carrier_;  // pose of the chain in the palm, until its first joint
  MeshReader meshes_;
};

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

RobotSpec read_graspit_robot(const std::string& path) {
  XmlFile file(path);
  file.settle_case(kElements);
  if (std::string(file.root().name()) != "robot")
    file.fail(file.root(), "wanted <robot type=\"..\">");
  RobotSpec robot;
  GraspitTranslation(file, robot).run();
  return robot;
}

}  // namespace thenar
