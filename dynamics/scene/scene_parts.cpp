#include "dynamics/scene/scene_parts.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/toml_node.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

constexpr double kLimitTolerance = 1e-9;  // excess over a joint limit by rounding [rad] or [m]

/// Returns the motion of a hinge or slide along z by a value [rad] or [m].
Pose<double> motion_along_z(JointKind kind, double value) {
  Pose<double> X;
  if (kind == JointKind::kHinge) X.R = rotation_about<double>({0, 0, 1}, value);
  if (kind == JointKind::kSlide) X.p.z() = value;
  return X;
}

/// Sets the joint of the first body of a part, whose parent is still the world.
/// @param name  name of the joint's coordinate
/// @param X_WB  initial pose of the body
void put_on_joint(const SceneJointSpec& spec, const std::string& name, const Pose<double>& X_WB,
                  Mechanism& part) {
  MechanismJoint& joint = part.joints.front();
  joint.kind = spec.kind;
  // A free joint is at the centre of mass.
  if (spec.kind == JointKind::kFree) {
    joint.X_PF = {};
    joint.X_BM.p = part.bodies.front().mass.com;
    return;
  }
  // Frame A of the joint, z along its axis; F is moved back by the initial value.
  Pose<double> A = X_WB;
  if (spec.kind == JointKind::kBall) A = {Eigen::Matrix3d::Identity(), spec.point};
  if (is_scalar(joint.kind)) A = frame_with_z(spec.axis, spec.point);
  joint.X_PF = A * motion_along_z(joint.kind, -spec.start);
  joint.X_BM = X_WB.inverse() * A;
  if (!is_scalar(joint.kind)) return;
  // Coordinate of a hinge or slide, with its limits and resistance.
  joint.coordinate = static_cast<int>(part.coordinates.size());
  part.coordinates.push_back({name});
  joint.lower = spec.lower;
  joint.upper = spec.upper;
  joint.stiffness = spec.stiffness;
  joint.rest = spec.rest;
  joint.damping = spec.damping;
  joint.friction = spec.friction;
}

/// Returns the position of a motor where closing begins, the default of the file.
double open_position(const RobotDof& dof) {
  if (dof.open) return *dof.open;
  if (dof.speed > 0) return dof.lower;
  if (dof.speed < 0) return dof.upper;
  return std::clamp(0.0, dof.lower, dof.upper);
}

/// Welds the joints of a coordinate at its value u [rad] or [m].
void weld_coordinate(Mechanism& part, int coordinate, double u) {
  for (MechanismJoint& joint : part.joints) {
    if (!is_moved_by(joint, coordinate)) continue;
    // Shift F by the joint's value at u, and weld it there.
    joint.X_PF = joint.X_PF * motion_along_z(joint.kind, joint_value(joint, u).value);
    joint.kind = JointKind::kWeld;
  }
}

/// Removes coordinates that no joint uses. @return the old index of each remaining coordinate
std::vector<int> remove_unused_coordinates(Mechanism& part) {
  // Find the coordinates in use, and their new indices.
  std::vector<int> kept, new_index(part.coordinates.size(), -1);
  std::vector<MechanismCoordinate> remaining;
  for (int c = 0; c < static_cast<int>(part.coordinates.size()); ++c) {
    const bool used =
        any_of(part.joints, [&](const MechanismJoint& joint) { return is_moved_by(joint, c); });
    if (!used) continue;
    new_index[c] = static_cast<int>(kept.size());
    kept.push_back(c);
    remaining.push_back(part.coordinates[c]);
  }
  part.coordinates = std::move(remaining);
  // Update the joints.
  for (MechanismJoint& joint : part.joints)
    if (is_scalar(joint.kind)) joint.coordinate = new_index[joint.coordinate];
  return kept;
}

/// Returns the initial coordinates of a robot hand [rad] or [m].
std::vector<double> robot_posture(const SceneHandSpec& hand, const RobotSpec& robot,
                                  const Mechanism& part) {
  // Open positions of the motors, replaced by the posture that the file states.
  const std::vector<std::string> names = names_of(part.coordinates);
  std::vector<double> u(names.size(), 0);
  for (std::size_t c = 0; c < names.size(); ++c)
    if (const RobotDof* dof = find_named(robot.dofs, names[c])) u[c] = open_position(*dof);
  for (const auto& [name, value] : hand.placed.posture)
    u[index_of_name(name, names, "coordinate of hand '" + hand.placed.name + "'")] = value;
  // Check the joint limits.
  for (const MechanismJoint& joint : part.joints) {
    if (!is_scalar(joint.kind)) continue;
    const double value = joint_value(joint, u[joint.coordinate]).value;
    require(value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance,
            "joint '{}' of hand '{}' begins at {:.4g}, beyond its limits {:.4g} to {:.4g} [rad], "
            "[m]",
            joint.name, hand.placed.name, value, joint.lower, joint.upper);
  }
  return u;
}

/// Computes the initial poses of the bodies of a part whose root frame is at X_WH.
void set_poses(const Pose<double>& X_WH, ScenePart& part) {
  part.X_WB.clear();
  const TreeModel model = tree_model(part.mechanism);
  TreeMotion<double> motion(model);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.layout.q);
  for (std::size_t c = 0; c < part.u.size(); ++c) q[model.layout.coordinate_q[c]] = part.u[c];
  motion.set_position(q);
  for (int body = 0; body < static_cast<int>(part.mechanism.bodies.size()); ++body)
    part.X_WB.push_back(X_WH * motion.pose(body));
}

/// Builder of the parts of one scene.
class PartsBuilder {
 public:
  explicit PartsBuilder(const SceneSpec& spec) : spec_(spec) {}

  SceneParts build(const std::vector<SceneHand>& hands) {
    for (std::size_t h = 0; h < spec_.hands.size(); ++h)
      out_.parts.push_back(hand_part(spec_.hands[h], hands[h]));
    for (const SceneBodySpec& body : spec_.bodies) out_.parts.push_back(body_part(body));
    return std::move(out_);
  }

 private:
  [[nodiscard]] ScenePart body_part(const SceneBodySpec& body) const {
    return at_line(spec_.path, body.line, [&] {
      ScenePart part;
      part.name = body.placed.body.name;
      part.joint = body.joint;
      part.velocity = body.velocity;
      PlacedBody placed = body.placed;
      // A body that is welded to a parent body moves with it, so it needs a mass.
      placed.dynamic = body.joint.kind != JointKind::kWeld || !body.joint.parent.empty();
      part.mechanism = body_mechanism(placed, spec_.materials);
      put_on_joint(body.joint, part.name, placed.X_WB, part.mechanism);
      part.X_WB = {placed.X_WB};
      if (!part.mechanism.coordinates.empty()) {
        part.u = {body.joint.start};
        part.u_dot = {body.joint.speed};
      }
      if (make_joints_compliant(part)) set_poses({}, part);
      return part;
    });
  }

  ScenePart hand_part(const SceneHandSpec& hand, const SceneHand& model) {
    return at_line(spec_.path, hand.line, [&] {
      ScenePart part;
      part.name = hand.placed.name;
      part.prefix = part.name + "/";
      part.joint = hand.joint;
      part.velocity = hand.velocity;
      // Build the mechanism, and set the posture.
      if (const auto* robot = std::get_if<RobotSpec>(&model))
        add_robot(hand, *robot, part);
      else
        add_human(hand, std::get<HumanModel>(model), part);
      (void)make_joints_compliant(part);
      set_poses(hand.placed.X_WH, part);
      // Set the joint of the base, whose coordinate is the last one.
      put_on_joint(hand.joint, "base", hand.placed.X_WH, part.mechanism);
      part.u_dot.assign(part.u.size(), 0);
      if (part.mechanism.coordinates.size() > part.u.size()) {
        part.u.push_back(hand.joint.start);
        part.u_dot.push_back(hand.joint.speed);
      }
      return part;
    });
  }

  void add_warnings(const std::string& hand, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
      out_.warnings.push_back(fmt::format("hand '{}': {}", hand, warning));
  }

  void add_robot(const SceneHandSpec& hand, const RobotSpec& robot, ScenePart& part) {
    BuiltMechanism built = robot_mechanism(robot);
    add_warnings(part.name, built.warnings);
    part.mechanism = std::move(built.mechanism);
    part.u = robot_posture(hand, robot, part.mechanism);
    weld_locked_motors(robot, part);
  }

  void add_human(const SceneHandSpec& hand, const HumanModel& model, ScenePart& part) {
    HumanMechanism human = human_mechanism(model);
    add_warnings(part.name, human.warnings);
    part.mechanism = human.mechanism;
    part.u = human_posture(hand, human);
    out_.humans.push_back({part.name, std::move(human)});
  }

  [[nodiscard]] bool is_driven(const std::string& coordinate) const {
    return any_of(spec_.drives,
                  [&](const SceneDriveSpec& drive) { return drive.coordinate == coordinate; });
  }

  /// Welds motors that are not backdrivable and have no drive; warns of features left out.
  void weld_locked_motors(const RobotSpec& robot, ScenePart& part) {
    for (std::size_t c = 0; c < part.mechanism.coordinates.size(); ++c) {
      const MechanismCoordinate& coordinate = part.mechanism.coordinates[c];
      const std::string name = part.prefix + coordinate.name;
      if (!is_driven(name) && !coordinate.backdrivable)
        weld_coordinate(part.mechanism, static_cast<int>(c), part.u[c]);
      else if (!is_driven(name))
        out_.warnings.push_back(fmt::format("nothing drives '{}': it moves freely", name));
      else if (!coordinate.backdrivable)
        out_.warnings.push_back(fmt::format(
            "motor '{}' is not backdrivable, but in this scene only its drive resists a load",
            name));
      // Warn of clutches and springs of driven motors, which are not modelled.
      for (const RobotDof& dof : robot.dofs)
        if (dof.name == coordinate.name && dof.kind != DriveCoupling::kRigid && is_driven(name))
          out_.warnings.push_back(fmt::format(
              "motor '{}' moves its joints rigidly: its clutch or springs are left out", name));
    }
    // Keep the values of the remaining coordinates.
    part.u =
        transformed(remove_unused_coordinates(part.mechanism), [&](int c) { return part.u[c]; });
  }

  /// Makes joints of the part compliant as the file says. @return true if there are any
  bool make_joints_compliant(ScenePart& part) const {
    part.compliant = make_part_compliant(spec_, part.name, part.prefix, part.mechanism);
    part.u.resize(part.mechanism.coordinates.size(), 0);
    if (!part.u_dot.empty()) part.u_dot.resize(part.u.size(), 0);
    return !part.compliant.empty();
  }

  const SceneSpec& spec_;
  SceneParts out_;
};

}  // namespace

SceneParts build_scene_parts(const SceneSpec& spec, const std::vector<SceneHand>& hands) {
  require(hands.size() == spec.hands.size(), "{} hands have {} models", spec.hands.size(),
          hands.size());
  return PartsBuilder(spec).build(hands);
}

}  // namespace thenar
