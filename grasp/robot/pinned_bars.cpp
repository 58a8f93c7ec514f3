#include "grasp/robot/pinned_bars.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/lists.h"
#include "data/io/robot/link_poses.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kMaxPinMotion = 1e-4;    // motion of a pin relative to the parts it joins [m]
constexpr double kMinBarRotation = 0.02;  // rotation of a bar relative to its finger [rad]
// Maximum distance of a pin from a part that it joins, over the part's diagonal [1]
constexpr double kMaxPinDistance = 0.25;
constexpr double kPinRankTolerance = 1e-6;  // relative singular values that count as zero [1]
// Range assumed in both directions for a motor without limits [rad] or [m]
constexpr double kAssumedRange = 1;

/// Computes the bounding box of a body's shapes in its frame.
AlignedBox3d box_of(const RobotSpec& robot, const RigidBody& body,
                    const std::vector<Pose<double>>& links) {
  AlignedBox3d box;
  for (const std::size_t i : body.links)
    for (const ShapeSpec& shape : robot.links[i].shapes) {
      const bool is_mesh = shape.kind == ShapeKind::kMesh;
      const TriangleMesh solid = is_mesh ? shape.mesh : build_solid({shape}).visual;
      const Pose<double> X =
          links[body.links.front()].inverse() * links[i] * (is_mesh ? shape.X_BS : Pose<double>{});
      for (const auto& p : solid.vertices.colwise()) box.extend(X * Vector3d(p));
    }
  return box;
}

/// Poses of a robot's links at the ends and in the middle of a motor's range.
using Instants = std::array<std::vector<Pose<double>>, 3>;

Instants instants_of(const RobotSpec& robot, const RobotDof& dof) {
  const double lower = std::isfinite(dof.lower) ? dof.lower : -kAssumedRange,
               upper = std::isfinite(dof.upper) ? dof.upper : kAssumedRange;
  Instants all;
  for (int k = 0; k < 3; ++k)
    all[k] = link_poses(robot, {{dof.name, lower + 0.5 * k * (upper - lower)}});
  return all;
}

/// Returns whether there is an axis near both bodies that is at rest in both.
bool are_pinned(const RobotSpec& robot, const RigidBody& bar, const RigidBody& finger,
                const Instants& instants) {
  // Poses of the bar in the finger; it must rotate.
  std::array<Pose<double>, 3> X_FB;
  for (std::size_t k = 0; k < 3; ++k)
    X_FB[k] = instants[k][finger.links.front()].inverse() * instants[k][bar.links.front()];
  const Eigen::AngleAxisd turn(X_FB[0].R.transpose() * X_FB[2].R);
  if (std::abs(turn.angle()) < kMinBarRotation) return false;
  const AlignedBox3d bar_box = box_of(robot, bar, instants[0]),
                     finger_box = box_of(robot, finger, instants[0]);
  if (bar_box.isEmpty() || finger_box.isEmpty()) return false;
  // Find the point of the bar nearest to its centre c that does not move: X_k b = X_0 b.
  const Vector3d c = bar_box.center();
  Eigen::MatrixXd equations(6, 3);
  Eigen::VectorXd right(6);
  for (std::size_t k = 1; k < 3; ++k) {
    const auto row = static_cast<Eigen::Index>(3 * (k - 1));
    equations.block<3, 3>(row, 0) = X_FB[k].R - X_FB[0].R;
    right.segment<3>(row) = X_FB[0] * c - X_FB[k] * c;
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> solver(equations, Eigen::ComputeThinU | Eigen::ComputeThinV);
  solver.setThreshold(kPinRankTolerance);
  const Vector3d off = solver.solve(right);
  if ((equations * off - right).lpNorm<Eigen::Infinity>() > kMaxPinMotion) return false;
  // The pin must be near both bodies.
  const Vector3d pin = c + off;
  return bar_box.exteriorDistance(pin) < kMaxPinDistance * bar_box.diagonal().norm() &&
         finger_box.exteriorDistance(X_FB[0] * pin) <
             kMaxPinDistance * finger_box.diagonal().norm();
}

/// Returns whether a motor alone moves a body relative to another that carries it over at least two
/// joints.
bool is_carried_over_two_joints(const std::vector<RigidBody>& list, std::size_t body,
                                std::size_t on, const std::string& dof) {
  int joints = 0;
  for (; body != on; body = list[body].parent) {
    if (body == 0 || list[body].joint->dof != dof) return false;
    ++joints;
  }
  return joints >= 2;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> pinned_bars(const RobotSpec& robot,
                                                             const RigidBodies& bodies) {
  const std::vector<RigidBody>& list = bodies.bodies;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const RobotDof& dof : robot.dofs) {
    // Bars of this motor.
    const auto is_bar = [&](const RigidBody& body) {
      return body.joint != nullptr && body.branches == 0 && body.joint->dof == dof.name &&
             body.joint->kind == RobotJointKind::kRevolute;
    };
    if (!any_of(list, is_bar)) continue;
    // Fingers to which they are pinned.
    const Instants instants = instants_of(robot, dof);
    for (std::size_t bar = 1; bar < list.size(); ++bar) {
      if (!is_bar(list[bar])) continue;
      for (std::size_t finger = 1; finger < list.size(); ++finger)
        if (is_carried_over_two_joints(list, finger, list[bar].parent, dof.name) &&
            are_pinned(robot, list[bar], list[finger], instants)) {
          pairs.emplace_back(bar, finger);
          break;
        }
    }
  }
  return pairs;
}

}  // namespace thenar
