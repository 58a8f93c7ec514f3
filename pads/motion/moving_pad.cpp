#include "pads/motion/moving_pad.h"

#include <cmath>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kDifferenceWay = 1e-6;  // displacement of the stiffness differences [m]
// Lever arm at which the rotation of a difference causes that displacement [m]
constexpr double kTurnArm = 10e-3;

}  // namespace

Matrix6 MovingPad::stiffness(const Eigen::Matrix<double, 6, 1>& onward) {
  // Compute the wrench at the kept pose.
  const Pose<double> from = object_pose();
  const PadContact at = try_step(from, 0);
  const Eigen::Matrix<double, 6, 1> before = wrench_vector(at.push);
  Matrix6 out = Matrix6::Zero();
  if (at.status != Status::kSolved) return out;
  // Take a difference onward in each direction, or backward where the step fails.
  for (int k = 0; k < 6; ++k) {
    Eigen::Matrix<double, 6, 1> motion = Eigen::Matrix<double, 6, 1>::Zero();
    motion[k] = std::copysign(k < 3 ? kDifferenceWay / kTurnArm : kDifferenceWay, onward[k]);
    PadContact after = try_step(moved_by(from, motion), 0);
    if (after.status != Status::kSolved) {
      motion = -motion;
      after = try_step(moved_by(from, motion), 0);
    }
    if (after.status == Status::kSolved)
      out.col(k) = (wrench_vector(after.push) - before) / motion[k];
  }
  return out;
}

PadContact behind_object() {
  PadContact out;
  out.status = Status::kStalled;
  out.message = "the undeformed skin lies beyond the middle of the object: it is too thin";
  return out;
}

Pose<double> moved_by(const Pose<double>& X, const Eigen::Matrix<double, 6, 1>& motion) {
  const Eigen::Vector3d turn = motion.head<3>();
  const double angle = turn.norm();
  Pose<double> D;
  if (angle > 0) D.R = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  D.p = motion.tail<3>();
  return D * X;
}

Eigen::Matrix<double, 6, 1> motion_from(const Pose<double>& from, const Pose<double>& to) {
  const Pose<double> D = to * from.inverse();
  const Eigen::AngleAxisd turn(D.R);
  Eigen::Matrix<double, 6, 1> out;
  out << turn.angle() * turn.axis(), D.p;
  return out;
}

}  // namespace thenar
