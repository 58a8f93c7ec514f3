#include "api/scenes/world_scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "api/named/hands.h"
#include "api/scenes/simulate_scene.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "dynamics/human/joint_stops.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/composite_body.h"
#include "hand/passive_moment.h"
#include "tendons/digit_tendons.h"

namespace thenar {
namespace {

// Distance from the target at which a drive makes its largest effort: of a hinge, of a slide
constexpr double kFullEffortAngle = 0.1;    // [rad]
constexpr double kFullEffortLength = 0.01;  // [m]
// Natural frequency of drives whose largest effort is unknown [rad/s]
constexpr double kDriveFrequency = 2 * kPi * 5;
// Largest difference of a joint from its coupling to a motor [rad] or [m]
constexpr double kCouplingTolerance = 1e-9;

/// Value of a joint of a robot at its degree of freedom.
JointValue value_at(const RobotJoint& joint, double u) {
  MechanismJoint coupled;
  coupled.ratio = joint.ratio;
  coupled.offset = joint.offset;
  coupled.curve = joint.curve;
  return joint_value(coupled, u);
}

/// The degree of freedom at which a joint has a value, by Newton's method on its coupling.
double dof_at(const RobotJoint& joint, double value) {
  double u = (value - joint.offset) / joint.ratio;
  for (int i = 0; i < 50 && !joint.curve.empty(); ++i) {
    const JointValue at = value_at(joint, u);
    const double move = (value - at.value) / at.slope;
    u += move;
    if (std::abs(move) < 1e-15) break;
  }
  return u;
}

/// Moves a robot into the posture of a world, which names joints: its motors get the values that
/// the first of their joints have, and what else they move goes on from where it stands.
/// @param posture  of joints and motors, then of motors and joints without one
void take_posture(RobotSpec& robot, std::map<std::string, double>& posture,
                  std::vector<std::string>& warnings) {
  for (const RobotDof& dof : robot.dofs) {
    const bool known = posture.count(dof.name) > 0;
    double u = known ? posture.at(dof.name) : 0;
    bool found = known, apart = false;
    for (RobotJoint& joint : robot.joints) {
      // Take the motor's value from its first named joint, and shift joints that differ.
      if (joint.dof != dof.name || posture.count(joint.name) == 0) continue;
      if (known && joint.name == dof.name) continue;
      const double value = posture.at(joint.name);
      posture.erase(joint.name);
      if (!found) u = dof_at(joint, value);
      found = true;
      const double off = value - value_at(joint, u).value;
      if (std::abs(off) <= kCouplingTolerance) continue;
      joint.offset += off;
      apart = true;
    }
    // The posture names the motor from now on, in place of its joints.
    if (found) posture[dof.name] = u;
    if (apart)
      warnings.push_back(fmt::format(
          "robot '{}': joints of '{}' have gone apart by its clutch or springs; from here on they "
          "move together",
          robot.name, dof.name));
  }
}

/// A world on the way to a scene.
class WorldBuilder {
 public:
  WorldBuilder(const WorldSpec& world, const std::string& data, WorldDrives drives)
      : world_(world), data_(data), drives_(drives) {
    spec_.name = world.name;
    spec_.description = world.description;
    spec_.folder = world.folder;
    spec_.path = world.name;
    spec_.materials = world.materials;
    spec_.stepping.method = "time-stepping";
    spec_.camera = world.camera;
  }

  BuiltScene build() {
    for (const PlacedBody& body : world_.bodies) add_body(body);
    add_hands();
    BuiltScene built = build_scene(spec_, hands_);
    set_drives(built);
    built.warnings.insert(built.warnings.begin(), warnings_.begin(), warnings_.end());
    return built;
  }

 private:
  void add_body(const PlacedBody& body) {
    SceneBodySpec out;
    out.placed = body;
    out.joint.kind = body.dynamic ? JointKind::kFree : JointKind::kWeld;
    if (body.dynamic) weigh(out.placed.body);
    spec_.bodies.push_back(std::move(out));
  }

  void weigh(BodySpec& body) {
    try {
      (void)body_mass(body, world_.materials);
    } catch (const InputError&) {
      body.density = kAssumedDensity;
      warnings_.push_back(
          fmt::format("nothing says what '{}' weighs: it has the density of water", body.name));
    }
  }

  // ---- hands, each after what carries it

  void add_hands() {
    std::vector<bool> added(world_.hands.size(), false);
    // Each round adds the hands whose carriers are there.
    for (std::size_t round = 0; round < world_.hands.size(); ++round)
      for (std::size_t i = 0; i < world_.hands.size(); ++i) {
        const PlacedHand& placed = world_.hands[i];
        if (added[i] || (!placed.carrier.empty() && !is_there(placed.carrier))) continue;
        add_hand(placed);
        added[i] = true;
      }
    // A hand that is left has no carrier in the world.
    const auto left = std::find(added.begin(), added.end(), false);
    if (left == added.end()) return;
    const PlacedHand& hand = world_.hands[static_cast<std::size_t>(left - added.begin())];
    throw InputError(
        fmt::format("hand '{}' is mounted on '{}', which is not there", hand.name, hand.carrier));
  }

  [[nodiscard]] bool is_there(const std::string& hand) const {
    return any_of(spec_.hands, [&](const SceneHandSpec& each) { return each.placed.name == hand; });
  }

  void add_hand(const PlacedHand& placed) {
    SceneHandSpec out;
    out.placed = placed;
    out.joint.kind = JointKind::kWeld;
    // Express a mount on a carrier as a weld to its link.
    if (!placed.carrier.empty()) {
      out.joint.parent = placed.carrier + "/" + placed.carrier_link;
      out.placed.X_WH = pose_of(out.joint.parent) * placed.X_WH;
      out.placed.carrier.clear();
      out.placed.carrier_link.clear();
    }
    const std::string version = version_of_hand(placed.name);
    if (!placed.file.empty() && !version.empty()) out.version = version.substr(1);
    // Find the model of this hand alone.
    SceneSpec alone = spec_;
    alone.hands = {out};
    SceneHand model = std::move(hands_of_scene(alone, data_, alone.files).front());
    if (auto* robot = std::get_if<RobotSpec>(&model)) {
      take_posture(*robot, out.placed.posture, warnings_);
      add_robot_drives(placed.name, *robot);
    } else {
      add_human_drives(placed.name, std::get<HumanModel>(model));
    }
    spec_.hands.push_back(std::move(out));
    hands_.push_back(std::move(model));
  }

  /// Computes the pose of a link in the world, from all that was added so far.
  [[nodiscard]] Pose<double> pose_of(const std::string& link) const {
    const BuiltScene so_far = build_scene(spec_, hands_);
    const TreeModel model = tree_model(so_far.scene.mechanism);
    TreeMotion<double> motion(model);
    motion.set_position(so_far.scene.q);
    return motion.pose(body_named(so_far.scene.mechanism, link));
  }

  // ---- drives

  void add_drive(const std::string& coordinate, bool turns) {
    SceneDriveSpec drive;
    drive.coordinate = coordinate;
    drive.turns = turns;
    spec_.drives.push_back(std::move(drive));
  }

  /// Every coordinate has a drive, or a motor that cannot be driven back would be welded.
  void add_robot_drives(const std::string& hand, const RobotSpec& robot) {
    for (const RobotDof& dof : robot.dofs)
      if (any_of(robot.joints, [&](const RobotJoint& joint) { return joint.dof == dof.name; }))
        add_drive(hand + "/" + dof.name, !slides(robot, dof));
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof.empty() && joint.kind != RobotJointKind::kFixed)
        add_drive(hand + "/" + joint.name, !slides(joint));
  }

  void add_human_drives(const std::string& hand, const HumanModel& human) {
    const HumanMechanism mechanism = human_mechanism(human);
    if (drives_ != WorldDrives::kTendons) {
      for (const std::string& joint : mechanism.skeleton.coordinate_names)
        add_drive(hand + "/" + joint, true);
      return;
    }
    // All muscles pull from the start, with tension 0.
    require(!mechanism.digits.empty(), "hand '{}' has no muscles", hand);
    SceneMuscleSpec muscles;
    muscles.hand = hand;
    muscles.tensions = true;
    for (const HumanDigit& digit : mechanism.digits)
      for (const std::string& muscle : digit.tendons->digit().names.muscles)
        muscles.value[muscle] = 0;
    spec_.muscles.push_back(std::move(muscles));
    warnings_.push_back(fmt::format("tendons of '{}' are slack until they are pulled", hand));
  }

  /// Lets drives hold their coordinates at the present values.
  void set_drives(BuiltScene& built) {
    MovingScene& scene = built.scene;
    if (drives_ == WorldDrives::kNone || scene.drives.empty()) return;
    const TreeModel model = tree_model(scene.mechanism);
    TreeMotion<double> motion(model);
    motion.set_position(scene.q);
    motion.set_speed(Eigen::VectorXd::Zero(model.layout.v));
    motion.clear_loads();
    // Compute the efforts that balance the weight at rest, and the inertia of each coordinate.
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(model.layout.v);
    InverseDynamics<double> inverse(model);
    inverse.efforts(motion, scene.gravity, Eigen::VectorXd::Zero(model.layout.v), weight);
    MassMatrix<double> mass(model);
    require(mass.compute(motion), "masses of '{}' are too unequal", world_.name);
    // Add the ends of passive moments, which are elements of the scene.
    for (const std::shared_ptr<const ForceElement>& element : scene.elements)
      if (const auto* stops = dynamic_cast<const JointStops*>(element.get()))
        for (std::size_t i = 0; i < stops->ranges().size(); ++i)
          weight[stops->indices().v[i]] -=
              passive_moment(stops->ranges()[i], scene.q[stops->indices().q[i]]);
    // Set each drive to the present value and the weight there.
    for (SceneDrive& drive : scene.drives) {
      const auto c = static_cast<std::size_t>(drive.coordinate);
      const int row = model.layout.coordinate_v[c];
      hold(scene.mechanism, scene.q[model.layout.coordinate_q[c]], weight[row], mass(row, row),
           drive);
    }
    warnings_.push_back("drives hold all joints in place, and carry the weight of the hands there");
  }

  /// @param inertia  that the coordinate feels [kg m^2] or [kg]
  void hold(const Mechanism& mechanism, double u, double weight, double inertia,
            SceneDrive& drive) {
    bool slides = false;
    double springs = 0;  // stiffness of its joints' springs on the coordinate
    for (const MechanismJoint& joint : mechanism.joints) {
      if (!is_scalar(joint.kind) || joint.coordinate != drive.coordinate) continue;
      slides = slides || joint.kind == JointKind::kSlide;
      const JointValue at = joint_value(joint, u);
      springs -= at.slope * joint.stiffness * (at.value - joint.rest);
    }
    const std::string& name =
        mechanism.coordinates[static_cast<std::size_t>(drive.coordinate)].name;
    drive.bias = weight - springs;
    drive.target = u;
    // Choose the stiffness by the largest effort, else by a frequency; damp critically.
    const bool known = std::isfinite(drive.max_effort);
    drive.stiffness = known ? drive.max_effort / (slides ? kFullEffortLength : kFullEffortAngle)
                            : inertia * kDriveFrequency * kDriveFrequency;
    drive.damping = 2 * std::sqrt(drive.stiffness * inertia);
    if (!known)
      warnings_.push_back(
          fmt::format("the largest effort of '{}' is unknown: its drive has none", name));
    else if (std::abs(drive.bias) > drive.max_effort)
      warnings_.push_back(
          fmt::format("'{}' cannot carry the weight of its hand: {:.3g} of {:.3g} {}", name,
                      std::abs(drive.bias), drive.max_effort, slides ? "N" : "N m"));
  }

  const WorldSpec& world_;
  const std::string& data_;
  WorldDrives drives_;
  SceneSpec spec_;
  std::vector<SceneHand> hands_;
  std::vector<std::string> warnings_;
};

}  // namespace

BuiltScene build_world_scene(const WorldSpec& world, const std::string& data, WorldDrives drives) {
  return WorldBuilder(world, data, drives).build();
}

}  // namespace thenar
