// Links, joints and degrees of freedom from TOML.

#include "data/io/robot/robot_parts.h"

#include <cmath>

#include "base/error.h"
#include "data/io/dh.h"
#include "data/io/mesh/shape_toml.h"

namespace thenar::internal {
namespace {

constexpr Measures kTurningMeasures{Dimension::kAngle, Dimension::kMoment,
                                    Dimension::kAngularStiffness, Dimension::kAngularDamping};
constexpr Measures kSlidingMeasures{Dimension::kLength, Dimension::kForce,
                                    Dimension::kLinearStiffness, Dimension::kLinearDamping};

void read_range(TomlTable& table, Dimension dimension, double& lower, double& upper) {
  if (!table.has(dimension, "range")) return;
  const std::vector<double> range = table.numbers(dimension, "range", 2);
  lower = range[0];
  upper = range[1];
}

/// Reads the keys that [[joint]] and a row of [[dh_chain]] share.
void read_drive(TomlTable& table, RobotJoint& joint) {
  // What it moves, and which motor drives it.
  if (table.has("kind")) joint.kind = table.choice("kind", kRobotJointKindNames);
  joint.child = table.text("child");
  joint.dof = table.text_or("dof", "");
  joint.ratio = table.number_or(Dimension::kNumber, "ratio", 1);
  // Numbers in the units of its kind.
  const Measures& in = measures_of(slides(joint));
  read_range(table, in.value, joint.lower, joint.upper);
  joint.offset = table.number_or(in.value, "offset", 0);
  if (table.has("curve")) joint.curve = table.numbers(Dimension::kNumber, "curve");
  joint.rest = table.number_or(in.value, "rest", 0);
  joint.damping = table.number_or(in.damping, "damping", 0);
  joint.friction = table.number_or(in.effort, "friction", 0);
  joint.stiffness = table.number_or(in.stiffness, "stiffness", 0);
}

/// Reads an inertia: diagonal [xx, yy, zz]; [xx, yy, zz, xy, xz, yz]; or all nine, row by row.
Eigen::Matrix3d read_inertia(TomlTable& table) {
  if (!table.has(Dimension::kInertia, "inertia")) return Eigen::Matrix3d::Zero();
  const std::vector<double> I = table.numbers(Dimension::kInertia, "inertia");
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  if (I.size() == 9) {
    inertia << I[0], I[1], I[2], I[3], I[4], I[5], I[6], I[7], I[8];
  } else if (I.size() == 6) {
    inertia << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
  } else if (I.size() == 3) {
    inertia.diagonal() << I[0], I[1], I[2];
  } else {
    table.fail(fmt::format("wanted 3, 6 or 9 numbers in 'inertia', got {}", I.size()), "inertia");
  }
  return inertia;
}

Pose<double> pose_or_none(TomlTable& table, const std::string& key) {
  std::optional<TomlTable> pose = table.table(key);
  if (!pose) return {};
  Pose<double> X = read_pose_keys(*pose);
  pose->done();
  return X;
}

RobotJoint read_row(TomlTable& table) {
  RobotJoint joint;
  joint.name = table.text("joint");
  read_drive(table, joint);
  joint.X_JC = dh_motion(read_dh_row(table));
  table.done();
  check_here(table, [&] { check_joint(joint); });
  return joint;
}

}  // namespace

const Measures& measures_of(bool slides) { return slides ? kSlidingMeasures : kTurningMeasures; }

Eigen::Vector3d read_unit(TomlTable& table, const std::string& key) {
  const Eigen::Vector3d v = table.vector(Dimension::kNumber, key);
  return std::abs(v.norm() - 1) <= kUnitTolerance ? v : read_direction(table, key);
}

RobotLink read_robot_link(TomlTable& table, const std::string& path) {
  RobotLink link;
  link.name = table.text("name");
  // What it is, and what it weighs.
  link.digit = table.text_or("digit", "");
  link.material = table.text_or("material", "");
  link.mass = table.number_or(Dimension::kMass, "mass", 0, Range::kNotNegative);
  link.com = table.vector_or(Dimension::kLength, "com", {0, 0, 0});
  link.inertia = read_inertia(table);
  read_each(table, "shape", link.shapes, read_shape_table, path);
  table.done();
  check_here(table, [&] { check_link(link); });
  return link;
}

RobotJoint read_robot_joint(TomlTable& table) {
  RobotJoint joint;
  joint.name = table.text("name");
  joint.parent = table.text("parent");
  read_drive(table, joint);
  if (table.has(Dimension::kNumber, "axis")) joint.axis = read_unit(table, "axis");
  joint.X_PJ = pose_or_none(table, "frame");
  joint.X_JC = pose_or_none(table, "child_frame");
  table.done();
  check_here(table, [&] { check_joint(joint); });
  return joint;
}

std::vector<RobotJoint> read_robot_dh_chain(TomlTable& table) {
  std::string parent = table.text("parent");
  Pose<double> X = pose_or_none(table, "frame");
  std::vector<RobotJoint> joints;
  // The frame stands before the first joint only.
  for (TomlTable& row : table.tables("rows")) {
    RobotJoint joint = read_row(row);
    joint.parent = parent;
    joint.X_PJ = X;
    X = {};
    parent = joint.child;
    joints.push_back(std::move(joint));
  }
  table.done();
  return joints;
}

RobotDof read_robot_dof(TomlTable& table) {
  RobotDof dof;
  dof.name = table.text("name");
  // Kind of coupling.
  if (table.has("kind")) dof.kind = table.choice("kind", kDriveCouplingNames);
  // Numbers in the units of its joints.
  const bool slides = table.has(Dimension::kLength, "range");
  const Measures& in = measures_of(slides);
  read_range(table, in.value, dof.lower, dof.upper);
  const double rate = table.number_or(Dimension::kNumber, "rate", 0);
  dof.speed = table.number_or(Dimension::kNumber, "speed", rate);
  dof.open = number_if(table, in.value, "open");
  dof.max_effort = table.number_or(in.effort, "max_effort", 0, Range::kNotNegative);
  dof.breakaway = table.number_or(in.effort, "breakaway", 0, Range::kNotNegative);
  dof.stiffness = table.number_or(in.stiffness, "stiffness", 0, Range::kNotNegative);
  dof.backdrivable =
      !table.has("backdrive") || table.choice("backdrive", {"free", "held"}) == "free";
  dof.nominal_effort =
      table.has("effort_is") && table.choice("effort_is", {"published", "nominal"}) == "nominal";
  table.done();
  check_here(table, [&] { check_dof(dof); });
  return dof;
}

}  // namespace thenar::internal
