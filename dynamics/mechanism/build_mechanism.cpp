#include "dynamics/mechanism/build_mechanism.h"

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Returns true if mass and inertia of a link are stated.
bool is_known(const RobotLink& link) {
  return link.mass > 0 && (link.inertia.diagonal().array() > 0).all();
}

/// Returns the inertia of a ball of given mass [kg] and density [kg/m^3].
Eigen::Matrix3d ball_inertia(double mass, double density) {
  const double radius = std::cbrt(3 * mass / (4 * kPi * density));
  return 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity();
}

/// Returns the mass of a robot's link; adds a warning if mass or inertia is assumed.
BodyMass link_mass(const RobotLink& link, std::vector<std::string>& warnings) {
  if (is_known(link)) return {link.mass, link.com, link.inertia};
  // Assume a ball for a link without shapes.
  if (link.shapes.empty()) {
    if (link.mass > 0)
      warnings.push_back(fmt::format(
          "link '{}': inertia of a ball of its mass, as its own is unknown", link.name));
    return {link.mass, link.com, ball_inertia(link.mass, kAssumedDensity)};
  }
  // Otherwise take the shapes at the stated mass, or at an assumed density.
  BodySpec body;
  body.name = link.name;
  body.shapes = link.shapes;
  body.uniform_mass = link.mass;
  body.density = kAssumedDensity;
  BodyMass mass = body_mass(body);
  if (link.mass > 0) mass.com = link.com;
  warnings.push_back(
      link.mass > 0
          ? fmt::format("link '{}': inertia of its shapes, as its own is unknown", link.name)
          : fmt::format("link '{}': {:.3g} kg, its shapes at {:g} kg/m^3, as its mass is unknown",
                        link.name, mass.mass, kAssumedDensity));
  return mass;
}

/// Returns the coordinate of a joint: its degree of freedom, or one of its own if it has none.
/// @param known  coordinates so far by name, extended
int coordinate_of(const RobotSpec& robot, const RobotJoint& joint,
                  std::map<std::string, int>& known, Mechanism& out) {
  const std::string name = joint.dof.empty() ? joint.name : joint.dof;
  const std::string key = (joint.dof.empty() ? "joint " : "drive ") + name;
  const auto [at, is_new] = known.emplace(key, static_cast<int>(out.coordinates.size()));
  // Add a new coordinate with the effort and backdrivability of its motor.
  if (is_new) {
    MechanismCoordinate coordinate{name, 0, true};
    for (const RobotDof& dof : robot.dofs) {
      if (dof.name != joint.dof) continue;
      coordinate.max_effort = dof.max_effort;
      coordinate.backdrivable = dof.backdrivable;
    }
    out.coordinates.push_back(std::move(coordinate));
  }
  return at->second;
}

/// Converts a movable joint of a robot, without its coordinate.
MechanismJoint moving_joint(const RobotJoint& joint, int parent) {
  // Set frames F and M with z along the axis.
  const Pose<double> axis = frame_with_z(joint.axis, Eigen::Vector3d::Zero());
  MechanismJoint out{
      joint.name, joint.kind == RobotJointKind::kRevolute ? JointKind::kHinge : JointKind::kSlide,
      parent, joint.X_PJ * axis, joint.X_JC.inverse() * axis};
  // Copy value function, limits and resistance.
  if (!joint.dof.empty()) {
    out.ratio = joint.ratio;
    out.offset = joint.offset;
    out.curve = joint.curve;
  }
  out.lower = joint.lower;
  out.upper = joint.upper;
  out.stiffness = joint.stiffness;
  out.rest = joint.rest;
  out.damping = joint.damping;
  out.friction = joint.friction;
  return out;
}

}  // namespace

Mechanism skeleton_mechanism(const Skeleton& skeleton) {
  Mechanism out;
  for (const std::string& name : skeleton.coordinate_names) out.coordinates.push_back({name});
  for (std::size_t i = 0; i < skeleton.tree.size(); ++i) {
    const Hinge<double>& hinge = skeleton.tree[i];
    const LinkMass& mass = skeleton.masses[i];
    require(mass.segment_without_inertia.empty(),
            "segment '{}' has mass but neither moments of inertia nor a radius",
            mass.segment_without_inertia);
    // Place the joint; body frames are the base frame at the reference posture.
    MechanismJoint joint;
    joint.name = skeleton.hinge_names[i];
    joint.parent = hinge.parent;
    joint.X_PF = joint.X_BM = frame_with_z(hinge.direction, hinge.point);
    joint.coordinate = hinge.coordinate;
    joint.ratio = hinge.ratio;
    joint.offset = hinge.offset;
    // Copy limits and resistance to the hinge named as its coordinate.
    if (joint.name == skeleton.coordinate_names[hinge.coordinate]) {
      const CoordinateLimits& limits = skeleton.limits[hinge.coordinate];
      joint.lower = limits.lower;
      joint.upper = limits.upper;
      joint.stiffness = limits.stiffness;
      joint.rest = limits.rest;
      joint.damping = limits.damping;
    }
    out.joints.push_back(std::move(joint));
    out.bodies.push_back({skeleton.hinge_names[i], {mass.mass, mass.com, mass.inertia}, {}, {}});
  }
  return out;
}

BuiltMechanism robot_mechanism(const RobotSpec& robot) {
  require(robot.open_loops.empty(), "robot '{}' has a loop that is not solved: {}", robot.name,
          robot.open_loops.empty() ? "" : robot.open_loops.front());
  BuiltMechanism out;
  std::map<std::string, int> body_of, coordinate_known;
  // Function that adds a link with its shapes and mass on a joint.
  const auto add = [&](const RobotLink& link, MechanismJoint joint) {
    body_of[link.name] = static_cast<int>(out.mechanism.bodies.size());
    std::shared_ptr<const Solid> solid;
    if (!link.shapes.empty()) solid = std::make_shared<const Solid>(build_solid(link.shapes));
    out.mechanism.bodies.push_back(
        {link.name, link_mass(link, out.warnings), solid, link.material, link.digit});
    out.mechanism.joints.push_back(std::move(joint));
  };
  // Weld the base to the world.
  add(robot.links.front(), {robot.links.front().name + " base", JointKind::kWeld});
  // Add each joint with its child: a weld if fixed, otherwise a hinge or slide of its coordinate.
  for (const RobotJoint& joint : robot.joints) {
    const RobotLink& child = *find_named(robot.links, joint.child);
    const int parent = body_of.at(joint.parent);
    if (joint.kind == RobotJointKind::kFixed) {
      add(child, {joint.name, JointKind::kWeld, parent, joint.X_PJ * joint.X_JC});
      continue;
    }
    MechanismJoint moving = moving_joint(joint, parent);
    moving.coordinate = coordinate_of(robot, joint, coordinate_known, out.mechanism);
    add(child, std::move(moving));
  }
  return out;
}

Mechanism body_mechanism(const PlacedBody& placed, const Materials& materials) {
  Mechanism out;
  MechanismJoint joint{placed.body.name, placed.dynamic ? JointKind::kFree : JointKind::kWeld};
  MechanismBody body;
  body.name = placed.body.name;
  body.material = placed.body.material;
  if (!placed.body.shapes.empty())
    body.solid = std::make_shared<const Solid>(build_solid(placed.body.shapes));
  // Put a free body on a free joint at its centre of mass, and weld an obstacle to the world.
  if (placed.dynamic) {
    body.mass = body_mass(placed.body, materials);
    joint.X_BM.p = body.mass.com;
  } else {
    joint.X_PF = placed.X_WB;
  }
  out.joints.push_back(std::move(joint));
  out.bodies.push_back(std::move(body));
  return out;
}

}  // namespace thenar
