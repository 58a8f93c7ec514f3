#include "data/io/robot/robot.h"

#include <cmath>
#include <map>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/robot_parts.h"

namespace thenar {

bool take_effort_of_speed(RobotDof& dof) {
  if (dof.effort_up == dof.effort_down || dof.speed == 0) return false;
  dof.max_effort = dof.speed > 0 ? dof.effort_up : dof.effort_down;
  return true;
}

bool slides(const RobotJoint& joint) { return joint.kind == RobotJointKind::kPrismatic; }

bool slides(const RobotSpec& robot, const RobotDof& dof) {
  for (const RobotJoint& joint : robot.joints)
    if (joint.dof == dof.name) return slides(joint);
  return false;
}

std::set<std::string> digits_in(const RobotSpec& robot) {
  std::set<std::string> digits;
  for (const RobotLink& link : robot.links)
    if (!link.digit.empty()) digits.insert(link.digit);
  return digits;
}

bool any_speed(const RobotSpec& robot) {
  return any_of(robot.dofs, [](const RobotDof& dof) { return dof.speed != 0; });
}

namespace {

template <typename Part>
std::set<std::string> names_in(const std::vector<Part>& parts) {
  std::set<std::string> names;
  for (const Part& part : parts) names.insert(part.name);
  return names;
}

/// Renames parts whose names are taken.
class Renaming {
 public:
  Renaming(std::set<std::string> taken, std::string prefix)
      : taken_(std::move(taken)), prefix_(std::move(prefix)) {}

  [[nodiscard]] std::string operator()(const std::string& name) const {
    return taken_.count(name) == 1 ? prefix_ + name : name;
  }

 private:
  std::set<std::string> taken_;
  std::string prefix_;
};

/// The fixed joint between a carrier and a tool.
RobotJoint mount(const std::string& name, const std::string& link, const std::string& base,
                 const Pose<double>& X_LT) {
  RobotJoint joint;
  joint.name = name + " mount";
  joint.kind = RobotJointKind::kFixed;
  joint.parent = link;
  joint.child = base;
  joint.X_PJ = X_LT;
  return joint;
}

/// Pose of a link in the base link with every joint at its offset.
Pose<double> pose_at_zero(const RobotSpec& robot, std::string link) {
  Pose<double> X;
  for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
    if (joint->child != link) continue;
    X = joint->X_PJ * joint_motion(*joint, joint->offset) * joint->X_JC * X;
    link = joint->parent;
  }
  return X;
}

std::string joined(const std::string& a, const std::string& b) {
  if (a.empty() || a == b) return b;
  return b.empty() ? a : a + ", " + b;
}

void add_renamed(RobotSpec& robot, const RobotSpec& tool) {
  const std::string prefix = tool.name + "/";
  // A name that both have gets the tool's name in front.
  const Renaming link_name(names_in(robot.links), prefix);
  const Renaming joint_name(names_in(robot.joints), prefix);
  const Renaming dof_name(names_in(robot.dofs), prefix);
  const Renaming digit_name(digits_in(robot), prefix);
  // Links, joints, loops and degrees of freedom under their new names.
  for (RobotLink link : tool.links) {
    link.name = link_name(link.name);
    link.digit = digit_name(link.digit);
    robot.links.push_back(std::move(link));
  }
  for (RobotJoint joint : tool.joints) {
    joint.name = joint_name(joint.name);
    joint.parent = link_name(joint.parent);
    joint.child = link_name(joint.child);
    joint.dof = dof_name(joint.dof);
    robot.joints.push_back(std::move(joint));
  }
  for (const auto& [a, b] : tool.joined) robot.joined.emplace_back(link_name(a), link_name(b));
  for (RobotDof dof : tool.dofs) {
    dof.name = dof_name(dof.name);
    robot.dofs.push_back(std::move(dof));
  }
}

}  // namespace

RobotSpec attach(const RobotSpec& carrier, const std::string& link, const RobotSpec& tool,
                 const Pose<double>& X_LT) {
  check_robot(carrier);
  check_robot(tool);
  // The link must exist.
  const std::set<std::string> links = names_in(carrier.links);
  require(links.count(link) == 1, "robot '{}' has no link '{}' to mount '{}' on; it has {}",
          carrier.name, link, tool.name, fmt::join(links, ", "));

  RobotSpec robot = carrier;
  // A carrier that states no closing stands still.
  if (!carrier.closing_stated)
    for (RobotDof& dof : robot.dofs) dof.speed = 0;
  robot.closing_stated = tool.closing_stated;
  // Name and sources of both.
  robot.name = carrier.name + " with " + tool.name;
  robot.source = joined(carrier.source, tool.source);
  robot.licence = joined(carrier.licence, tool.licence);
  const std::string base = Renaming(links, tool.name + "/")(tool.links.front().name);
  robot.joints.push_back(mount(tool.name, link, base, X_LT));
  add_renamed(robot, tool);

  // The robot approaches as its tool does.
  const Pose<double> X_BT = pose_at_zero(carrier, link) * X_LT;
  robot.approach = {X_BT * tool.approach.point, (X_BT.R * tool.approach.direction).normalized()};
  robot.approach_stated = tool.approach_stated;
  robot.files.insert(tool.files.begin(), tool.files.end());
  append_all(robot.open_loops, tool.open_loops);
  append_all(robot.warnings, tool.warnings);
  check_robot(robot);
  return robot;
}

namespace {

void require_finite(double value, const std::string& whose, const char* what) {
  require(std::isfinite(value), "wanted the {} of {} to be finite, got {}", what, whose, value);
}

void require_not_negative(double value, const std::string& whose, const char* what) {
  require_finite(value, whose, what);
  require(value >= 0, "wanted the {} of {} >= 0, got {}", what, whose, value);
}

void require_unit(const Eigen::Vector3d& v, const std::string& whose, const char* what) {
  require(std::abs(v.norm() - 1) <= internal::kUnitTolerance,
          "wanted the {} of {} as a unit vector, got [{}, {}, {}]", what, whose, v.x(), v.y(),
          v.z());
}

void require_limits(double lower, double upper, const std::string& whose) {
  require_finite(lower, whose, "lower limit");
  require_finite(upper, whose, "upper limit");
  require(lower <= upper, "limits of {} cross: {} .. {}", whose, lower, upper);
}

template <typename Part>
void require_own_names(const std::vector<Part>& parts, const char* kind) {
  std::set<std::string> names;
  for (const Part& part : parts) {
    require(!part.name.empty(), "a {} has no name", kind);
    require(names.insert(part.name).second, "{} '{}' is given twice", kind, part.name);
  }
}

/// Returns whether following parents from a joint leads back to its child, in any order of the
/// joints.
bool closes_loop(const std::map<std::string, std::string>& parent_of, const RobotJoint& joint) {
  std::string link = joint.parent;
  for (std::size_t step = 0; step <= parent_of.size(); ++step) {
    if (link == joint.child) return true;
    const auto found = parent_of.find(link);
    if (found == parent_of.end()) return false;
    link = found->second;
  }
  return true;
}

void check_tree(const RobotSpec& robot) {
  // Every joint has known ends, and every link one parent.
  std::map<std::string, std::string> parent_of;
  for (const RobotLink& link : robot.links) parent_of[link.name] = "";
  for (const RobotJoint& joint : robot.joints) {
    for (const std::string& link : {joint.parent, joint.child})
      require(parent_of.count(link) == 1, "joint '{}' names link '{}', which there is not",
              joint.name, link);
    require(parent_of[joint.child].empty(), "link '{}' has two parents: '{}' and '{}'", joint.child,
            parent_of[joint.child], joint.parent);
    parent_of[joint.child] = joint.parent;
  }
  // Joints in order from the base, without a loop.
  const std::string& base = robot.links.front().name;
  std::set<std::string> reached{base};
  for (const RobotJoint& joint : robot.joints) {
    require(!closes_loop(parent_of, joint), "joint '{}' closes a loop: '{}' carries '{}' already",
            joint.name, joint.child, joint.parent);
    require(joint.child != base, "the first link, '{}', is the base, and joint '{}' moves it", base,
            joint.name);
    require(reached.count(joint.parent) == 1,
            "joint '{}' appears before the joint that carries its parent '{}'", joint.name,
            joint.parent);
    reached.insert(joint.child);
  }
  // No link is left over.
  for (const RobotLink& link : robot.links)
    require(reached.count(link.name) == 1, "link '{}' hangs on no joint", link.name);
}

constexpr int kCurveIntervals = 256;  // Intervals of a motor's range at which a curve is checked
constexpr double kLimitTolerance = 1e-6;  // Largest excess over a joint's limits there [rad] or [m]

/// Checks that a joint that follows its motor along a curve stays within its limits everywhere.
void check_curve(const RobotJoint& joint, const RobotDof& dof) {
  require(dof.kind == DriveCoupling::kRigid,
          "joint '{}' follows '{}' along a curve: wanted a rigid "
          "degree of freedom",
          joint.name, dof.name);
  for (int i = 0; i <= kCurveIntervals; ++i) {
    const double u = dof.lower + (dof.upper - dof.lower) * i / kCurveIntervals;
    const double value = joint_value(joint, u);
    require(value >= joint.lower - kLimitTolerance && value <= joint.upper + kLimitTolerance,
            "joint '{}' is at {:.6g} where '{}' is at {:.6g}: its limits are {:.6g} .. {:.6g}",
            joint.name, value, dof.name, u, joint.lower, joint.upper);
  }
}

void check_drives(const RobotSpec& robot) {
  for (const RobotJoint& joint : robot.joints)
    for (const RobotDof& dof : robot.dofs)
      if (dof.name == joint.dof && !joint.curve.empty()) check_curve(joint, dof);
  for (const RobotJoint& joint : robot.joints)
    require(joint.dof.empty() || find_named(robot.dofs, joint.dof) != nullptr,
            "joint '{}' is driven by '{}', which is not a degree of freedom", joint.name,
            joint.dof);
}

}  // namespace

bool is_body_inertia(const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite()) return false;
  // Symmetric, with principal moments that satisfy the triangle inequality.
  const double tolerance = 1e-6 * inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > tolerance) return false;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return moments[0] >= -tolerance && moments[2] <= moments[0] + moments[1] + tolerance;
}

namespace internal {

void check_pose(const Pose<double>& X, const std::string& whose) {
  require(X.p.allFinite(), "wanted the position of {} to be finite, got [{}, {}, {}]", whose,
          X.p.x(), X.p.y(), X.p.z());
  const double off = (X.R * X.R.transpose() - Eigen::Matrix3d::Identity()).norm();
  require(off <= kUnitTolerance && X.R.determinant() > 0,
          "wanted the rotation of {} to be one, but R R' - I is {:.3g}, its determinant {:.3g}",
          whose, off, X.R.determinant());
}

void check_shape(const ShapeSpec& shape, const std::string& whose) {
  check_pose(shape.X_BS, whose);
  for (int i = 0; i < 3; ++i)
    require(std::isfinite(shape.size[i]) && shape.size[i] >= 0,
            "wanted size {} of {} finite and >= 0, got {}", i + 1, whose, shape.size[i]);
  require(std::isfinite(shape.mesh_scale) && shape.mesh_scale > 0,
          "wanted the scale of {} > 0, got {}", whose, shape.mesh_scale);
  require(shape.mesh.vertices.allFinite(), "a vertex of {} is not finite", whose);
}

void check_link(const RobotLink& link) {
  const std::string whose = fmt::format("link '{}'", link.name);
  require_not_negative(link.mass, whose, "mass");
  require(link.com.allFinite(), "wanted the centre of mass of {} to be finite, got [{}, {}, {}]",
          whose, link.com.x(), link.com.y(), link.com.z());
  require(is_body_inertia(link.inertia), "the inertia of {} is not a body's", whose);
  for (const ShapeSpec& shape : link.shapes)
    check_shape(shape, fmt::format("a {} of {}", name_of(shape.kind), whose));
}

void check_joint(const RobotJoint& joint) {
  const std::string whose = fmt::format("joint '{}'", joint.name);
  check_pose(joint.X_PJ, whose);
  check_pose(joint.X_JC, "the child of " + whose);
  require_unit(joint.axis, whose, "axis");
  require_limits(joint.lower, joint.upper, whose);
  require_finite(joint.offset, whose, "offset");
  require_finite(joint.rest, whose, "rest");
  require_finite(joint.ratio, whose, "ratio");
  // What drives the joint must fit its kind.
  require(joint.dof.empty() || joint.ratio != 0 || !joint.curve.empty(),
          "{} cannot follow '{}' with ratio 0", whose, joint.dof);
  require(joint.dof.empty() || joint.kind != RobotJointKind::kFixed,
          "{} is fixed and cannot follow '{}'", whose, joint.dof);
  for (const double coefficient : joint.curve) require_finite(coefficient, whose, "curve");
  require(joint.curve.empty() || !joint.dof.empty(), "{} has a curve and follows nothing", whose);
  // Passive torques only resist.
  require_not_negative(joint.damping, whose, "damping");
  require_not_negative(joint.friction, whose, "friction");
  require_not_negative(joint.stiffness, whose, "stiffness");
}

void check_dof(const RobotDof& dof) {
  const std::string whose = fmt::format("degree of freedom '{}'", dof.name);
  require_limits(dof.lower, dof.upper, whose);
  require_finite(dof.speed, whose, "speed");
  require(!dof.open || (*dof.open >= dof.lower && *dof.open <= dof.upper),
          "{} begins closing at {}, its range is {:.6g} .. {:.6g}", whose, dof.open.value_or(0),
          dof.lower, dof.upper);
  require_not_negative(dof.max_effort, whose, "effort");
  require_not_negative(dof.breakaway, whose, "breakaway torque");
  require_not_negative(dof.stiffness, whose, "stiffness");
}

}  // namespace internal

void check_robot(const RobotSpec& robot) {
  require(!robot.links.empty(), "robot '{}' has no link", robot.name);
  require(robot.links.size() <= kMaxLinks, "robot '{}' has {} links, more than {}", robot.name,
          robot.links.size(), kMaxLinks);
  // Names, then each part by itself, then their relations.
  require_own_names(robot.links, "link");
  require_own_names(robot.joints, "joint");
  require_own_names(robot.dofs, "degree of freedom");
  for (const RobotLink& link : robot.links) internal::check_link(link);
  for (const RobotJoint& joint : robot.joints) internal::check_joint(joint);
  for (const RobotDof& dof : robot.dofs) internal::check_dof(dof);
  check_tree(robot);
  check_drives(robot);
  require(robot.approach.point.allFinite(), "the approach of robot '{}' is not finite", robot.name);
  require_unit(robot.approach.direction, fmt::format("robot '{}'", robot.name), "approach");
}

}  // namespace thenar
