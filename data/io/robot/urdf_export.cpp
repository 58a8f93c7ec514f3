#include "data/io/robot/urdf.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/file_io.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/urdf_losses.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

using internal::CouplingLine;
using internal::leader_of;
using internal::line_of;
using internal::losses_in_urdf;

/// A value of an attribute, in text.
struct AttributeText {
  AttributeText(const std::string& value) : text(value) {}         // NOLINT: converts
  AttributeText(double value) : text(fmt::format("{}", value)) {}  // NOLINT: converts
  AttributeText(const Eigen::Vector3d& v)                          // NOLINT: converts
      : text(fmt::format("{} {} {}", v.x(), v.y(), v.z())) {}

  std::string text;
};
using AttributeList = std::vector<std::pair<const char*, AttributeText>>;

/// Appends an element with attributes, and returns it.
pugi::xml_node append(pugi::xml_node& parent, const char* element,
                      const AttributeList& attributes) {
  pugi::xml_node node = parent.append_child(element);
  for (const auto& [name, value] : attributes) node.append_attribute(name) = value.text.c_str();
  return node;
}

void append_origin(pugi::xml_node& node, const Pose<double>& X) {
  append(node, "origin", {{"xyz", X.p}, {"rpy", roll_pitch_yaw(X.R)}});
}

void append_mass(pugi::xml_node& node, const RobotLink& link, const Pose<double>& X) {
  pugi::xml_node inertial = node.append_child("inertial");
  // About the centre of mass, in the axes of the URDF link.
  append_origin(inertial, {Eigen::Matrix3d::Identity(), X * link.com});
  append(inertial, "mass", {{"value", link.mass}});
  const Eigen::Matrix3d I = X.R * link.inertia * X.R.transpose();
  append(inertial, "inertia",
         {{"ixx", I(0, 0)},
          {"ixy", I(0, 1)},
          {"ixz", I(0, 2)},
          {"iyy", I(1, 1)},
          {"iyz", I(1, 2)},
          {"izz", I(2, 2)}});
}

/// Appends geometry of one shape, for contact and for display.
void append_geometry(pugi::xml_node& link, const Pose<double>& X, const char* shape,
                     const AttributeList& attributes) {
  for (const char* use : {"visual", "collision"}) {
    pugi::xml_node node = link.append_child(use);
    append_origin(node, X);
    pugi::xml_node geometry = node.append_child("geometry");
    append(geometry, shape, attributes);
  }
}

void append_sphere(pugi::xml_node& link, const Pose<double>& X, double radius) {
  append_geometry(link, X, "sphere", {{"radius", radius}});
}

void append_cylinder(pugi::xml_node& link, const Pose<double>& X, double radius, double length) {
  append_geometry(link, X, "cylinder", {{"radius", radius}, {"length", length}});
}

void append_mesh(pugi::xml_node& link, const Pose<double>& X, const std::string& file,
                 double scale) {
  const Eigen::Vector3d scales = Eigen::Vector3d::Constant(scale);
  append_geometry(link, X, "mesh", {{"filename", file}, {"scale", scales}});
}

/// The text of a comment, which must not contain "--".
std::string comment(std::string text) {
  for (std::size_t at; (at = text.find("--")) != std::string::npos;) text.replace(at, 2, "- -");
  return " " + text + " ";
}

/// Writes one robot.
class Export {
 public:
  Export(const RobotSpec& robot, std::string mesh_prefix)
      : robot_(robot), prefix_(std::move(mesh_prefix)) {}

  UrdfText run() {
    pugi::xml_document document;
    // Links and joints.
    pugi::xml_node top = document.append_child("robot");
    top.append_attribute("name") = robot_.name.c_str();
    out_.warnings = losses_in_urdf(robot_);
    for (const RobotLink& link : robot_.links) append_link(top, link);
    for (const RobotJoint& joint : robot_.joints) append_joint(top, joint);
    // Warnings as comments at the top.
    for (auto warning = out_.warnings.rbegin(); warning != out_.warnings.rend(); ++warning)
      top.prepend_child(pugi::node_comment).set_value(comment(*warning).c_str());
    std::ostringstream text;
    document.save(text, "  ");
    out_.text = text.str();
    return std::move(out_);
  }

 private:
  /// Pose of the link's frame in that of its URDF link.
  // NOLINTNEXTLINE(readability-identifier-naming): a pose, with its frames
  [[nodiscard]] Pose<double> X_UL(const std::string& link) const {
    for (const RobotJoint& joint : robot_.joints)
      if (joint.child == link) return joint.X_JC;
    return {};
  }

  void append_link(pugi::xml_node& top, const RobotLink& link) {
    pugi::xml_node node = append(top, "link", {{"name", link.name}});
    const Pose<double> X = X_UL(link.name);
    if (link.mass > 0) append_mass(node, link, X);
    for (const ShapeSpec& shape : link.shapes) append_shape(node, shape, X * shape.X_BS, link.name);
  }

  void append_shape(pugi::xml_node& link, const ShapeSpec& shape, const Pose<double>& X,
                    const std::string& name) {
    const Eigen::Vector3d& s = shape.size;
    // Primitives that URDF has.
    if (shape.kind == ShapeKind::kSphere) {
      append_sphere(link, X, s.x());
    } else if (shape.kind == ShapeKind::kBox) {
      append_geometry(link, X, "box", {{"size", s}});
    } else if (shape.kind == ShapeKind::kCylinder) {
      append_cylinder(link, X, s.x(), s.y());
      // A capsule becomes a cylinder and two spheres.
    } else if (shape.kind == ShapeKind::kCapsule) {
      append_cylinder(link, X, s.x(), s.y());
      for (const double z : {-s.y() / 2, s.y() / 2})
        append_sphere(link, {X.R, X * Eigen::Vector3d(0, 0, z)}, s.x());
      // Meshes by name; everything else as a new mesh.
    } else if (shape.kind == ShapeKind::kMesh && !shape.mesh_file.empty()) {
      append_mesh(link, X, shape.mesh_file, shape.mesh_scale);
    } else {
      append_mesh(link, X, written_mesh(shape, name), 1);
    }
  }

  /// Adds a mesh to be written. @returns the name of its file
  std::string written_mesh(ShapeSpec shape, const std::string& link) {
    const std::string file =
        plain_file_name(fmt::format("{}{}_{}.obj", prefix_, link, out_.meshes.size()));
    if (shape.kind == ShapeKind::kMesh) {
      out_.meshes[file] = shape.mesh;
    } else {
      shape.X_BS = {};
      out_.meshes[file] = build_solid({shape}).visual;
      out_.warnings.push_back(fmt::format("URDF has no {}: one of link '{}' is written as a mesh",
                                          name_of(shape.kind), link));
    }
    return file;
  }

  void append_joint(pugi::xml_node& top, const RobotJoint& joint) {
    // Names, kind and frames.
    pugi::xml_node node =
        append(top, "joint", {{"name", joint.name}, {"type", name_of(joint.kind)}});
    append_origin(node, X_UL(joint.parent) * joint.X_PJ);
    append(node, "parent", {{"link", joint.parent}});
    append(node, "child", {{"link", joint.child}});
    if (joint.kind == RobotJointKind::kFixed) return;
    // Axis, limits and passive torques.
    append(node, "axis", {{"xyz", joint.axis}});
    append_limit(node, joint);
    if (joint.damping != 0 || joint.friction != 0)
      append(node, "dynamics", {{"damping", joint.damping}, {"friction", joint.friction}});
    if (!joint.dof.empty()) append_mimic(node, joint);
  }

  /// Limits: those of its motor for a leading joint, within its own.
  void append_limit(pugi::xml_node& node, const RobotJoint& joint) const {
    double effort = 0, velocity = 0, lower = joint.lower, upper = joint.upper;
    for (const RobotDof& dof : robot_.dofs)
      if (dof.name == joint.dof) {
        velocity = std::abs(dof.speed * joint.ratio);
        if (&leader_of(robot_, dof.name) != &joint) continue;
        effort = dof.max_effort / std::abs(joint.ratio);
        const double a = joint_value(joint, dof.lower), b = joint_value(joint, dof.upper);
        lower = std::max(lower, std::min(a, b));
        upper = std::min(upper, std::max(a, b));
      }
    append(node, "limit",
           {{"lower", lower}, {"upper", upper}, {"effort", effort}, {"velocity", velocity}});
  }

  /// Mimics the leader: v = r q + b and v_0 = r_0 q + b_0 give v = (r / r_0) v_0 + b - (r / r_0)
  /// b_0.
  void append_mimic(pugi::xml_node& node, const RobotJoint& joint) const {
    const RobotJoint& first = leader_of(robot_, joint.dof);
    if (&first == &joint) return;
    const CouplingLine line = line_of(robot_, joint);
    const double ratio = line.ratio / first.ratio;
    append(node, "mimic",
           {{"joint", first.name},
            {"multiplier", ratio},
            {"offset", line.offset - ratio * first.offset}});
  }

  const RobotSpec& robot_;
  std::string prefix_;
  UrdfText out_;
};

}  // namespace

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& R) {
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  // Undoing yaw leaves a rotation about x, also where pitch makes yaw arbitrary.
  const double y1 = std::cos(yaw) * R(1, 1) - std::sin(yaw) * R(0, 1);
  const double y2 = std::cos(yaw) * R(1, 2) - std::sin(yaw) * R(0, 2);
  return {std::atan2(-y2, y1), pitch, yaw};
}

UrdfText robot_urdf(const RobotSpec& robot, const std::string& mesh_prefix) {
  check_robot(robot);
  return Export(robot, mesh_prefix).run();
}

std::vector<std::string> write_urdf(const std::string& path, const RobotSpec& robot) {
  const std::filesystem::path file(path);
  const UrdfText urdf = robot_urdf(robot, file.stem().string() + "_");
  std::vector<std::pair<std::string, std::string>> files;
  // Meshes beside the file, in the format of their ending.
  for (const auto& [name, mesh] : urdf.meshes) {
    const std::string mesh_path = (file.parent_path() / name).string();
    files.emplace_back(mesh_path, mesh_bytes(mesh_path, mesh));
  }
  files.emplace_back(path, urdf.text);  // last, as it names the others
  write_files(files);
  return urdf.warnings;
}

}  // namespace thenar
