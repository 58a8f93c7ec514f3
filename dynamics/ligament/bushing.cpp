#include "dynamics/ligament/bushing.h"

#include <algorithm>
#include <cmath>

#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

/// Returns the pose of a body in the world; of the world itself, the identity.
Pose<double> pose_of(const TreeMotion<double>& motion, int body) {
  return body < 0 ? Pose<double>{} : motion.pose(body);
}

/// Returns the pose of a frame in the world.
Pose<double> pose_of(const TreeMotion<double>& motion, const BodyFrame& frame) {
  return pose_of(motion, frame.body) * frame.X_BF;
}

}  // namespace

BushingElement::BushingElement(std::string name, BodyFrame proximal, BodyFrame distal,
                               const BushingLaw& law)
    : name_(std::move(name)),
      proximal_(std::move(proximal)),
      distal_(std::move(distal)),
      law_(law) {
  check_law(law_);
}

bool BushingElement::add_action(const ElementInput& at, ElementAction& out) {
  // Bushing coordinates of the two frames.
  const TreeMotion<double>& motion = at.motion;
  const Pose<double> X_WA = pose_of(motion, proximal_), X_WB = pose_of(motion, distal_);
  const BushingPose pose = bushing_pose(X_WA.inverse() * X_WB);
  if (!pose.rate_map.allFinite()) return false;
  // Jacobian: velocity of B's origin relative to the point of the proximal body there, in axes of
  // A; rates of the angles by the angular velocity of B relative to A.
  const int a = motion.link_of(proximal_.body), b = motion.link_of(distal_.body);
  J_.setZero(at.v.size(), kBushingCoordinates);
  const Eigen::Vector3d zero(0, 0, 0);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d along = X_WA.R.col(k);
    motion.add_relative_jacobian_row(b, a, X_WB.p, along, zero, J_.col(k));
    const Eigen::Vector3d about = X_WA.R * pose.rate_map.row(k).transpose();
    motion.add_relative_jacobian_row(b, a, X_WB.p, zero, about, J_.col(3 + k));
  }
  // Map the action on the coordinates to generalized forces.
  const BushingVector rate = J_.transpose() * at.v;
  const BushingAction action = bushing_action(law_, pose.x, rate);
  out.tau.noalias() += J_ * action.effort;
  out.stiffness.noalias() += J_ * action.stiffness * J_.transpose();
  out.damping.noalias() += J_ * action.damping * J_.transpose();
  return std::abs(pose.x[static_cast<int>(BushingCoordinate::kAbduction)]) < kMaxAbduction;
}

double BushingElement::energy(const ElementInput& at) {
  const BushingPose pose =
      bushing_pose(pose_of(at.motion, proximal_).inverse() * pose_of(at.motion, distal_));
  return bushing_action(law_, pose.x, BushingVector::Zero()).energy;
}

LigamentElement::LigamentElement(std::string name, BodyPoint from, BodyPoint to,
                                 const LigamentLaw& law)
    : name_(std::move(name)), from_(std::move(from)), to_(std::move(to)), law_(law) {
  check_law(law_);
}

bool LigamentElement::add_action(const ElementInput& at, ElementAction& out) {
  // Tension of the ligament along the line between its points.
  const TreeMotion<double>& motion = at.motion;
  const Eigen::Vector3d p = pose_of(motion, from_.body) * from_.p;
  const Eigen::Vector3d span = pose_of(motion, to_.body) * to_.p - p;
  const double length = span.norm();
  const LigamentForce force = ligament_force(law_, length);
  if (force.force == 0 && force.slope == 0) return true;
  const Eigen::Vector3d line = span / length, zero(0, 0, 0);
  // Jacobian of the velocity of one point relative to the other.
  J_.setZero(at.v.size(), 3);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    motion.add_jacobian_row(motion.link_of(to_.body), Eigen::Vector3d(p + span), axis, zero,
                            J_.col(k));
    motion.add_jacobian_row(motion.link_of(from_.body), p, Eigen::Vector3d(-axis), zero, J_.col(k));
  }
  const Eigen::VectorXd row = J_ * line;
  // Damping scales the tension with the strain rate; the ligament never pushes.
  const double strain_rate = row.dot(at.v) / law_.slack_length;
  const double damping_factor = std::max(0.0, 1 + law_.damping * strain_rate);
  const double tension = force.force * damping_factor;
  out.tau -= tension * row;
  if (damping_factor > 0) {
    out.stiffness.noalias() += (force.slope * damping_factor) * row * row.transpose();
    out.damping.noalias() +=
        (force.force * law_.damping / law_.slack_length) * row * row.transpose();
  }
  // Geometric stiffness of the tension, across the line.
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - line * line.transpose();
  out.stiffness.noalias() += J_ * ((tension / length) * across) * J_.transpose();
  return true;
}

double LigamentElement::energy(const ElementInput& at) {
  const Eigen::Vector3d span =
      pose_of(at.motion, to_.body) * to_.p - pose_of(at.motion, from_.body) * from_.p;
  return ligament_force(law_, span.norm()).energy;
}

}  // namespace thenar
