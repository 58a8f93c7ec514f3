#include "data/io/robot/mjcf_parts.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "data/io/robot/link_poses.h"

namespace thenar::internal {
namespace {

/// Link poses in the file's own posture, in which joints are at `ref`.
std::vector<Pose<double>> file_posture(RobotSpec robot, const std::vector<double>& ref) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) robot.joints[i].offset = ref[i];
  return link_poses(robot, {});
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the file
pugi::xml_node find_site(const pugi::xml_node& under, const std::string& name) {
  for (const pugi::xml_node child : under.children()) {
    if (std::string(child.name()) == "site" && name == child.attribute("name").value())
      return child;
    if (const pugi::xml_node found = find_site(child, name)) return found;
  }
  return {};
}

/// Reads one loop closure.
class Reader {
 public:
  Reader(const MjcfSource& source, const pugi::xml_node& node, const RobotSpec& robot,
         const std::vector<double>& ref)
      : source_(source), node_(node), robot_(robot), X_(file_posture(robot, ref)) {}

  std::optional<LoopClosure> read() {
    LoopClosure loop;
    loop.welded = std::string(node_.name()) == "weld";
    const bool sites = !node_.attribute("site1").empty() || !node_.attribute("site2").empty();
    const bool found = sites ? at_sites(loop) : at_bodies(loop);
    if (!found) return {};
    loop.words = fmt::format("<{}> of '{}' and '{}'", node_.name(), loop.a, loop.b);
    return loop;
  }

 private:
  /// Index of a body's link; the base for the world. Nothing if the body was left out.
  [[nodiscard]] std::optional<std::size_t> link_of(const std::string& body) {
    if (body.empty() || body == "world") return 0;
    for (std::size_t i = 0; i < robot_.links.size(); ++i)
      if (robot_.links[i].name == body) return i;
    const std::string what =
        fmt::format("<{}> names body '{}', and there is no such body", node_.name(), body);
    if (!source_.incomplete) source_.file.fail(node_, what);
    source_.unread.note(node_, what + ": it is left out");
    return {};
  }

  bool at_bodies(LoopClosure& loop) {
    const MjcfElement equality(source_, node_, "");
    const auto a = link_of(required_text(source_.file, node_, "body1")),
               b = link_of(node_.attribute("body2").value());
    if (!a || !b) return false;
    loop.a = robot_.links[*a].name;
    loop.b = robot_.links[*b].name;
    // Both bodies in the file's own posture.
    const Pose<double> X_AB = X_[*a].inverse() * X_[*b];
    // A ball joint at the anchor.
    if (!loop.welded) {
      if (!equality.has("anchor")) source_.file.fail(node_, "<connect> wants anchor=\"x y z\"");
      loop.X_A.p = equality.vector3("anchor", Eigen::Vector3d::Zero());
      loop.X_B.p = X_AB.inverse() * loop.X_A.p;
      return true;
    }
    // A weld in this posture, unless another pose is stated.
    loop.X_A = X_AB;
    const std::vector<double> pose = equality.numbers("relpose");
    if (pose.size() != 7) return true;
    const Eigen::Quaterniond q(pose[3], pose[4], pose[5], pose[6]);
    if (q.norm() > 0) loop.X_A = {q.normalized().toRotationMatrix(), {pose[0], pose[1], pose[2]}};
    return true;
  }

  bool at_sites(LoopClosure& loop) {
    return at_site("site1", loop.a, loop.X_A) && at_site("site2", loop.b, loop.X_B);
  }

  bool at_site(const char* attribute, std::string& link, Pose<double>& X) {
    const std::string name = required_text(source_.file, node_, attribute);
    const pugi::xml_node site = find_site(source_.file.root().child("worldbody"), name);
    if (!site) source_.file.fail(node_, fmt::format("there is no site '{}'", name));
    // Pose of the site in its body, through all frames around it.
    X = MjcfElement(source_, site, "").pose();
    pugi::xml_node around = site.parent();
    for (; std::string(around.name()) == "frame"; around = around.parent())
      X = MjcfElement(source_, around, "").pose() * X;
    const auto index =
        link_of(std::string(around.name()) == "body" ? around.attribute("name").value() : "");
    if (!index) return false;
    link = robot_.links[*index].name;
    return true;
  }

  const MjcfSource& source_;
  const pugi::xml_node& node_;
  const RobotSpec& robot_;
  std::vector<Pose<double>> X_;  // of links in the file's posture
};

}  // namespace

std::optional<LoopClosure> read_loop(const MjcfSource& source, const pugi::xml_node& node,
                                     const RobotSpec& robot, const std::vector<double>& ref) {
  return Reader(source, node, robot, ref).read();
}

}  // namespace thenar::internal
