#include "data/io/world/graspit_world.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/outside_path.h"
#include "base/progress_parts.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/robot/import_robot.h"
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_posture.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// Last link of chain n of a robot, from 0. @returns empty if it has no such chain
std::string end_of_chain(const RobotSpec& robot, int n) {
  const std::string beginning = fmt::format("chain{} ", n + 1);
  std::string last;
  for (const RobotLink& link : robot.links)
    if (link.name.rfind(beginning, 0) == 0) last = link.name;
  return last;
}

/// A world that is being read.
class WorldReader {
 public:
  explicit WorldReader(const std::string& path) : file_(path) {
    file_.settle_case(
        "world graspableBody obstacle robot connection camera filename transform translation "
        "rotation rotationMatrix fullTransform dofValues parentRobot parentChain childRobot "
        "position orientation focalDistance");
    if (std::string(file_.root().name()) != "world")
      file_.fail(file_.root(), fmt::format("wanted <world>, got <{}>", file_.root().name()));
    read_.world.name = fs::path(path).stem().string();
    read_.world.source = "File";
    read_.world.own_sources = {{"File", "Imported from the GraspIt! world " + path}};
  }

  GraspitWorld read() {
    // Bodies, robots, connections and camera, in the file's order.
    for (const pugi::xml_node& node : file_.root().children()) {
      const std::string name = node.name();
      if (node.type() != pugi::node_element) continue;
      if (name == "graspableBody" || name == "obstacle")
        add_body(node, name == "graspableBody");
      else if (name == "robot")
        add_robot(node);
      else if (name == "connection")
        add_connection(node);
      else if (name == "camera")
        read_camera(node);
      else
        not_understood(node);
    }
    read_.warnings = internal::by_severity(read_.warnings);
    return std::move(read_);
  }

 private:
  void not_understood(const pugi::xml_node& node) {
    read_.warnings.push_back(file_.not_understood(node));
  }

  void warn(const pugi::xml_node& node, const std::string& what) {
    read_.warnings.push_back(fmt::format("{}:{}: {}", file_.path(), file_.line(node), what));
  }

  /// Warns of elements in `node` that are not in `known`.
  void check(const pugi::xml_node& node, const std::vector<std::string>& known) {
    for (const pugi::xml_node& child : node.children())
      if (child.type() == pugi::node_element && !contains(known, child.name()))
        not_understood(child);
  }

  /// The <filename> of an element, absolute; searched beside the world and in the folders above.
  /// @returns nothing if there is no such file, with a warning
  std::optional<std::string> named_file(const pugi::xml_node& node, const char* what) {
    const pugi::xml_node name = node.child("filename");
    if (!name) file_.fail(node, fmt::format("<{}> needs a <filename>", node.name()));
    std::string written = file_.text(name);
    std::replace(written.begin(), written.end(), '\\', '/');
    // The folder of the world, then every folder above it.
    const fs::path start = fs::absolute(file_.path()).parent_path();
    for (fs::path folder = start; !outside_fault(written, OutsideUse::kRead);
         folder = folder.parent_path()) {
      const std::string path = (folder / written).lexically_normal().string();
      if (may_link(start.string(), path) && is_file(path)) return path;
      if (folder == folder.parent_path()) break;
    }
    warn(name, fmt::format("MISSING {} '{}': there is no such file; it is left out", what,
                           file_.text(name)));
    return {};
  }

  /// A name that is not taken: "mug", then "mug_2"..
  template <typename Taken>
  static std::string new_name(const std::string& name, const Taken& taken) {
    std::string candidate = name;
    for (int i = 2; taken(candidate); ++i) candidate = fmt::format("{}_{}", name, i);
    return candidate;
  }

  void append(const std::string& path, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
      read_.warnings.push_back(fs::path(path).filename().string() + ": " + warning);
  }

  void add_body(const pugi::xml_node& node, bool dynamic) {
    check(node, {"filename", "transform"});
    const std::optional<std::string> path = named_file(node, "BODY");
    if (!path) return;
    GraspitBody found = read_graspit_body(*path, meshes_);
    // Names of bodies are unique.
    auto& bodies = read_.world.bodies;
    found.body.name = new_name(found.body.name, [&](const std::string& name) {
      return any_of(bodies, [&](const PlacedBody& other) { return other.body.name == name; });
    });
    auto& warnings = read_.warnings;
    append_all(warnings, found.warnings);
    bodies.push_back(
        {std::move(found.body), "", graspit_transform(file_, node, warnings), dynamic});
  }

  /// The robot of a file. @returns nothing if it cannot be read, with a warning
  std::optional<RobotSpec> read_robot_file(const pugi::xml_node& node, const std::string& path) {
    try {
      RobotSpec robot = import_robot(path);
      append(path, robot.warnings);
      return robot;
    } catch (const Stopped&) {
      throw;
    } catch (const Error& error) {
      warn(node.child("filename"), fmt::format("UNREADABLE ROBOT, left out: {}", error.what()));
      return {};
    }
  }

  void add_robot(const pugi::xml_node& node) {
    check(node, {"filename", "transform", "dofValues"});
    robots_.emplace_back();  // connections also count robots that are left out
    const std::optional<std::string> path = named_file(node, "ROBOT");
    if (!path) return;
    std::optional<RobotSpec> robot = read_robot_file(node, *path);
    if (!robot) return;
    // A hand with a unique name at its pose.
    PlacedHand hand;
    hand.file = *path;
    auto& hands = read_.world.hands;
    hand.name = new_name(fs::path(hand.file).stem().string(), [&](const std::string& name) {
      return find_named(hands, name) != nullptr;
    });
    hand.X_WH = graspit_transform(file_, node, read_.warnings);
    // Posture by the robot's degrees of freedom.
    if (const pugi::xml_node values = node.child("dofValues")) {
      GraspitPosture posture = graspit_posture(*robot, file_.numbers(values));
      hand.posture = std::move(posture.values);
      for (const std::string& warning : posture.warnings)
        warn(values, fmt::format("robot '{}': {}", hand.name, warning));
    }
    // Remember it for connections.
    robots_.back() = {std::move(*robot), hands.size()};
    hands.push_back(std::move(hand));
  }

  int whole_number(const pugi::xml_node& node, const char* name, int below) const {
    const pugi::xml_node child = node.child(name);
    if (!child) file_.fail(node, fmt::format("<connection> needs a <{}>", name));
    const double number = file_.numbers(child, 1)[0];
    if (number < 0 || number >= below || number != static_cast<int>(number))
      file_.fail(child, fmt::format("wanted <{}> in 0..{}, got {}", name, below - 1, number));
    return static_cast<int>(number);
  }

  void add_connection(const pugi::xml_node& node) {
    check(node, {"parentRobot", "parentChain", "childRobot", "transform"});
    const int count = static_cast<int>(robots_.size());
    // Which robot carries which, and on which chain.
    const int parent = whole_number(node, "parentRobot", count);
    const int child = whole_number(node, "childRobot", count);
    const int chain = whole_number(node, "parentChain", kMaxChains);
    if (parent == child) file_.fail(node, "a robot cannot carry itself");
    // A connection needs both robots.
    const std::optional<Placed>& carrier = robots_[parent];
    const std::optional<Placed>& carried = robots_[child];
    if (!carrier || !carried)
      return warn(node, fmt::format("robot {} carries robot {}, one of which is left out: so is "
                                    "the <connection>",
                                    parent, child));
    const std::string link = end_of_chain(carrier->robot, chain);
    if (link.empty())
      file_.fail(node.child("parentChain"), fmt::format("robot {} has no chain {}", parent, chain));
    auto& hands = read_.world.hands;
    // Robots must not carry each other in a circle.
    for (std::size_t up = carrier->hand; !hands[up].carrier.empty();
         up = index_of(hands[up].carrier))
      if (index_of(hands[up].carrier) == carried->hand)
        file_.fail(node, fmt::format("robot {} carries robot {} already", child, parent));
    // The carried hand stands on the carrier's last link.
    PlacedHand& hand = hands[carried->hand];
    hand.carrier = hands[carrier->hand].name;
    hand.carrier_link = link;
    hand.X_WH = graspit_transform(file_, node, read_.warnings);
  }

  /// @param name  of an existing hand
  [[nodiscard]] std::size_t index_of(const std::string& name) const {
    return static_cast<std::size_t>(place_named(read_.world.hands, name));
  }

  void read_camera(const pugi::xml_node& node) {
    check(node, {"position", "orientation", "focalDistance"});
    const pugi::xml_node position = node.child("position"), turn = node.child("orientation");
    if (!position || !turn) file_.fail(node, "<camera> needs a <position> and an <orientation>");
    // Position, and orientation as x y z w.
    const Eigen::Vector3d p = file_.vector3(position);
    const std::vector<double> q = file_.numbers(turn, 4);  // x y z w
    const Eigen::Quaterniond R(q[3], q[0], q[1], q[2]);
    const pugi::xml_node focus = node.child("focalDistance");
    const double distance = focus ? file_.numbers(focus, 1)[0] : kDefaultFocus;
    if (!(R.norm() > 0) || !(distance > 0))
      return warn(node, "the camera looks nowhere and was left out");
    Camera& camera = read_.world.camera;
    // It looks along -z to the focal distance.
    camera.eye = kGraspitLength * p;
    camera.target = camera.eye + R.normalized() * Eigen::Vector3d(0, 0, -kGraspitLength * distance);
  }

  static constexpr double kDefaultFocus = 1000;  // Focal distance without a stated one [mm]
  static constexpr int kMaxChains = 1000;        // Upper bound of a chain's number
  /// A robot, and the index of its hand in the world.
  struct Placed {
    RobotSpec robot;
    std::size_t hand;
  };

  XmlFile file_;
  MeshReader meshes_;
  GraspitWorld read_;
  std::vector<std::optional<Placed>> robots_;  // in the file's order; nothing: left out
};

}  // namespace

GraspitWorld read_graspit_world(const std::string& path) { return WorldReader(path).read(); }

}  // namespace thenar
