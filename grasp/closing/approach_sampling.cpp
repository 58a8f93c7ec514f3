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
// Largest offset of the aim from the centre, over the object's radius [1]
constexpr double kMostOffset = 0.1;
// Largest offset for approaches from anywhere, over the object's radius [1]
constexpr double kOffAny = 0.5;
constexpr int kPreshapeInterval = 4;  // One of this many approaches begins with the open hand

/// Random numbers of one approach, in [0, 1).
struct StartDraws {
  double kind, side, half_turn;
  std::array<double, 3> turn, aim;
};

StartDraws draw(std::mt19937& random) {
  std::array<double, 9> u{};
  for (double& each : u) each = sample_uniform(random);
  return {u[0], u[1], u[2], {u[3], u[4], u[5]}, {u[6], u[7], u[8]}};
}

/// Uniform on the unit sphere, by the first two numbers. (3)
Eigen::Vector3d on_sphere(const std::array<double, 3>& u) {
  const double z = 2 * u[0] - 1, turn = 2 * kPi * u[1];
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

Eigen::Vector3d in_ball(const std::array<double, 3>& u) { return on_sphere(u) * std::cbrt(u[2]); }

/// Rotation that turns a to A, and the direction b across a to B across A.
Eigen::Matrix3d turn_to(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& A, const Eigen::Vector3d& B) {
  Eigen::Matrix3d from, to;
  from << b, a.cross(b), a;
  to << B, A.cross(B), A;
  return to * from.transpose();
}

/// Orientation R_WH of an approach along an axis of the object's box.
Eigen::Matrix3d along_axes(const CollisionHand& hand, const Eigen::VectorXd& q,
                           const GraspBody& object, const StartDraws& u) {
  // Side of the box from which the hand comes.
  const Eigen::Matrix3d axes = object.X_WB.R * object.box.axes;
  const int side = std::min(5, static_cast<int>(6 * u.side));
  const int from = side / 2, shorter = from == 2 ? 1 : 2;
  const Eigen::Vector3d towards = (side % 2 == 0 ? 1.0 : -1.0) * axes.col(from);
  // The hand closes across the shorter of the other two axes.
  const Eigen::Vector3d across = (u.half_turn < 0.5 ? 1.0 : -1.0) * axes.col(shorter);
  const Eigen::Vector3d closing = fingertip_paths(*hand.hand, q).axis;
  return turn_to(hand.hand->layout().approach.direction, closing, towards, across);
}

/// Orientation R_WH of an approach from any direction.
Eigen::Matrix3d any(const CollisionHand& hand, const StartDraws& u) {
  const Eigen::Vector3d towards = on_sphere(u.turn), &d = hand.hand->layout().approach.direction;
  return rotation_about<double>(towards, 2 * kPi * u.turn[2]) *
         turn_to(d, tangents(d).e1, towards, tangents(towards).e1);
}

/// Largest distance of any surface from the point of approach [m].
double hand_reach(const CollisionHand& hand, const Eigen::VectorXd& q) {
  const PalmApproach& approach = hand.hand->layout().approach;
  const std::vector<Pose<double>> links = hand.hand->pose(q);
  double reach = 0;
  for (std::size_t s = 0; s < hand.trees.size(); ++s) {
    // The bounding ball of each surface, on its link.
    const Ball& ball = hand.trees[s].nodes[0].ball;
    const int link = hand.hand->surfaces()[s].link;
    const Eigen::Vector3d c = link < 0 ? ball.c : links[link] * ball.c;
    reach = std::max(reach, (c - approach.point).norm() + ball.r);
  }
  return reach;
}

/// Distance from the point of approach at the start to its aim [m].
double far_off(const CollisionHand& hand, const Eigen::VectorXd& q, const GraspBody& object) {
  return (1 + kOffAny) * object.torque_scale + hand_reach(hand, q) + kStartClearance;
}

}  // namespace

Pose<double> sample_approach_pose(const CollisionHand& hand, const Eigen::VectorXd& q,
                                  const GraspBody& object, std::mt19937& random) {
  const StartDraws u = draw(random);
  // Half of all approaches come along an axis of the box.
  const bool axes = u.kind < 0.5;
  const PalmApproach& approach = hand.hand->layout().approach;
  Pose<double> X_WH;
  X_WH.R = axes ? along_axes(hand, q, object, u) : any(hand, u);
  // The palm looks at a random point near the centre, from a clear distance.
  const Eigen::Vector3d aim = object.X_WB * object.com +
                              (axes ? kMostOffset : kOffAny) * object.torque_scale * in_ball(u.aim);
  X_WH.p = aim - X_WH.R * (approach.point + far_off(hand, q, object) * approach.direction);
  return X_WH;
}

double approach_distance(const CollisionHand& hand, const Eigen::VectorXd& q,
                         const GraspBody& object) {
  return 2 * far_off(hand, q, object);
}

double sample_stand_off(std::mt19937& random) {
  return std::max(0.0, 2 * sample_uniform(random) - 1);
}

Eigen::VectorXd sample_preshape(const CollisionHand& hand, int number, std::mt19937& random) {
  const HandLayout& layout = hand.hand->layout();
  // Every fourth approach begins with the open hand.
  Eigen::VectorXd q = open_posture(hand.hand->layout());
  if (number % kPreshapeInterval == 0) return q;
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  // Undriven coordinates are random, unless they move all digits alike, like a wrist.
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    bool all = true;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      all = all && (surfaces[s].digit.empty() || hand.moved_by(static_cast<Eigen::Index>(s), j));
    if (rates[j] == 0 && !all) q[j] = sample_between(layout.lower[j], layout.upper[j], random);
  }
  return q;
}

}  // namespace thenar
