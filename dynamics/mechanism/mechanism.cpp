#include "dynamics/mechanism/mechanism.h"

#include <cmath>
#include <set>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/robot/robot.h"

namespace thenar {
namespace {

constexpr double kRotationError = 1e-9;  // largest |R'R - 1| of a rotation [1]

/// Returns true if a pose is a finite rotation, to kRotationError, and translation.
bool is_rigid(const Pose<double>& X) {
  return X.R.allFinite() && X.p.allFinite() &&
         (X.R.transpose() * X.R - Eigen::Matrix3d::Identity()).norm() < kRotationError &&
         X.R.determinant() > 0;
}

bool is_possible(const BodyMass& body) {
  return body.mass >= 0 && std::isfinite(body.mass) && body.com.allFinite() &&
         body.inertia.allFinite() && is_body_inertia(body.inertia);
}

void check_joint(const Mechanism& mechanism, std::size_t i) {
  const MechanismJoint& joint = mechanism.joints[i];
  require(joint.parent >= -1 && joint.parent < static_cast<int>(i),
          "joint '{}': parents come before children, its parent is body {}", joint.name,
          joint.parent);
  require(is_rigid(joint.X_PF) && is_rigid(joint.X_BM),
          "joint '{}': wanted frames with rotations, to 1e-9", joint.name);
  if (!is_scalar(joint.kind)) return;
  // Check coordinate, numbers, limits and resistances of hinges and slides.
  require(
      joint.coordinate >= 0 && joint.coordinate < static_cast<int>(mechanism.coordinates.size()),
      "joint '{}': there is no coordinate {}", joint.name, joint.coordinate);
  require(std::isfinite(joint.ratio) && std::isfinite(joint.offset) && std::isfinite(joint.rest),
          "joint '{}': wanted finite numbers", joint.name);
  for (const double term : joint.curve)
    require(std::isfinite(term), "joint '{}': wanted finite numbers", joint.name);
  require(joint.lower <= joint.upper, "joint '{}': lower limit {} above upper limit {}", joint.name,
          joint.lower, joint.upper);
  for (const double resistance : {joint.stiffness, joint.damping, joint.friction})
    require(resistance >= 0 && std::isfinite(resistance),
            "joint '{}': wanted stiffness, damping and friction from 0 up, got {}", joint.name,
            resistance);
}

/// Checks that every coordinate moves a joint, and that names of one kind differ.
void check_names(const Mechanism& mechanism) {
  // Check names of bodies and joints; collect the coordinates that move a joint.
  std::set<int> moved;
  std::set<std::string> bodies, joints;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    require(bodies.insert(mechanism.bodies[i].name).second, "two bodies are named '{}'",
            mechanism.bodies[i].name);
    require(joints.insert(mechanism.joints[i].name).second, "two joints are named '{}'",
            mechanism.joints[i].name);
    if (is_scalar(mechanism.joints[i].kind)) moved.insert(mechanism.joints[i].coordinate);
  }
  // Check names of coordinates, and that each moves a joint.
  std::set<std::string> coordinates;
  for (const MechanismCoordinate& coordinate : mechanism.coordinates)
    require(coordinates.insert(coordinate.name).second, "two coordinates are named '{}'",
            coordinate.name);
  for (std::size_t i = 0; i < mechanism.coordinates.size(); ++i)
    require(moved.count(static_cast<int>(i)) == 1, "coordinate '{}' moves no joint",
            mechanism.coordinates[i].name);
}

}  // namespace

MechanismLayout layout_of(const Mechanism& mechanism) {
  MechanismLayout layout;
  layout.coordinate_q.assign(mechanism.coordinates.size(), -1);
  layout.coordinate_v = layout.coordinate_q;
  // Assign entries: balls have 4 positions and 3 velocities, free joints 7 and 6.
  for (const MechanismJoint& joint : mechanism.joints) {
    int first_q = -1, first_v = -1;
    if (is_scalar(joint.kind)) {
      // A shared coordinate has the entry of the first joint that it moves.
      int& slot_q = layout.coordinate_q[joint.coordinate];
      int& slot_v = layout.coordinate_v[joint.coordinate];
      if (slot_q < 0) slot_q = layout.q++, slot_v = layout.v++;
      first_q = slot_q, first_v = slot_v;
    } else if (joint.kind != JointKind::kWeld) {
      first_q = layout.q, first_v = layout.v;
      layout.quaternion_joints.push_back(static_cast<int>(layout.first_q.size()));
      layout.q += joint.kind == JointKind::kBall ? 4 : 7;
      layout.v += joint.kind == JointKind::kBall ? 3 : 6;
    }
    layout.first_q.push_back(first_q);
    layout.first_v.push_back(first_v);
  }
  return layout;
}

Eigen::VectorXd reference_position(const Mechanism& mechanism) {
  const MechanismLayout layout = layout_of(mechanism);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(layout.q);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (layout.first_q[i] >= 0 && !is_scalar(mechanism.joints[i].kind)) q[layout.first_q[i]] = 1;
  return q;
}

void check_mechanism(const Mechanism& mechanism) {
  require(mechanism.bodies.size() == mechanism.joints.size(), "{} bodies have {} joints",
          mechanism.bodies.size(), mechanism.joints.size());
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    check_joint(mechanism, i);
    require(is_possible(mechanism.bodies[i].mass),
            "body '{}': no rigid body has this mass and inertia", mechanism.bodies[i].name);
  }
  check_names(mechanism);
}

int append(Mechanism& whole, const Mechanism& part, const std::string& prefix, int carrier,
           const Pose<double>& X_CW) {
  const int first = static_cast<int>(whole.bodies.size());
  const int coordinates = static_cast<int>(whole.coordinates.size());
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    whole.bodies.push_back(part.bodies[i]);
    whole.bodies.back().name = prefix + part.bodies[i].name;
    // Attach joints on the world to the carrier, and renumber parents and coordinates.
    MechanismJoint joint = part.joints[i];
    joint.name = prefix + joint.name;
    if (joint.parent < 0) joint.X_PF = X_CW * joint.X_PF;
    joint.parent = joint.parent < 0 ? carrier : joint.parent + first;
    if (is_scalar(joint.kind)) joint.coordinate += coordinates;
    whole.joints.push_back(std::move(joint));
  }
  // Append the part's coordinates.
  for (MechanismCoordinate coordinate : part.coordinates) {
    coordinate.name = prefix + coordinate.name;
    whole.coordinates.push_back(std::move(coordinate));
  }
  return first;
}

int body_named(const Mechanism& mechanism, const std::string& name) {
  return static_cast<int>(index_of_name(name, names_of(mechanism.bodies), "body"));
}

int carrier_by_welds(const Mechanism& mechanism, int body) {
  while (body >= 0 && mechanism.joints[body].kind == JointKind::kWeld)
    body = mechanism.joints[body].parent;
  return body;
}

}  // namespace thenar
