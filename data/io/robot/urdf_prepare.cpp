#include "data/io/robot/urdf.h"

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/words.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/robot/robot.h"

namespace thenar::internal {
namespace {

/// An attribute that must be a list of numbers.
struct NumberList {
  const char* element;
  const char* attribute;
  std::size_t count;
};

constexpr NumberList kNumbers[] = {
    {"origin", "xyz", 3},        {"origin", "rpy", 3},       {"axis", "xyz", 3},
    {"box", "size", 3},          {"cylinder", "radius", 1},  {"cylinder", "length", 1},
    {"capsule", "radius", 1},    {"capsule", "length", 1},   {"sphere", "radius", 1},
    {"mass", "value", 1},        {"inertia", "ixx", 1},      {"inertia", "ixy", 1},
    {"inertia", "ixz", 1},       {"inertia", "iyy", 1},      {"inertia", "iyz", 1},
    {"inertia", "izz", 1},       {"limit", "lower", 1},      {"limit", "upper", 1},
    {"limit", "effort", 1},      {"limit", "velocity", 1},   {"dynamics", "damping", 1},
    {"dynamics", "friction", 1}, {"mimic", "multiplier", 1}, {"mimic", "offset", 1}};

/// Children of an element that are read; all others are noted and removed.
const std::map<std::string, std::set<std::string>> kRead{
    {"robot", {"link", "joint"}},
    {"link", {"inertial", "visual", "collision"}},
    {"joint", {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"}},
    {"inertial", {"origin", "mass", "inertia"}},
    {"visual", {"origin", "geometry"}},
    {"collision", {"origin", "geometry"}},
    {"geometry", {"box", "cylinder", "sphere", "mesh", "capsule"}}};

void refuse_xacro_at(const XmlFile& file, const pugi::xml_node& node) {
  // Macros and expressions are xacro.
  if (std::string(node.name()).rfind("xacro:", 0) == 0)
    file.fail(node, fmt::format("<{}> is a xacro macro; expand it first: xacro IN > OUT.urdf",
                                node.name()));
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string value = attribute.value();
    if (value.find("${") != std::string::npos || value.find("$(") != std::string::npos)
      file.fail(
          node,
          fmt::format("'{}' is a xacro expression; expand it first: xacro IN > OUT.urdf", value));
  }
}

void refuse_xacro(const XmlFile& file, const pugi::xml_node& top) {
  for (pugi::xml_node node = top; node; node = next_below(top, node))
    if (node.type() == pugi::node_element) refuse_xacro_at(file, node);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the file
void take_out_unread(UnreadElements& unread, pugi::xml_node node) {
  const auto read = kRead.find(node.name());
  if (read == kRead.end()) return;
  // Children that are read may have others that are not.
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() != pugi::node_element) {
      node.remove_child(child);
    } else if (read->second.count(child.name()) == 0) {
      unread.note(child, fmt::format("<{}> in <{}> is not read", child.name(), node.name()));
      node.remove_child(child);
    } else {
      take_out_unread(unread, child);
    }
    child = next;
  }
}

void check_numbers_at(const XmlFile& file, const pugi::xml_node& node) {
  for (const NumberList& numbers : kNumbers) {
    const pugi::xml_attribute attribute = node.attribute(numbers.attribute);
    // The right number of numbers.
    if (std::string(node.name()) != numbers.element || !attribute) continue;
    const std::string what = fmt::format("<{}> {}", node.name(), numbers.attribute);
    const std::size_t got = parse_numbers(file, node, attribute.value(), what).size();
    if (got != numbers.count)
      file.fail(node, fmt::format("{} wants {} number{}, got '{}'", what, numbers.count,
                                  numbers.count == 1 ? "" : "s", attribute.value()));
  }
}

void check_numbers(const XmlFile& file, const pugi::xml_node& top) {
  for (pugi::xml_node node = top; node; node = next_below(top, node)) check_numbers_at(file, node);
}

void set_default(pugi::xml_node node, const char* attribute, const char* value) {
  if (!node.attribute(attribute)) node.append_attribute(attribute) = value;
}

/// Normalises the scale of a mesh: one factor means three, commas are spaces.
void settle_mesh(const XmlFile& file, pugi::xml_node mesh) {
  (void)required_text(file, mesh, "filename");
  pugi::xml_attribute scale = mesh.attribute("scale");
  if (!scale) return;
  const std::vector<double> factors = parse_numbers(file, mesh, scale.value(), "<mesh> scale");
  if (factors.size() != 1 && factors.size() != 3)
    file.fail(mesh, fmt::format("<mesh> scale wants 3 numbers, got '{}'", scale.value()));
  const double x = factors[0], y = factors[factors.size() / 2], z = factors.back();
  scale = fmt::format("{:.17g} {:.17g} {:.17g}", x, y, z).c_str();
}

/// Removes shapes without geometry, and gives capsules a name that urdfdom accepts.
void settle_shapes(const XmlFile& file, UnreadElements& unread, pugi::xml_node link) {
  for (pugi::xml_node part = link.first_child(); part;) {
    const pugi::xml_node next = part.next_sibling(), geometry = part.child("geometry");
    const bool is_shape = std::string(part.name()) != "inertial";
    // A shape without geometry.
    if (is_shape && !geometry.first_child()) {
      unread.note(part, fmt::format("<{}> of link '{}' has no shape that is read", part.name(),
                                    link.attribute("name").value()));
      link.remove_child(part);
    }
    if (const pugi::xml_node mesh = geometry.child("mesh")) settle_mesh(file, mesh);
    // A capsule in the guise of a mesh.
    if (pugi::xml_node capsule = geometry.child("capsule")) {
      const std::string size =
          fmt::format("{}{} {}", kCapsule, required_text(file, capsule, "radius"),
                      required_text(file, capsule, "length"));
      capsule.set_name("mesh");
      capsule.append_attribute("filename") = size.c_str();
    }
    part = next;
  }
}

void settle_link(const XmlFile& file, UnreadElements& unread, pugi::xml_node link) {
  (void)required_text(file, link, "name");
  settle_shapes(file, unread, link);
  pugi::xml_node inertial = link.child("inertial");
  if (!inertial) return;
  // Mass is needed; a missing inertia is that of a point.
  if (!inertial.child("mass")) file.fail(inertial, "<inertial> wants <mass value=\"..\">");
  pugi::xml_node inertia = inertial.child("inertia");
  if (!inertia) {
    unread.note(inertial, "<inertial> without <inertia>: taken as a point mass");
    inertia = inertial.append_child("inertia");
  }
  for (const char* entry : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"})
    set_default(inertia, entry, "0");
}

/// Notes joints of a type that have no limits, all at once.
void note_unlimited(UnreadElements& unread, pugi::xml_node robot, const std::string& type,
                    const std::string& taken, const std::string& all_taken) {
  std::vector<std::string> names;
  pugi::xml_node first;
  for (const pugi::xml_node joint : robot.children("joint")) {
    if (joint.attribute("type").value() != type || joint.child("limit")) continue;
    if (names.empty()) first = joint;
    names.emplace_back(joint.attribute("name").value());
  }
  if (!names.empty())
    unread.note(first, fmt::format("{} {} no <limit>: {}", quoted_list(type + " joint", names),
                                   names.size() == 1 ? "has" : "have",
                                   names.size() == 1 ? taken : all_taken));
}

void settle_limits(pugi::xml_node joint) {
  const std::string type = joint.attribute("type").value();
  pugi::xml_node limit = joint.child("limit");
  // Missing limits: a continuous joint, or one that stays.
  if (!limit && type == "revolute") joint.attribute("type") = "continuous";
  if (!limit && type == "prismatic") {
    if (!joint.child("mimic").empty())
      limit = joint.append_child("limit");  // widened by its coupling
    else
      joint.attribute("type") = "fixed";
  }
  if (!limit) return;
  set_default(limit, "effort", "0");
  set_default(limit, "velocity", "0");
}

void settle_joint(const XmlFile& file, pugi::xml_node joint, const std::set<std::string>& links) {
  const std::string name = required_text(file, joint, "name");
  const std::string type = required_text(file, joint, "type");
  // Known type, and ends that exist.
  static const std::set<std::string> types{"revolute", "continuous", "prismatic",
                                           "fixed",    "floating",   "planar"};
  if (types.count(type) == 0)
    file.fail(joint, fmt::format("joint '{}' is of unknown type '{}'", name, type));
  for (const char* end : {"parent", "child"}) {
    const pugi::xml_node node = joint.child(end);
    if (!node) file.fail(joint, fmt::format("joint '{}' wants <{} link=\"..\"/>", name, end));
    const std::string link = required_text(file, node, "link");
    if (links.count(link) == 0)
      file.fail(node,
                fmt::format("joint '{}' has {} '{}', and there is no such link", name, end, link));
  }
  // An axis needs a direction.
  if (const pugi::xml_node axis = joint.child("axis");
      axis && type != "fixed" && type != "floating")
    if (parse_vector3(file, axis, axis.attribute("xyz").value(), "<axis> xyz").isZero(0))
      file.fail(axis, fmt::format("axis of joint '{}' has no length", name));
  settle_limits(joint);
}

/// Names of one kind of element, each of which may occur once.
std::set<std::string> unique_names(const XmlFile& file, pugi::xml_node robot, const char* kind) {
  std::set<std::string> names;
  for (const pugi::xml_node node : robot.children(kind))
    if (!names.insert(required_text(file, node, "name")).second)
      file.fail(node, fmt::format("there are two {}s '{}'", kind, node.attribute("name").value()));
  return names;
}

void require_one_parent(const XmlFile& file, pugi::xml_node robot) {
  std::set<std::string> children;
  for (const pugi::xml_node joint : robot.children("joint")) {
    const std::string child = joint.child("child").attribute("link").value();
    if (!children.insert(child).second)
      file.fail(joint,
                fmt::format("link '{}' is the child of two joints; a URDF is a tree", child));
  }
}

}  // namespace

std::string prepare_urdf(const XmlFile& file, UnreadElements& unread) {
  pugi::xml_node robot = file.root();
  if (std::string(robot.name()) != "robot") file.fail(robot, "wanted <robot name=\"..\">");
  // Refuse xacro, and remove what is not read.
  refuse_xacro(file, robot);
  take_out_unread(unread, robot);
  check_numbers(file, robot);
  // Names are unique, and links few enough.
  const std::set<std::string> links = unique_names(file, robot, "link");
  if (links.empty()) file.fail(robot, "<robot> has no <link>");
  if (links.size() > kMaxLinks)
    file.fail(robot, fmt::format("wanted at most {} links, got {}", kMaxLinks, links.size()));
  (void)unique_names(file, robot, "joint");
  // Each element in the form that urdfdom accepts.
  for (const pugi::xml_node link : robot.children("link")) settle_link(file, unread, link);
  note_unlimited(unread, robot, "revolute", "taken as continuous", "taken as continuous");
  note_unlimited(unread, robot, "prismatic", "it stays at zero", "they stay at zero");
  for (const pugi::xml_node joint : robot.children("joint")) settle_joint(file, joint, links);
  require_one_parent(file, robot);
  if (*robot.attribute("name").value() == 0) {  // urdfdom needs a name
    robot.remove_attribute("name");
    robot.append_attribute("name") = std::filesystem::path(file.path()).stem().c_str();
  }
  robot.remove_attribute("version");
  std::ostringstream out;
  robot.print(out, "", pugi::format_raw);
  return out.str();
}

}  // namespace thenar::internal
