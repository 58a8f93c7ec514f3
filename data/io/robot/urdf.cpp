#include "data/io/robot/urdf.h"

#include <mutex>
#include <sstream>

#include <console_bridge/console.h>
#include <fmt/ranges.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/units.h"
#include "base/words.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/import_mesh.h"

namespace thenar {
namespace {

using internal::FollowerCoupling;
using internal::UnreadElements;

/// Collects what urdfdom logs during its life, instead of the standard error.
class Listener : public console_bridge::OutputHandler {
 public:
  Listener() : lock_(mutex()) { console_bridge::useOutputHandler(this); }
  ~Listener() override { console_bridge::restorePreviousOutputHandler(); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/,
           int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) heard.push_back(text);
  }

  std::vector<std::string> heard;

 private:
  static std::mutex& mutex() {  // the whole program has one handler
    static std::mutex one;
    return one;
  }
  std::lock_guard<std::mutex> lock_;
};

urdf::ModelInterfaceSharedPtr parse(const std::string& text, const XmlFile& file,
                                    std::vector<std::string>& warnings) {
  Listener listener;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  if (!model)
    throw DataError(file.path(), file.line(file.root()),
                    listener.heard.empty() ? "urdfdom cannot read it" : listener.heard.front());
  for (const std::string& text_heard : listener.heard) warnings.push_back("urdfdom: " + text_heard);
  return model;
}

Eigen::Vector3d vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose<double> pose_of(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return {Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix(),
          vector_of(pose.position)};
}

void set_mass(RobotLink& link, const urdf::Inertial& inertial) {
  const Pose<double> X_LI = pose_of(inertial.origin);
  Eigen::Matrix3d I;
  I << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,   //
      inertial.ixz, inertial.iyz, inertial.izz;
  link.mass = inertial.mass;
  link.com = X_LI.p;
  link.inertia = X_LI.R * I * X_LI.R.transpose();
}

/// Translates a model of urdfdom.
class UrdfTranslation {
 public:
  UrdfTranslation(const urdf::ModelInterface& model, const XmlFile& file, RobotSpec& robot)
      : model_(model), file_(file), robot_(robot) {}

  void run() {
    const pugi::xml_node top = file_.root();
    // In the order of the file, which urdfdom does not keep.
    for (const pugi::xml_node node : top.children("link"))
      add_link(*model_.links_.at(node.attribute("name").value()));
    for (const pugi::xml_node node : top.children("joint"))
      add_joint(*model_.joints_.at(node.attribute("name").value()), node);
    // Order and couplings.
    internal::order_tree(robot_, file_.path());
    internal::couple_joints(robot_, couplings_, file_.path());
    for (RobotDof& dof : robot_.dofs) set_motor(dof);
    if (!shown_.empty())
      robot_.warnings.push_back(fmt::format(
          "visual shapes stand for the missing collision shapes of {}", fmt::join(shown_, ", ")));
    if (!endless_.empty())
      robot_.warnings.push_back(fmt::format("{} {} one turn, -pi to pi",
                                            quoted_list("continuous joint", endless_),
                                            endless_.size() == 1 ? "gets" : "get"));
    robot_.files.merge(meshes_.files());
  }

 private:
  void add_link(const urdf::Link& link) {
    RobotLink ours;
    ours.name = link.name;
    if (link.inertial) set_mass(ours, *link.inertial);
    // Collision shapes, otherwise visual ones.
    for (const auto& collision : link.collision_array)
      add_shape(ours, *collision->geometry, pose_of(collision->origin));
    if (link.collision_array.empty() && !link.visual_array.empty()) {
      shown_.push_back(link.name);
      for (const auto& visual : link.visual_array)
        add_shape(ours, *visual->geometry, pose_of(visual->origin));
    }
    robot_.links.push_back(std::move(ours));
  }

  void add_shape(RobotLink& link, const urdf::Geometry& geometry, const Pose<double>& X_LS) {
    ShapeSpec shape;
    shape.X_BS = X_LS;
    if (geometry.type == urdf::Geometry::SPHERE) {
      shape.kind = ShapeKind::kSphere;
      shape.size.x() = dynamic_cast<const urdf::Sphere&>(geometry).radius;
    } else if (geometry.type == urdf::Geometry::BOX) {
      shape.kind = ShapeKind::kBox;
      shape.size = vector_of(dynamic_cast<const urdf::Box&>(geometry).dim);
    } else if (geometry.type == urdf::Geometry::CYLINDER) {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
      shape.kind = ShapeKind::kCylinder;
      shape.size = {cylinder.radius, cylinder.length, 0};
    } else if (!set_mesh(shape, link, dynamic_cast<const urdf::Mesh&>(geometry))) {
      return;
    }
    link.shapes.push_back(std::move(shape));
  }

  /// Sets a mesh or a capsule. @returns false if the mesh is missing, with a warning
  bool set_mesh(ShapeSpec& shape, const RobotLink& link, const urdf::Mesh& mesh) {
    const std::string beginning = internal::kCapsule;
    if (mesh.filename.compare(0, beginning.size(), beginning) == 0) {
      shape.kind = ShapeKind::kCapsule;
      std::istringstream numbers(mesh.filename.substr(beginning.size()));
      numbers >> shape.size.x() >> shape.size.y();
      return true;
    }
    return internal::try_mesh(shape, mesh.filename, {vector_of(mesh.scale).asDiagonal(), {0, 0, 0}},
                              {file_.path(), meshes_}, link.name, robot_.warnings);
  }

  void add_joint(const urdf::Joint& joint, pugi::xml_node node) {
    RobotJoint ours;
    // Names and frame.
    ours.name = joint.name;
    ours.parent = joint.parent_link_name;
    ours.child = joint.child_link_name;
    ours.X_PJ = pose_of(joint.parent_to_joint_origin_transform);
    set_motion(ours, joint);
    if (ours.kind != RobotJointKind::kFixed) ours.axis = vector_of(joint.axis).normalized();
    // Passive torques, and joints that follow others.
    if (joint.dynamics) {
      ours.damping = joint.dynamics->damping;
      ours.friction = joint.dynamics->friction;
    }
    if (joint.mimic && ours.kind != RobotJointKind::kFixed)
      couplings_.push_back({joint.name, joint.mimic->joint_name, joint.mimic->multiplier,
                            joint.mimic->offset, file_.line(node)});
    robot_.joints.push_back(std::move(ours));
  }

  void set_motion(RobotJoint& ours, const urdf::Joint& joint) {
    // Joints of several freedoms are not read.
    if (joint.type == urdf::Joint::FLOATING || joint.type == urdf::Joint::PLANAR)
      robot_.warnings.push_back(
          fmt::format("{} joint '{}' is taken as fixed",
                      joint.type == urdf::Joint::FLOATING ? "floating" : "planar", joint.name));
    ours.kind = RobotJointKind::kFixed;
    if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS)
      ours.kind = RobotJointKind::kRevolute;
    if (joint.type == urdf::Joint::PRISMATIC) ours.kind = RobotJointKind::kPrismatic;
    // A continuous joint gets one turn; limits in the wrong order are swapped.
    if (joint.type == urdf::Joint::CONTINUOUS) {
      ours.lower = -kPi;
      ours.upper = kPi;
      endless_.push_back(joint.name);
    } else if (joint.limits && ours.kind != RobotJointKind::kFixed) {
      ours.lower = joint.limits->lower;
      ours.upper = joint.limits->upper;
      if (ours.lower > ours.upper) {
        robot_.warnings.push_back(fmt::format("limits of joint '{}' are swapped: {:.6g} > {:.6g}",
                                              joint.name, ours.lower, ours.upper));
        std::swap(ours.lower, ours.upper);
      }
    }
  }

  void set_motor(RobotDof& dof) {
    const urdf::Joint& joint = *model_.joints_.at(dof.name);
    // Unknown efforts are 0.
    if (!joint.limits) return;
    dof.max_effort = joint.limits->effort;
    if (!(dof.max_effort >= 0)) {
      robot_.warnings.push_back(fmt::format("effort of joint '{}' is {:.6g}: treated as unknown",
                                            dof.name, dof.max_effort));
      dof.max_effort = 0;
    }
    // A range below zero closes downwards.
    if (joint.limits->velocity > 0) dof.speed = joint.limits->velocity;
    if (dof.upper <= 0 && dof.lower < 0) dof.speed = -dof.speed;
  }

  const urdf::ModelInterface& model_;
  const XmlFile& file_;
  RobotSpec& robot_;
  std::vector<FollowerCoupling> couplings_;
  std::vector<std::string> shown_;    // links that only have visual shapes
  std::vector<std::string> endless_;  // continuous joints
  MeshReader meshes_;
};

}  // namespace

RobotSpec read_urdf(const std::string& path) {
  const XmlFile file(path);
  UnreadElements unread(file);
  const std::string text = internal::prepare_urdf(file, unread);
  RobotSpec robot;
  robot.warnings = unread.warnings();
  const urdf::ModelInterfaceSharedPtr model = parse(text, file, robot.warnings);
  robot.name = model->getName();
  robot.closing_stated = robot.approach_stated = false;
  UrdfTranslation(*model, file, robot).run();
  return robot;
}

}  // namespace thenar
