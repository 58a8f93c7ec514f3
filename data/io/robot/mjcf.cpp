#include "data/io/robot/mjcf_parts.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "base/words.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/mjcf_source.h"

namespace thenar {
namespace {

using internal::MjcfElement;
using internal::MjcfGeom;
using internal::MjcfSource;
using internal::UnreadElements;

/// An element of a body, with the frame (<frame>) and the class around it.
struct Part {
  pugi::xml_node node;
  Pose<double> X_BF;
  std::string childclass;
};

constexpr double kUnknownTravel = 1;  // Travel of a slide without limits, in both directions [m]

/// Translates the tree of bodies: links, joints, shapes and masses.
class BodyTree {
 public:
  BodyTree(const MjcfSource& source, RobotSpec& robot)
      : source_(source), meshes_(internal::find_meshes(source)), robot_(robot) {}

  void run() {
    // The world is the first link, and carries the bodies.
    std::vector<Part> parts;
    for (const pugi::xml_node world : source_.file.root().children("worldbody"))
      collect(world, {}, "", parts);
    if (parts.empty()) source_.file.fail(source_.file.root(), "the model has no body");
    names_.insert("world");
    RobotLink world;
    world.name = "world";
    fill(world, parts);
    robot_.links.push_back(world);
    // Bodies depth first.
    for (const Part& part : parts)
      if (is(part, "body")) add_body(part, "world");
    // A world that adds nothing is dropped.
    drop_idle_world();
    if (!shown_.empty())
      robot_.warnings.push_back(
          fmt::format("geoms that do not collide stand for the missing collision geoms of {}",
                      fmt::join(shown_, ", ")));
    name_endless(endless_hinges_, kPi, "rad");
    name_endless(endless_slides_, kUnknownTravel, "m");
  }

  [[nodiscard]] const std::vector<double>& ref() const { return ref_; }

 private:
  static bool is(const Part& part, const char* name) {
    return std::string(part.node.name()) == name;
  }

  /// Collects the elements of a body, those inside a <frame> with its pose.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as frames nest
  void collect(const pugi::xml_node& body, const Pose<double>& X_BF, const std::string& childclass,
               std::vector<Part>& parts) {
    for (const pugi::xml_node node : body.children()) {
      const std::string name = node.name();
      // Frames are transparent.
      if (name == "frame") {
        collect(node, X_BF * MjcfElement(source_, node, childclass).pose(),
                node.attribute("childclass").as_string(childclass.c_str()), parts);
      } else if (name == "body" || name == "joint" || name == "freejoint" || name == "geom" ||
                 name == "inertial") {
        parts.push_back({node, X_BF, childclass});
        // Elements that make bodies which are not read.
      } else if (internal::makes_bodies(node)) {
        source_.unread.note(node,
                            fmt::format("INCOMPLETE: <{}> is not read, its bodies are missing; "
                                        "MuJoCo itself can save the model written out",
                                        name));
      } else if (node.type() == pugi::node_element) {
        source_.unread.note(node, fmt::format("<{}> in a body is not read", name));
      }
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as bodies nest
  void add_body(const Part& part, const std::string& parent) {
    if (robot_.links.size() >= kMaxLinks)
      source_.file.fail(part.node, fmt::format("wanted at most {} bodies, got more", kMaxLinks));
    const std::string childclass =
        part.node.attribute("childclass").as_string(part.childclass.c_str());
    // The link, with shapes and mass from its elements.
    RobotLink link;
    link.name =
        internal::add_unique_name(names_, part.node.attribute("name").value(), parent + " body");
    std::vector<Part> parts;
    collect(part.node, {}, childclass, parts);
    fill(link, parts);
    // Its pose in the parent, then its joints and children.
    const Pose<double> X_PB = part.X_BF * MjcfElement(source_, part.node, part.childclass).pose();
    if (part.node.attribute("mocap").as_bool())
      source_.unread.note(part.node, fmt::format("mocap body '{}' is taken as fixed", link.name));
    const std::string name = link.name;
    robot_.links.push_back(std::move(link));
    connect(name, parent, X_PB, parts);
    for (const Part& child : parts)
      if (is(child, "body")) add_body(child, name);
  }

  void fill(RobotLink& link, const std::vector<Part>& parts) {
    std::vector<MassProperties> masses;
    std::vector<ShapeSpec> shown;
    const MjcfSource& source = source_;
    // Geoms give shape and mass; those that do not collide serve if no others do.
    for (const Part& part : parts) {
      if (!is(part, "geom")) continue;
      MjcfGeom geom = internal::read_geom(source, meshes_, {source, part.node, part.childclass},
                                          part.X_BF, link.name, robot_.warnings);
      masses.push_back(geom.mass);
      if (geom.shape) (geom.collides ? link.shapes : shown).push_back(std::move(*geom.shape));
    }
    if (link.shapes.empty() && !shown.empty()) {
      link.shapes = std::move(shown);
      shown_.push_back(link.name);
    }
    if (link.name != "world") set_mass(link, parts, masses);
  }

  void set_mass(RobotLink& link, const std::vector<Part>& parts,
                const std::vector<MassProperties>& masses) {
    const auto inertial = std::find_if(parts.begin(), parts.end(),
                                       [](const Part& part) { return is(part, "inertial"); });
    std::optional<internal::MjcfInertial> stated;
    if (inertial != parts.end() && source_.compiler.inertia_from_geom != "true")
      stated = {MjcfElement(source_, inertial->node, inertial->childclass), inertial->X_BF};
    const MassProperties mass = internal::mass_of_body(source_.compiler, stated, masses);
    link.mass = mass.mass;
    link.com = mass.centre;
    link.inertia = mass.inertia;
  }

  void connect(const std::string& name, const std::string& parent, const Pose<double>& X_PB,
               const std::vector<Part>& parts) {
    // Only hinges and slides are read as joints.
    std::vector<Part> joints;
    for (const Part& part : parts) {
      if (is(part, "freejoint")) name_free(part, name, "free");
      if (!is(part, "joint")) continue;
      const std::string type =
          MjcfElement(source_, part.node, part.childclass).text("type", "hinge");
      if (type == "hinge" || type == "slide") {
        joints.push_back(part);
      } else {
        name_free(part, name, type);
      }
    }
    // A body without joints is fixed to its parent.
    if (joints.empty()) {
      RobotJoint fixed;
      fixed.name = internal::add_unique_name(joint_names_, "", name + " mount");
      fixed.kind = RobotJointKind::kFixed;
      fixed.parent = parent;
      fixed.child = name;
      fixed.X_PJ = X_PB;
      add(fixed, 0);
    }
    // Several joints need links without mass between them.
    std::string carrier = parent;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const bool last = i + 1 == joints.size();
      const std::string child =
          last ? name
               : internal::add_unique_name(names_, "", fmt::format("{} after {}", name, i + 1));
      if (!last) {
        RobotLink between;
        between.name = child;
        robot_.links.push_back(between);
      }
      add_joint(joints[i], carrier, child, i == 0 ? X_PB : Pose<double>{}, name);
      carrier = child;
    }
  }

  void name_free(const Part& part, const std::string& body, const std::string& type) {
    source_.unread.note(part.node,
                        fmt::format("{} joint of body '{}' is taken as fixed", type, body));
  }

  void add_joint(const Part& part, const std::string& parent, const std::string& child,
                 const Pose<double>& X_PB, const std::string& body) {
    const MjcfElement element(source_, part.node, part.childclass);
    // Names and kind.
    RobotJoint joint;
    joint.name = internal::add_unique_name(joint_names_, element.text("name"), body + " joint");
    joint.parent = parent;
    joint.child = child;
    const bool hinge = element.text("type", "hinge") == "hinge";
    joint.kind = hinge ? RobotJointKind::kRevolute : RobotJointKind::kPrismatic;
    // Axis and anchor in the frame of the body.
    const Eigen::Vector3d axis = element.vector3("axis", Eigen::Vector3d::UnitZ());
    if (axis.isZero(0)) element.fail(fmt::format("axis of joint '{}' has no length", joint.name));
    joint.axis = part.X_BF.R * axis.normalized();
    const Eigen::Vector3d at = part.X_BF * element.vector3("pos", Eigen::Vector3d::Zero());
    const double unit = hinge ? source_.compiler.angle : 1;
    const double ref = unit * element.number("ref", 0);
    // In the file's own posture the joint has the value `ref`.
    joint.X_PJ = X_PB * Pose<double>{Eigen::Matrix3d::Identity(), at} * joint_motion(joint, -ref);
    joint.X_JC = {Eigen::Matrix3d::Identity(), -at};
    set_limits(joint, element, unit);
    // Passive torques.
    joint.damping = element.number("damping", 0);
    joint.friction = element.number("frictionloss", 0);
    joint.stiffness = element.number("stiffness", 0);
    joint.rest = unit * element.number("springref", 0);
    if (element.has("actuatorfrcrange") && element.text("actuatorfrclimited") != "false")
      source_.unread.note(part.node,
                          "actuatorfrcrange of joints is not read: efforts are those of actuators");
    add(joint, ref);
  }

  void set_limits(RobotJoint& joint, const MjcfElement& element, double unit) {
    const std::vector<double> range = element.numbers("range");
    const std::string limited = element.text("limited", "auto");
    // Limits as stated, by MuJoCo's rules.
    const bool has_limits =
        limited == "true" || (limited == "auto" && source_.compiler.auto_limits && !range.empty());
    if (has_limits) {
      if (range.size() != 2)
        element.fail(fmt::format("range of joint '{}' wants two numbers", joint.name));
      joint.lower = unit * std::min(range[0], range[1]);
      joint.upper = unit * std::max(range[0], range[1]);
      return;
    }
    // Without limits: one turn, or a metre.
    joint.upper = joint.kind == RobotJointKind::kRevolute ? kPi : kUnknownTravel;
    joint.lower = -joint.upper;
    (joint.kind == RobotJointKind::kRevolute ? endless_hinges_ : endless_slides_)
        .push_back(joint.name);
  }

  /// Warns of joints without limits, all of a kind at once.
  void name_endless(const std::vector<std::string>& names, double upper, const char* unit) {
    if (names.empty()) return;
    const bool alone = names.size() == 1;
    robot_.warnings.push_back(fmt::format("{} {} no limits; {} {:.6g} to {:.6g} {}",
                                          quoted_list("joint", names), alone ? "has" : "have",
                                          alone ? "it gets" : "they get", -upper, upper, unit));
  }

  void add(const RobotJoint& joint, double ref) {
    robot_.joints.push_back(joint);
    ref_.push_back(ref);
  }

  /// Drops a world link without shapes that carries a single body fixed at its origin.
  void drop_idle_world() {
    const auto on_world = [](const RobotJoint& joint) { return joint.parent == "world"; };
    const bool alone = std::count_if(robot_.joints.begin(), robot_.joints.end(), on_world) == 1;
    const RobotJoint& first = robot_.joints.front();
    if (!alone || !robot_.links.front().shapes.empty() || first.kind != RobotJointKind::kFixed ||
        !first.X_PJ.R.isIdentity(0) || !first.X_PJ.p.isZero(0))
      return;
    robot_.links.erase(robot_.links.begin());
    robot_.joints.erase(robot_.joints.begin());
    ref_.erase(ref_.begin());
  }

  const MjcfSource& source_;
  internal::MjcfMeshes meshes_;
  RobotSpec& robot_;
  std::vector<double> ref_;  // value of each joint in the file's posture [rad] or [m]
  std::set<std::string> names_, joint_names_;
  std::vector<std::string> endless_hinges_, endless_slides_;  // joints without limits
  std::vector<std::string> shown_;  // links with geoms that do not collide, only
};

void note_sections(const XmlFile& file, UnreadElements& unread) {
  static const std::set<std::string> read{"compiler", "default",  "asset",   "worldbody",
                                          "tendon",   "equality", "actuator"};
  for (const pugi::xml_node node : file.root().children())
    if (node.type() == pugi::node_element && read.count(node.name()) == 0)
      unread.note(node, fmt::format("<{}> is not read", node.name()));
}

void set_total_mass(RobotSpec& robot, double wanted) {
  double sum = 0;
  for (const RobotLink& link : robot.links) sum += link.mass;
  if (!(wanted > 0) || !(sum > 0)) return;
  for (RobotLink& link : robot.links) {
    link.mass *= wanted / sum;
    link.inertia *= wanted / sum;
  }
}

}  // namespace

RobotSpec read_mjcf(const std::string& path) {
  const XmlFile file(path);
  const std::string root = file.root().name();
  if (root != "mujoco" && root != "mujocoinclude")
    file.fail(file.root(), fmt::format("wanted <mujoco>, got <{}>", root));
  // Included files and copies first, then the rest of the file.
  const std::vector<std::string> parts = internal::expand_includes(file);
  internal::expand_replicates(file);
  UnreadElements unread(file);
  note_sections(file, unread);
  MeshReader meshes;
  // Settings that hold for the whole file.
  MjcfSource source{file, unread, internal::read_compiler(file, unread), {}, false, meshes};
  source.incomplete = internal::lacks_joints(file.root());
  source.defaults.read(file, file.root());
  // Bodies, then drives of their joints.
  RobotSpec robot;
  robot.name = file.root().attribute("model").value();
  robot.closing_stated = robot.approach_stated = false;
  BodyTree tree(source, robot);
  tree.run();
  set_total_mass(robot, source.compiler.total_mass);
  internal::drive_mjcf(source, tree.ref(), robot);
  robot.files = digests_of(parts);
  robot.files.merge(meshes.files());
  // Elements that were not read.
  append_all(robot.warnings, unread.warnings());
  return robot;
}

}  // namespace thenar
