#include "grasp/closing/approach_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/spatial.h"
#include "base/units.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/fingertip_paths.h"

namespace thenar {
namespace {

constexpr double kStartClearance = 1e-3;  // clearance between hand and object at the start [m]
// Maximum offset of the aim from the centre, for approaches along an axis, over the radius [1]
constexpr double kMaxAxisAimOffset = 0.1;
// Maximum offset of the aim from the centre, for free approaches, over the radius [1]
constexpr double kMaxFreeAimOffset = 0.5;
constexpr int kOpenPostureInterval = 4;  // one in this many approaches starts with the open hand

/// Random numbers of one approach, uniform in [0, 1).
struct StartDraws {
  double kind, side, half_turn;
  std::array<double, 3> turn, aim;
};

StartDraws draw_start(std::mt19937& random) {
  std::array<double, 9> u{};
  for (double& each : u) each = sample_uniform(random);
  return {u[0], u[1], u[2], {u[3], u[4], u[5]}, {u[6], u[7], u[8]}};
}

/// Maps the first two numbers to a uniform point on the unit sphere. (3)
Eigen::Vector3d point_on_sphere(const std::array<double, 3>& u) {
  const double z = 2 * u[0] - 1, turn = 2 * kPi * u[1];
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Maps three numbers to a uniform point in the unit ball. (3)
Eigen::Vector3d point_in_ball(const std::array<double, 3>& u) {
  return point_on_sphere(u) * std::cbrt(u[2]);
}

/// Returns the rotation that maps direction a to A, and b, perpendicular to a, to B.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& A, const Eigen::Vector3d& B) {
  Eigen::Matrix3d from, to;
  from << b, a.cross(b), a;
  to << B, A.cross(B), A;
  return to * from.transpose();
}

/// Returns the orientation R_WH of an approach along an axis of the object's box.
Eigen::Matrix3d axis_orientation(const CollisionHand& hand, const Eigen::VectorXd& q,
                                 const GraspBody& object, const StartDraws& u) {
  // Side of the box from which the hand comes.
  const Eigen::Matrix3d axes = object.X_WB.R * object.box.axes;
  const int side = std::min(5, static_cast<int>(6 * u.side));
  const int from = side / 2, shorter = from == 2 ? 1 : 2;
  const Eigen::Vector3d towards = (side % 2 == 0 ? 1.0 : -1.0) * axes.col(from);
  // The hand closes across the shorter of the other two axes.
  const Eigen::Vector3d across = (u.half_turn < 0.5 ? 1.0 : -1.0) * axes.col(shorter);
  const Eigen::Vector3d closing = fingertip_paths(*hand.hand, q).axis;
  return rotation_between(hand.hand->layout().approach.direction, closing, towards, across);
}

/// Returns the orientation R_WH of an approach in any direction.
Eigen::Matrix3d free_orientation(const CollisionHand& hand, const StartDraws& u) {
  const Eigen::Vector3d towards = point_on_sphere(u.turn),
                        &d = hand.hand->layout().approach.direction;
  return rotation_about<double>(towards, 2 * kPi * u.turn[2]) *
         rotation_between(d, tangents(d).e1, towards, tangents(towards).e1);
}

/// Returns the maximum distance of any surface from the point of approach [m].
double hand_reach(const CollisionHand& hand, const Eigen::VectorXd& q) {
  const PalmApproach& approach = hand.hand->layout().approach;
  const std::vector<Pose<double>> links = hand.hand->pose(q);
  double reach = 0;
  for (std::size_t s = 0; s < hand.trees.size(); ++s) {
    // Bounding ball of the surface, moved with its link.
    const Ball& ball = hand.trees[s].nodes[0].ball;
    const Eigen::Vector3d c = moved_with(links, hand.hand->surfaces()[s].link, ball.c);
    reach = std::max(reach, (c - approach.point).norm() + ball.r);
  }
  return reach;
}

/// Returns the distance from the point of approach at the start to its aim [m].
double start_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                      const GraspBody& object) {
  return (1 + kMaxFreeAimOffset) * object.torque_scale + hand_reach(hand, q) + kStartClearance;
}

}  // namespace

Pose<double> sample_approach_pose(const CollisionHand& hand, const Eigen::VectorXd& q,
                                  const GraspBody& object, std::mt19937& random) {
  const StartDraws u = draw_start(random);
  // Half of all approaches come along an axis of the box.
  const bool axes = u.kind < 0.5;
  const PalmApproach& approach = hand.hand->layout().approach;
  Pose<double> X_WH;
  X_WH.R = axes ? axis_orientation(hand, q, object, u) : free_orientation(hand, u);
  // The palm faces a random point near the centre, from a clear distance.
  const double max_offset = axes ? kMaxAxisAimOffset : kMaxFreeAimOffset;
  const Eigen::Vector3d aim =
      object.X_WB * object.com + max_offset * object.torque_scale * point_in_ball(u.aim);
  X_WH.p = aim - X_WH.R * (approach.point + start_distance(hand, q, object) * approach.direction);
  return X_WH;
}

double approach_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                         const GraspBody& object) {
  return 2 * start_distance(hand, q, object);
}

double sample_stand_off(std::mt19937& random) {
  return std::max(0.0, 2 * sample_uniform(random) - 1);
}

Eigen::VectorXd sample_preshape(const CollisionHand& hand, int number, std::mt19937& random) {
  const HandLayout& layout = hand.hand->layout();
  // Every fourth approach starts with the open hand.
  Eigen::VectorXd q = open_posture(layout);
  if (number % kOpenPostureInterval == 0) return q;
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  // Coordinates without drives are random, unless they move all digits together, like a wrist.
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    bool moves_all = true;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      moves_all = moves_all &&
                  (surfaces[s].digit.empty() || hand.moved_by(static_cast<Eigen::Index>(s), j));
    if (rates[j] == 0 && !moves_all)
      q[j] = sample_between(layout.lower[j], layout.upper[j], random);
  }
  return q;
}

}  // namespace thenar
