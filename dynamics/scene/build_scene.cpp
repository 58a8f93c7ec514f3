#include "dynamics/scene/build_scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/scene/scene_compliance.h"
#include "dynamics/scene/scene_humans.h"
#include "dynamics/scene/scene_pads.h"
#include "dynamics/scene/scene_pairs.h"
#include "dynamics/scene/target_table.h"

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

/// Body or hand of the file as it enters the mechanism.
struct ScenePart {
  Mechanism mechanism;             // its world is the scene's
  std::string name, prefix;        // of the file; before names of bodies and coordinates
  std::vector<Pose<double>> X_WB;  // of its bodies at the start
  std::vector<double> u, u_dot;    // of its coordinates at the start
  SceneJointSpec joint;            // of its first body
  SceneVelocity velocity;
  std::vector<CompliantJoint> compliant;  // coordinates are the part's
};

class SceneBuilder {
 public:
  SceneBuilder(const SceneSpec& spec, const std::vector<SceneHand>& hands)
      : spec_(spec), hands_(hands) {}

  BuiltScene build() {
    require(hands_.size() == spec_.hands.size(), "{} hands have {} models", spec_.hands.size(),
            hands_.size());
    // Build every hand and body by itself, then join them into one mechanism.
    std::vector<ScenePart> parts;
    for (std::size_t h = 0; h < spec_.hands.size(); ++h)
      parts.push_back(hand_part(spec_.hands[h], hands_[h]));
    for (const SceneBodySpec& body : spec_.bodies) parts.push_back(body_part(body));
    add_parents_first(parts);
    set_start(parts);
    // Add the force elements: capsules, ligaments, muscles.
    for (const CompliantJoint& joint : compliant_)
      built_.scene.elements.push_back(
          std::make_shared<CapsuleElement>(built_.scene.mechanism, joint));
    for (const std::shared_ptr<const ForceElement>& ligament :
         scene_ligaments(spec_, built_.scene.mechanism, X_WB_))
      built_.scene.elements.push_back(ligament);
    add_human_elements(spec_, humans_, built_);
    part_webs(humans_, built_);
    // Add what acts from outside, and check the scene before pads and pairs are added.
    built_.scene.gravity = spec_.gravity;
    add_forces();
    add_drives();
    set_options();
    at_line(spec_.path, spec_.stepping.line, [&] { check_scene(built_.scene); });
    add_pads(spec_, humans_, built_);
    set_pairs(spec_, built_);
    set_hard_points(spec_, built_);
    return std::move(built_);
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
      built_.warnings.push_back(fmt::format("hand '{}': {}", hand, warning));
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
    humans_.push_back({part.name, std::move(human)});
  }

  /// Coordinates of a hand at the start.
  static std::vector<double> posture_of(const SceneHandSpec& hand, const RobotSpec& robot,
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
        built_.warnings.push_back(fmt::format("nothing drives '{}': it moves freely", name));
      else if (!coordinate.backdrivable)
        built_.warnings.push_back(fmt::format(
            "motor '{}' is not backdrivable, but in this scene only its drive resists a load",
            name));
      // Clutches and springs of driven motors are not modelled.
      for (const RobotDof& dof : robot.dofs)
        if (dof.name == coordinate.name && dof.kind != DriveCoupling::kRigid && is_driven(name))
          built_.warnings.push_back(fmt::format(
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

  /// Poses of the bodies of a part whose world is at X_WH.
  static void place_links(const Pose<double>& X_WH, ScenePart& part) {
    part.X_WB.clear();
    const TreeModel model = tree_model(part.mechanism);
    TreeMotion<double> motion(model);
    Eigen::VectorXd q = Eigen::VectorXd::Zero(model.layout.q);
    for (std::size_t c = 0; c < part.u.size(); ++c) q[model.layout.coordinate_q[c]] = part.u[c];
    motion.set_position(q);
    for (int body = 0; body < static_cast<int>(part.mechanism.bodies.size()); ++body)
      part.X_WB.push_back(X_WH * motion.pose(body));
  }

  /// The body or hand that holds a name: "HAND/LINK" is of the hand.
  static bool holds(const ScenePart& part, const std::string& name) {
    return part.prefix.empty() ? part.name == name
                               : name.compare(0, part.prefix.size(), part.prefix) == 0;
  }

  /// Adds all parts to the mechanism, each after the part that carries it. The reader has refused
  /// parents that lead back to themselves.
  void add_parents_first(std::vector<ScenePart>& parts) {
    // Depth first: the part that carries another is added before it.
    std::vector<ScenePart> ordered;
    std::vector<bool> added(parts.size(), false);
    const auto add = [&](const auto& self, std::size_t i) -> void {
      if (added[i]) return;
      added[i] = true;
      for (std::size_t j = 0; j < parts.size(); ++j)
        if (j != i && !parts[i].joint.parent.empty() && holds(parts[j], parts[i].joint.parent))
          self(self, j);
      add_part(parts[i]);
      ordered.push_back(parts[i]);
    };
    for (std::size_t i = 0; i < parts.size(); ++i) add(add, i);
    parts = std::move(ordered);
  }

  void add_part(const ScenePart& part) {
    Mechanism& whole = built_.scene.mechanism;
    int carrier = -1;
    Pose<double> X_CW;
    // Find the body that carries the part.
    if (!part.joint.parent.empty()) {
      carrier = at_line(spec_.path, part.joint.line,
                        [&] { return body_named(whole, part.joint.parent); });
      X_CW = X_WB_[static_cast<std::size_t>(carrier)].inverse();
    }
    // Shift coordinates of compliant joints behind those of earlier parts.
    for (CompliantJoint joint : part.compliant) {
      joint.name = part.prefix + joint.name;
      for (int& c : joint.coordinate)
        if (c >= 0) c += static_cast<int>(whole.coordinates.size());
      compliant_.push_back(std::move(joint));
    }
    append(whole, part.mechanism, part.prefix, carrier, X_CW);
    X_WB_.insert(X_WB_.end(), part.X_WB.begin(), part.X_WB.end());
    built_.owner.resize(whole.bodies.size(), part.name);
  }

  /// Positions and speeds at the start. @param parts  as they were added
  void set_start(const std::vector<ScenePart>& parts) {
    MovingScene& scene = built_.scene;
    const MechanismLayout layout = layout_of(scene.mechanism);
    scene.q = reference_position(scene.mechanism);
    scene.v = Eigen::VectorXd::Zero(layout.v);
    // Parts in order have their bodies and coordinates one after the other.
    std::size_t body = 0, coordinate = 0;
    for (const ScenePart& part : parts) {
      for (std::size_t c = 0; c < part.u.size(); ++c, ++coordinate) {
        scene.q[layout.coordinate_q[coordinate]] = part.u[c];
        scene.v[layout.coordinate_v[coordinate]] = part.u_dot[c];
      }
      if (part.joint.kind == JointKind::kBall)
        scene.v.segment<3>(layout.first_v[body]) = part.joint.spin;
      if (part.joint.kind == JointKind::kFree) set_free(static_cast<int>(body), part.velocity);
      body += part.mechanism.bodies.size();
    }
  }

  void set_free(int body, const SceneVelocity& velocity) {
    MovingScene& scene = built_.scene;
    const auto at = static_cast<std::size_t>(body);
    set_free_pose(scene.mechanism, body, X_WB_[at], scene.q);
    // The velocity is that of the centre of mass.
    const Eigen::Vector3d arm = X_WB_[at].R * scene.mechanism.bodies[at].mass.com;
    set_free_velocity(scene.mechanism, body, scene.q, velocity.linear - velocity.angular.cross(arm),
                      velocity.angular, scene.v);
  }

  void add_forces() {
    for (const SceneForceSpec& force : spec_.forces) {
      // Force on a body, by default at its centre of mass.
      SceneForce out;
      out.body = at_line(spec_.path, force.line,
                         [&] { return body_named(built_.scene.mechanism, force.body); });
      const MechanismBody& body = built_.scene.mechanism.bodies[static_cast<std::size_t>(out.body)];
      out.point = force.point.value_or(body.mass.com);
      out.force = force.force;
      out.moment = force.moment;
      out.when = {force.from, force.to};
      built_.scene.forces.push_back(out);
      built_.force_names.push_back(force.name);
    }
  }

  /// The targets of a drive over time; null: it has no table.
  [[nodiscard]] std::shared_ptr<const TargetTable> table_of(const SceneDriveSpec& spec) const {
    if (spec.target_file.empty()) return nullptr;
    const std::string path = linked_path(spec_.folder, spec.target_file);
    return std::make_shared<TargetTable>(
        without_straight_knots(parse_target_table(read_text_file(path), path, spec)));
  }

  void add_drives() {
    const Mechanism& mechanism = built_.scene.mechanism;
    std::vector<std::string> names;
    for (const MechanismCoordinate& coordinate : mechanism.coordinates)
      names.push_back(coordinate.name);
    for (const SceneDriveSpec& drive : spec_.drives) {
      // Coordinate of each drive.
      SceneDrive out;
      out.coordinate = at_line(spec_.path, drive.line, [&] {
        return static_cast<int>(index_of_name(drive.coordinate, names, "coordinate"));
      });
      // The units of the drive must suit the kind of its joint.
      const auto joint = std::find_if(
          mechanism.joints.begin(), mechanism.joints.end(), [&](const MechanismJoint& each) {
            return is_scalar(each.kind) && each.coordinate == out.coordinate;
          });
      const bool turns = joint->kind == JointKind::kHinge;
      if (turns != drive.turns)
        throw DataError(spec_.path, drive.line,
                        fmt::format("'{}' {}, but the drive has units of what {}", drive.coordinate,
                                    turns ? "turns" : "slides", turns ? "slides" : "turns"));
      // Without a largest effort of its own, the drive has that of the motor.
      const double known =
          mechanism.coordinates[static_cast<std::size_t>(out.coordinate)].max_effort;
      out.bias = drive.effort;
      out.stiffness = drive.stiffness;
      out.damping = drive.damping;
      out.target = drive.target;
      out.speed = drive.speed;
      out.max_effort =
          drive.max_effort.value_or(known > 0 ? known : std::numeric_limits<double>::infinity());
      out.when = {drive.from, drive.to};
      out.table = table_of(drive);
      built_.scene.drives.push_back(out);
      built_.drive_names.push_back(drive.name);
    }
  }

  void set_options() {
    const SteppingSpec& stepping = spec_.stepping;
    SceneOptions& options = built_.options;
    options.method = at_line(spec_.path, stepping.line, [&] {
      return value_in(kSteppingMethodNames, stepping.method, "method");
    });
    // Lengths of steps and samples, or the defaults.
    options.seconds = stepping.duration;
    options.sample = stepping.sample;
    options.step = stepping.step.value_or(options.step);
    options.longest = stepping.longest.value_or(options.longest);
    options.tolerance = stepping.tolerance.value_or(options.tolerance);
    options.recovery = stepping.recovery.value_or(options.recovery);
    set_compliance();
  }

  void set_compliance() {
    const SteppingSpec& stepping = spec_.stepping;
    ContactCompliance& out = built_.options.compliance;
    // Numbers that the file states, or the defaults.
    out.modulus = stepping.modulus.value_or(out.modulus);
    out.stiffness = stepping.stiffness.value_or(out.stiffness);
    out.dissipation = stepping.dissipation.value_or(out.dissipation);
    out.layer = stepping.layer.value_or(out.layer);
    out.transition = stepping.transition.value_or(out.transition);
    if (stepping.friction_ramp.empty()) return;
    out.ramp = at_line(spec_.path, stepping.line, [&] {
      return value_in(kFrictionRampNames, stepping.friction_ramp, "friction ramp");
    });
  }

  const SceneSpec& spec_;
  const std::vector<SceneHand>& hands_;
  std::vector<SceneHuman> humans_;
  BuiltScene built_;
  std::vector<Pose<double>> X_WB_;  // of all bodies at the start
  std::vector<CompliantJoint> compliant_;
};

}  // namespace

BuiltScene build_scene(const SceneSpec& spec, const std::vector<SceneHand>& hands) {
  return SceneBuilder(spec, hands).build();
}

}  // namespace thenar
