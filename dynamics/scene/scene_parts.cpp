#include "dynamics/scene/scene_parts.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/toml_node.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

constexpr double kBeyondLimit = 1e-9;  // posture beyond a joint limit by rounding [rad] or [m]

/// Motion of a hinge or slide along z by a value.
Pose<double> motion_along_z(JointKind kind, double value) {
  Pose<double> X;
  if (kind == JointKind::kHinge) X.R = rotation_about<double>({0, 0, 1}, value);
  if (kind == JointKind::kSlide) X.p.z() = value;
  return X;
}

/// Puts the first body of a part, whose parent is the world here, on a joint.
/// @param X_WB   where it is;  @param name  of a coordinate of its own
void put_on_joint(const SceneJointSpec& spec, const std::string& name, const Pose<double>& X_WB,
                  Mechanism& part) {
  MechanismJoint& joint = part.joints.front();
  joint.kind = spec.kind;
  // A free body hangs on its centre of mass.
  if (spec.kind == JointKind::kFree) {
    joint.X_PF = {};
    joint.X_BM.p = part.bodies.front().mass.com;
    return;
  }
  // Frame A of the joint, z along its axis; F is turned back by the start, where the part stands.
  Pose<double> A = X_WB;
  if (spec.kind != JointKind::kWeld) A = {Eigen::Matrix3d::Identity(), spec.point};
  if (is_scalar(joint.kind)) {
    const Tangents sides = tangents(spec.axis);
    A.R << sides.e1, sides.e2, spec.axis;
  }
  joint.X_PF = A * motion_along_z(joint.kind, -spec.start);
  joint.X_BM = X_WB.inverse() * A;
  if (!is_scalar(joint.kind)) return;
  // What belongs to a coordinate.
  joint.coordinate = static_cast<int>(part.coordinates.size());
  part.coordinates.push_back({name});
  joint.lower = spec.lower;
  joint.upper = spec.upper;
  joint.stiffness = spec.stiffness;
  joint.rest = spec.rest;
  joint.damping = spec.damping;
  joint.friction = spec.friction;
}

/// Returns the position of a motor for which the file states none: the position where closing
/// begins.
double opening_of(const RobotDof& dof) {
  if (dof.open) return *dof.open;
  if (dof.speed > 0) return dof.lower;
  if (dof.speed < 0) return dof.upper;
  return std::clamp(0.0, dof.lower, dof.upper);
}

/// Welds the joints of a coordinate where they stand.
void weld_coordinate(Mechanism& part, int coordinate, double u) {
  for (MechanismJoint& joint : part.joints) {
    if (!is_scalar(joint.kind)) continue;
    // Shift F by the joint's value at u, and weld it there.
    if (joint.coordinate == coordinate) {
      joint.X_PF = joint.X_PF * motion_along_z(joint.kind, joint_value(joint, u).value);
      joint.kind = JointKind::kWeld;
    }
  }
}

/// Leaves out coordinates that move nothing any more. @return the old index of each that is left
std::vector<int> drop_unused(Mechanism& part) {
  // Coordinates that some joint still has, and their new numbers.
  std::vector<int> kept, now(part.coordinates.size(), -1);
  std::vector<MechanismCoordinate> left;
  for (int c = 0; c < static_cast<int>(part.coordinates.size()); ++c) {
    const bool used =
        std::any_of(part.joints.begin(), part.joints.end(), [&](const MechanismJoint& joint) {
          return is_scalar(joint.kind) && joint.coordinate == c;
        });
    if (!used) continue;
    now[static_cast<std::size_t>(c)] = static_cast<int>(kept.size());
    kept.push_back(c);
    left.push_back(part.coordinates[static_cast<std::size_t>(c)]);
  }
  part.coordinates = std::move(left);
  // New numbers in the joints.
  for (MechanismJoint& joint : part.joints)
    if (is_scalar(joint.kind)) joint.coordinate = now[static_cast<std::size_t>(joint.coordinate)];
  return kept;
}

/// Coordinates of a hand at the start.
std::vector<double> posture_of(const SceneHandSpec& hand, const RobotSpec& robot,
                               const Mechanism& part) {
  // Openings of the motors, then the posture that the file states.
  std::vector<std::string> names;
  std::vector<double> u;
  for (const MechanismCoordinate& coordinate : part.coordinates) {
    names.push_back(coordinate.name);
    u.push_back(0);
    for (const RobotDof& dof : robot.dofs)
      if (dof.name == coordinate.name) u.back() = opening_of(dof);
  }
  for (const auto& [name, value] : hand.placed.posture)
    u[index_of_name(name, names, "coordinate of hand '" + hand.placed.name + "'")] = value;
  // No joint may begin beyond its limits.
  for (const MechanismJoint& joint : part.joints) {
    if (!is_scalar(joint.kind)) continue;
    const double value = joint_value(joint, u[static_cast<std::size_t>(joint.coordinate)]).value;
    require(value >= joint.lower - kBeyondLimit && value <= joint.upper + kBeyondLimit,
            "joint '{}' of hand '{}' begins at {:.4g}, beyond its limits {:.4g} to {:.4g} [rad], "
            "[m]",
            joint.name, hand.placed.name, value, joint.lower, joint.upper);
  }
  return u;
}

/// Poses of the bodies of a part whose world is at X_WH.
void place_links(const Pose<double>& X_WH, ScenePart& part) {
  part.X_WB.clear();
  const TreeModel model = tree_model(part.mechanism);
  TreeMotion<double> motion(model);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.layout.q);
  for (std::size_t c = 0; c < part.u.size(); ++c) q[model.layout.coordinate_q[c]] = part.u[c];
  motion.set_position(q);
  for (int body = 0; body < static_cast<int>(part.mechanism.bodies.size()); ++body)
    part.X_WB.push_back(X_WH * motion.pose(body));
}

/// Builds the parts of one scene; what they share is what the scene says of them.
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
  ScenePart body_part(const SceneBodySpec& body) const {
    return at_line(spec_.path, body.line, [&] {
      ScenePart part;
      part.name = body.placed.body.name;
      part.joint = body.joint;
      part.velocity = body.velocity;
      PlacedBody placed = body.placed;
      // A body that is welded to a parent moves with the parent.
      placed.dynamic = body.joint.kind != JointKind::kWeld || !body.joint.parent.empty();
      part.mechanism = body_mechanism(placed, spec_.materials);
      put_on_joint(body.joint, part.name, placed.X_WB, part.mechanism);
      part.X_WB = {placed.X_WB};
      if (!part.mechanism.coordinates.empty()) {
        part.u = {body.joint.start};
        part.u_dot = {body.joint.speed};
      }
      if (give(part)) place_links({}, part);
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
      // Mechanism and posture of the robot or the human.
      if (const auto* robot = std::get_if<RobotSpec>(&model))
        add_robot(hand, *robot, part);
      else
        add_human(hand, std::get<HumanModel>(model), part);
      (void)give(part);
      place_links(hand.placed.X_WH, part);
      // The base on its joint, whose coordinate comes last.
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
    part.u = posture_of(hand, robot, part.mechanism);
    hold_locked(robot, part);
  }

  void add_human(const SceneHandSpec& hand, const HumanModel& model, ScenePart& part) {
    HumanMechanism human = human_mechanism(model);
    add_warnings(part.name, human.warnings);
    part.mechanism = human.mechanism;
    part.u = human_posture(hand, human);
    out_.humans.push_back({part.name, std::move(human)});
  }

  [[nodiscard]] bool is_driven(const std::string& coordinate) const {
    return std::any_of(spec_.drives.begin(), spec_.drives.end(),
                       [&](const SceneDriveSpec& drive) { return drive.coordinate == coordinate; });
  }

  /// Welds motors that hold by themselves and that nothing drives, and says what is left out.
  void hold_locked(const RobotSpec& robot, ScenePart& part) {
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
      // Clutches and springs of driven motors are not modelled.
      for (const RobotDof& dof : robot.dofs)
        if (dof.name == coordinate.name && dof.kind != DriveCoupling::kRigid && is_driven(name))
          out_.warnings.push_back(fmt::format(
              "motor '{}' moves its joints rigidly: its clutch or springs are left out", name));
    }
    // Keep the values of the coordinates that still move something.
    std::vector<double> u;
    for (const int c : drop_unused(part.mechanism))
      u.push_back(part.u[static_cast<std::size_t>(c)]);
    part.u = std::move(u);
  }

  /// Makes the part's joints give that the file says do. @return whether there are any
  bool give(ScenePart& part) const {
    part.compliant = make_part_compliant(spec_, part.name, part.prefix, part.mechanism);
    part.u.resize(part.mechanism.coordinates.size(), 0);
    if (!part.u_dot.empty()) part.u_dot.resize(part.u.size(), 0);
    return !part.compliant.empty();
  }

  const SceneSpec& spec_;
  SceneParts out_;
};

}  // namespace

SceneParts scene_parts(const SceneSpec& spec, const std::vector<SceneHand>& hands) {
  require(hands.size() == spec.hands.size(), "{} hands have {} models", spec.hands.size(),
          hands.size());
  return PartsBuilder(spec).build(hands);
}

}  // namespace thenar
