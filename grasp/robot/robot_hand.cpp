#include "grasp/robot/robot_hand.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/parallel_for.h"
#include "data/io/robot/link_poses.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/limits/drive_torques.h"
#include "grasp/robot/robot_tips.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Overlap of limits that counts as rounding: printed numbers have nine decimals [rad] or [m]
constexpr double kLimitRounding = 1e-8;

/// An interval that limits make narrower.
struct AngleInterval {
  double lower = -kInfinity, upper = kInfinity;

  void narrow(double a, double b) {
    lower = std::max(lower, std::min(a, b));
    upper = std::min(upper, std::max(a, b));
  }

  /// Narrows the range by the limits of a joint and of its motor, in units of the coordinate.
  /// @param ratio  motion of the joint per unit of the coordinate
  void narrow(const RobotJoint& joint, double ratio, const RobotDof* dof) {
    if (joint.curve.empty())  // otherwise check_robot() has compared it with its motor's range
      narrow((joint.lower - joint.offset) / ratio, (joint.upper - joint.offset) / ratio);
    if (dof == nullptr) return;
    const double gear = dof->kind == DriveCoupling::kRigid ? 1 : joint.ratio;
    narrow(gear * dof->lower, gear * dof->upper);
  }
};

std::shared_ptr<const Solid> surface_of(const std::string& link,
                                        const std::vector<ShapeSpec>& shapes) {
  try {
    return std::make_shared<Solid>(build_solid(shapes));
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("link '{}': {}; `thenar import` mends meshes", link, error.what()));
  }
}

}  // namespace

RobotHand::RobotHand(const RobotSpec& robot) : dofs_(static_cast<int>(robot.dofs.size())) {
  // The order matters: surfaces and drives refer to movers and coordinates.
  check_robot(robot);
  add_movers(robot);
  add_coordinates(robot);
  add_drives(robot);
  add_surfaces(robot);
  set_open_posture(robot);
  // Tips belong to the links of the Hand that carry them.
  for (const RobotTip& tip : find_tips(robot, reference_)) {
    layout_.tips.push_back(tip.digit);
    layout_.tip_points.push_back({tip.digit, mover_of_[tip.link], tip.p});
  }
  layout_.approach = {robot.approach.point, robot.approach.direction};
}

void RobotHand::add_movers(const RobotSpec& robot) {
  // Index of each link by name.
  std::map<std::string, std::size_t> index;
  for (const RobotLink& link : robot.links) {
    index[link.name] = links_.size();
    links_.push_back(link.name);
  }
  mover_of_.assign(links_.size(), -1);
  reference_.resize(links_.size());
  for (const RobotJoint& joint : robot.joints) {
    const std::size_t parent = index[joint.parent], child = index[joint.child];
    // Pose in the reference posture: joints at their offsets.
    const Pose<double> X = reference_[parent] * joint.X_PJ;
    const bool moves = joint.kind != RobotJointKind::kFixed;
    reference_[child] = X * (moves ? joint_motion(joint, joint.offset) * joint.X_JC : joint.X_JC);
    mover_of_[child] = mover_of_[parent];
    // Links behind fixed joints belong to the mover that carries them.
    if (!moves) continue;
    mover_of_[child] = static_cast<int>(movers_.size());
    layout_.parents.push_back(mover_of_[parent]);
    movers_.push_back({mover_of_[parent], 0, place_named(robot.dofs, joint.dof),
                       joint.kind == RobotJointKind::kPrismatic, false, 1, joint.ratio,
                       (X.R * joint.axis).normalized(), X.p, joint.stiffness,
                       joint.rest - joint.offset, joint.curve});
  }
}

void RobotHand::add_coordinates(const RobotSpec& robot) {
  std::vector<AngleInterval> limits;
  std::vector<int> shared(robot.dofs.size(), -1);  // coordinate of a rigid degree of freedom
  std::size_t next = 0;
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    Mover& mover = movers_[next++];
    // Rigid degrees of freedom share one coordinate; other joints have their own.
    const RobotDof* dof = mover.dof < 0 ? nullptr : &robot.dofs[mover.dof];
    const bool rigid = dof != nullptr && dof->kind == DriveCoupling::kRigid;
    mover.shared = rigid;
    if (rigid) mover.ratio = joint.ratio;
    mover.coordinate = rigid ? shared[mover.dof] : -1;
    if (mover.coordinate < 0) {
      mover.coordinate = static_cast<int>(limits.size());
      limits.emplace_back();
      layout_.coordinates.push_back(rigid ? dof->name : joint.name);
      if (rigid) shared[mover.dof] = mover.coordinate;
    }
    limits[mover.coordinate].narrow(joint, mover.ratio, dof);
  }
  // A value must exist that satisfies all limits.
  layout_.lower.resize(static_cast<Eigen::Index>(limits.size()));
  layout_.upper.resize(static_cast<Eigen::Index>(limits.size()));
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const AngleInterval& limit = limits[i];
    require(limit.lower <= limit.upper + kLimitRounding,
            "limits of '{}' and of what it drives leave nothing: {} .. {}", layout_.coordinates[i],
            limit.lower, limit.upper);
    layout_.lower[i] = limit.lower;
    layout_.upper[i] = std::max(limit.lower, limit.upper);
  }
}

void RobotHand::add_drives(const RobotSpec& robot) {
  std::vector<double> max_effort;
  for (int d = 0; d < dofs_; ++d) {
    const RobotDof& dof = robot.dofs[d];
    const bool rigid = dof.kind == DriveCoupling::kRigid;
    Drive drive{dof.name, dof.kind, {}, dof.speed, dof.breakaway, dof.backdrivable};
    // A rigid drive moves its one coordinate, others move each joint by its ratio.
    for (const Mover& mover : movers_)
      if (mover.dof == d && (!rigid || drive.moves.empty()))
        drive.moves.push_back({mover.coordinate, rigid ? 1 : mover.dof_ratio});
    if (drive.moves.empty()) continue;  // a motor without a joint
    // Unknown and nominal efforts count as unlimited.
    layout_.actuators.push_back(dof.name);
    const bool known = dof.max_effort > 0 && !dof.nominal_effort;
    max_effort.push_back(known ? dof.max_effort : kInfinity);
    layout_.drives.push_back(std::move(drive));
  }
  max_effort_ = Eigen::Map<const Eigen::VectorXd>(max_effort.data(),
                                                  static_cast<Eigen::Index>(max_effort.size()));
}

/// Sets the posture in which closing begins, if any motor states a position.
void RobotHand::set_open_posture(const RobotSpec& robot) {
  if (!any_of(robot.dofs, [](const RobotDof& dof) { return dof.open.has_value(); })) return;
  Eigen::VectorXd open = open_posture(layout_);
  for (const Mover& mover : movers_) {
    if (mover.dof < 0) continue;
    const std::optional<double>& at = robot.dofs[mover.dof].open;
    if (at) open[mover.coordinate] = mover.shared ? *at : mover.dof_ratio * *at;
  }
  layout_.open = open.cwiseMax(layout_.lower).cwiseMin(layout_.upper);
}

void RobotHand::add_surfaces(const RobotSpec& robot) {
  // Solids are built in parallel, as this is slow.
  std::vector<std::size_t> with_shapes;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (!robot.links[i].shapes.empty()) with_shapes.push_back(i);
  surfaces_.resize(with_shapes.size());
  parallel_for(with_shapes.size(), [&](std::size_t s) {
    const std::size_t i = with_shapes[s];
    const RobotLink& link = robot.links[i];
    // Shapes in the hand's frame at the reference posture.
    std::vector<ShapeSpec> shapes = link.shapes;
    for (ShapeSpec& shape : shapes) shape.X_BS = reference_[i] * shape.X_BS;
    surfaces_[s] = {mover_of_[i], link.name, link.digit, link.material,
                    surface_of(link.name, shapes)};
  });
}

double RobotHand::Mover::motion(double q) const {
  // Horner's scheme for ratio q + curve.
  double bent = 0;
  for (auto c = curve.rbegin(); c != curve.rend(); ++c) bent = (bent + *c) * q;
  return (ratio + bent) * q;
}

double RobotHand::Mover::slope(double q) const {
  double bent = 0;
  for (std::size_t k = curve.size(); k-- > 0;)
    bent = (bent + static_cast<double>(k + 2) * curve[k]) * q;
  return ratio + bent;
}

std::vector<Pose<double>> RobotHand::pose(const Eigen::VectorXd& q) const {
  require_posture(q);
  std::vector<Pose<double>> X(movers_.size());
  // Displacement of each mover, composed with that of its parent.
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Mover& mover = movers_[i];
    const double value = mover.motion(q[mover.coordinate]);
    Pose<double> motion;
    if (mover.is_prismatic)
      motion.p = value * mover.direction;
    else
      motion = screw_motion(mover.direction, mover.point, value);
    X[i] = mover.parent < 0 ? motion : X[mover.parent] * motion;
  }
  return X;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> RobotHand::jacobian(const Eigen::VectorXd& q, int link,
                                                             const Vector3d& p) const {
  const int count = static_cast<int>(movers_.size());
  require(link >= -1 && link < count, "no link {}; there are {}", link, count);
  const std::vector<Pose<double>> X = pose(q);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, q.size());
  J.setZero();
  const Vector3d at = link < 0 ? p : Vector3d(X[link] * p);
  // Columns of all movers between the link and the base.
  for (int i = link; i >= 0; i = movers_[i].parent) {
    const Mover& mover = movers_[i];
    const Pose<double>& now = X[i];
    const Vector3d axis = mover.slope(q[mover.coordinate]) * (now.R * mover.direction);
    if (mover.is_prismatic) {
      J.col(mover.coordinate).tail<3>() += axis;
    } else {
      J.col(mover.coordinate).head<3>() += axis;
      J.col(mover.coordinate).tail<3>() += axis.cross(at - now * mover.point);
    }
  }
  return J;
}

Actuation RobotHand::actuation(const Eigen::VectorXd& q) const {
  require_posture(q);
  // Torques of the joint springs.
  Eigen::VectorXd tau_0 = Eigen::VectorXd::Zero(q.size());
  for (const Mover& mover : movers_) {
    const double at = q[mover.coordinate];
    tau_0[mover.coordinate] +=
        mover.slope(at) * mover.stiffness * (mover.stretch - mover.motion(at));
  }
  // Torques of the motors through gears and clutches.
  DriveTorques drives = drive_torques(layout_, q);
  return {drives.B, tau_0, -max_effort_, max_effort_, std::move(drives.reactions)};
}

Eigen::VectorXd RobotHand::posture(const Eigen::VectorXd& dofs) const {
  require(dofs.size() == dofs_, "the robot has {} degrees of freedom, got values of {}", dofs_,
          dofs.size());
  Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(layout_.coordinates.size()));
  for (const Mover& mover : movers_)
    if (mover.dof >= 0)
      q[mover.coordinate] = mover.shared ? dofs[mover.dof] : mover.dof_ratio * dofs[mover.dof];
  return q;
}

std::vector<Pose<double>> RobotHand::link_frames(const Eigen::VectorXd& q) const {
  const std::vector<Pose<double>> X = pose(q);
  std::vector<Pose<double>> frames = reference_;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (mover_of_[i] >= 0) frames[i] = X[mover_of_[i]] * frames[i];
  return frames;
}

Vector3d RobotHand::axis(const Eigen::VectorXd& q, int link) const {
  const Mover& mover = movers_[link];
  if (mover.is_prismatic) return Vector3d::Zero();
  return pose(q)[link].R * mover.direction;
}

void RobotHand::require_posture(const Eigen::VectorXd& q) const {
  require(q.size() == static_cast<Eigen::Index>(layout_.coordinates.size()),
          "the hand has {} coordinates, q has {}", layout_.coordinates.size(), q.size());
}

}  // namespace thenar
