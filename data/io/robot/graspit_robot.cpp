#include "data/io/robot/graspit_robot.h"

#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/outside_path.h"
#include "data/io/graspit/graspit_link.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/robot/graspit_drives.h"
#include "data/io/robot/import_mesh.h"
#include "data/io/robot/import_xml.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using internal::UnreadElements;

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
      : file_(file), unread_(file), robot_(robot), drives_(file, unread_, robot) {}

  void run() {
    const pugi::xml_node top = file_.root();
    // The robot's name; some files state a class instead.
    robot_.name = top.attribute("type").value();
    if (robot_.name.empty() || robot_.name == "Hand" ||
        robot_.name == "Robot")  // classes, no names
      robot_.name = fs::path(file_.path()).stem();
    internal::note_others(unread_, top, {"palm", "dof", "chain", "approachDirection"});
    // The palm is the base; chains hang on it.
    const pugi::xml_node palm = top.child("palm");
    if (!palm) file_.fail(top, "wanted a <palm>");
    add_link(palm, "palm", "");
    for (const pugi::xml_node node : top.children("dof")) drives_.add_dof(node);
    for (const pugi::xml_node node : top.children("chain")) add_chain(node);
    drives_.settle();
    robot_.files.merge(meshes_.files());
    // Approach, and elements that were not read.
    const pugi::xml_node approach = top.child("approachDirection");
    robot_.approach_stated = !approach.child("direction").empty();
    if (approach) set_approach(approach);
    append_all(robot_.warnings, unread_.warnings());
  }

 private:
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
    append_all(robot_.warnings, body.warnings);
    if (body.geometry_file.empty()) return;
    ShapeSpec shape;
    const internal::MeshPlacement placement{body.geometry_scale * Eigen::Matrix3d::Identity(),
                                            {0, 0, 0}};
    shape.X_BS = body.X_LG;
    if (internal::try_mesh(shape, fs::absolute(body.geometry_file), placement,
                           {file_.path(), meshes_}, link.name, robot_.warnings))
      link.shapes.push_back(std::move(shape));
  }

  void add_chain(const pugi::xml_node& chain) {
    internal::note_others(unread_, chain, {"transform", "joint", "link"});
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
        attach(drives_.read_joint(joint), fmt::format("{} joint{}", label, ++index), child);
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

  void set_approach(const pugi::xml_node& node) {
    internal::note_others(unread_, node, {"referenceLocation", "direction"});
    if (const pugi::xml_node at = node.child("referenceLocation"))
      robot_.approach.point = kGraspitLength * file_.vector3(at);
    if (const pugi::xml_node along = node.child("direction")) {
      const Eigen::Vector3d direction = file_.vector3(along);
      if (direction.isZero(0)) file_.fail(along, "<direction> has no length");
      robot_.approach.direction = direction.normalized();
    }
  }

  const XmlFile& file_;
  UnreadElements unread_;
  RobotSpec& robot_;
  internal::GraspitDrives drives_;  // and the joints that they move
  std::set<std::string> names_;
  int chains_ = 0;
  std::string carrier_;     // link that carries the next joint
  Pose<double> X_carrier_;  // pose of the chain in the palm, until its first joint
  MeshReader meshes_;
};

}  // namespace

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
