#include "data/io/robot/import_robot.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/words.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/robot/graspit_robot.h"
#include "data/io/robot/mjcf_parts.h"
#include "data/io/robot/robot_doubts.h"
#include "data/io/robot/urdf.h"
#include "data/io/toml_node.h"

namespace thenar {
namespace {

/// Kind of a robot file by its root element and the children of <robot>.
RobotFileKind kind_of_xml(const XmlFile& file) {
  const pugi::xml_node root = file.root();
  const std::string name = root.name();
  if (name == "mujoco" || name == "mujocoinclude") return RobotFileKind::kMjcf;
  if (name == "robot") {
    for (const char* part : {"palm", "chain", "dof", "DOF"})
      if (!root.child(part).empty()) return RobotFileKind::kGraspit;
    return RobotFileKind::kUrdf;
  }
  if (name == "sdf")
    file.fail(
        root,
        "SDF is not read; wanted the URDF that it was made of, or MJCF. (gz sdf -p makes SDF of "
        "URDF, nothing makes URDF of it)");
  file.fail(root, fmt::format("wanted <robot> (URDF, GraspIt!) or <mujoco>, got <{}>", name));
}

RobotSpec read_kind(const std::string& path, RobotFileKind kind) {
  if (kind == RobotFileKind::kUrdf) return read_urdf(path);
  if (kind == RobotFileKind::kMjcf) return read_mjcf(path);
  if (kind == RobotFileKind::kGraspit) return read_graspit_robot(path);
  return read_robot(path);
}

/// The nearest inertia with principal moments >= 0, the largest at most the sum of the others.
Eigen::Matrix3d bodily(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
      Eigen::Matrix3d((inertia + inertia.transpose()) / 2));
  Eigen::Vector3d moments = axes.eigenvalues().cwiseMax(0);
  moments[2] = std::min(moments[2], moments[0] + moments[1]);
  return axes.eigenvectors() * moments.asDiagonal() * axes.eigenvectors().transpose();
}

void mend_inertias(RobotSpec& robot) {
  for (RobotLink& link : robot.links)
    if (!is_body_inertia(link.inertia)) {
      const Eigen::Matrix3d mended = bodily(link.inertia);
      robot.warnings.push_back(
          fmt::format("inertia of link '{}' is that of no rigid body: reduced by {:.3g} kg m^2",
                      link.name, (mended - link.inertia).norm()));
      link.inertia = mended;
    }
}

bool holds(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

bool contains_warning(const std::vector<std::string>& warnings, const std::string& doubt) {
  return any_of(warnings, [&](const std::string& warning) {
    return warning.compare(0, doubt.size(), doubt) == 0;
  });
}

bool is_serious(const std::string& warning) {
  const auto has = [&](const char* words) { return holds(warning, words); };
  return has("MISSING") || has("UNREADABLE") || has("INCOMPLETE") || has("LEFT OUT") ||
         has("millimetres") || has("are its limits degrees") || has("cannot move");
}

bool names_missing_part(const std::string& warning) { return holds(warning, "MISSING"); }

RobotFileKind find_robot_kind(const std::string& path) {
  const std::string text = read_text_file(path);
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".cfg" || ending == ".wld")
    throw DataError(path, 1,
                    fmt::format("GraspIt!'s older text format {} is not read; GraspIt! 2.1 and "
                                "later write XML",
                                ending));
  if (first_sign(text) == '<') return kind_of_xml(XmlFile(text, path));
  return RobotFileKind::kToml;
}

RobotSpec import_robot(const std::string& path) {
  // Read by kind, then make the robot usable.
  const RobotFileKind kind = find_robot_kind(path);
  RobotSpec robot = read_kind(path, kind);
  robot.files.merge(digests_of({path}));
  if (robot.name.empty()) robot.name = std::filesystem::path(path).stem();
  mend_inertias(robot);
  if (kind == RobotFileKind::kUrdf || kind == RobotFileKind::kMjcf) doubt_efforts(robot);
  for (RobotLink& link : robot.links)
    repair_shapes(link.shapes, fmt::format("link '{}'", link.name), robot.warnings);
  const std::vector<std::string> said = robot.warnings;
  std::vector<std::string> doubts = robot_doubts(robot);
  if (kind != RobotFileKind::kToml) append_all(doubts, mass_doubts(robot));
  for (std::string& doubt : doubts)
    if (!contains_warning(said, doubt)) robot.warnings.push_back(std::move(doubt));
  robot.warnings = internal::by_severity(robot.warnings);
  // What remains wrong is an error of the file.
  at_line(path, 1, [&] { check_robot(robot); });
  return robot;
}

}  // namespace thenar

namespace thenar::internal {
namespace {

int weight(const std::string& warning) {
  if (is_serious(warning)) return 0;
  for (const char* light : {"is not read", "is not understood", "is not heeded"})
    if (warning.find(light) != std::string::npos) return 2;
  return 1;
}

}  // namespace

std::vector<std::string> by_severity(const std::vector<std::string>& warnings) {
  // Each warning once, with its number of occurrences.
  std::vector<std::string> once;
  std::map<std::string, int> times;
  for (const std::string& warning : warnings)
    if (++times[warning] == 1) once.push_back(warning);
  std::stable_sort(once.begin(), once.end(), [](const std::string& a, const std::string& b) {
    return weight(a) < weight(b);
  });
  for (std::string& warning : once)
    if (const int count = times.at(warning); count > 1)
      warning += fmt::format(" ({} times)", count);
  return once;
}

}  // namespace thenar::internal
