#include "grasp/compare/tip_forces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/lists.h"
#include "base/numbers.h"
#include "base/units.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/limits/force_set.h"
#include "grasp/limits/joint_limits.h"

namespace thenar {
namespace {

constexpr int kForceDirections = 64;     // number of directions of force, evenly over the sphere
constexpr double kNoTipMotion = 1e-12;   // motion of a tip up to which it counts as none [m/rad]
constexpr double kMinAscentGain = 1e-9;  // relative gain of a step of the ascent [1]
constexpr int kMaxAscentSteps = 20;      // maximum number of steps of the ascent

/// Returns direction i of a Fibonacci spiral, evenly distributed on the sphere. (3)
Eigen::Vector3d spiral_direction(int i) {
  const double z = 1 - (2.0 * i + 1) / kForceDirections, r = std::sqrt(1 - z * z);
  const double turn = kPi * (3 - std::sqrt(5.0)) * i;
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Returns the joints that balance a tip force by effort, and not by structure.
std::vector<int> pressing_joints(const Eigen::MatrixXd& J, const Reactions& reactions) {
  std::vector<int> joints;
  // The outermost non-backdrivable joint that moves the tip.
  int carrier = -1;
  for (const int j : reactions.non_backdrivable)
    if (!J.col(j).isZero(kNoTipMotion)) carrier = std::max(carrier, j);
  // Locked joints, and inner non-backdrivable ones, support the force as structure.
  for (int j = 0; j < J.cols(); ++j) {
    if (!J.col(j).isZero(kNoTipMotion) && !is_locked(reactions, j) &&
        (!contains(reactions.non_backdrivable, j) || j == carrier))
      joints.push_back(j);
  }
  return joints;
}

/// Returns whether an effort that moves one of the joints has no limit.
bool is_unknown(const Actuation& a, const std::vector<int>& joints) {
  for (Eigen::Index k = 0; k < a.B.cols(); ++k)
    for (const int j : joints)
      if (a.B(j, k) != 0 && !(std::isfinite(a.lower[k]) && std::isfinite(a.upper[k]))) return true;
  return false;
}

Eigen::Matrix3Xd tip_jacobian(const Hand& hand, const Eigen::VectorXd& q, const HandTip& tip) {
  return hand.jacobian(q, tip.link, tip.p).bottomRows<3>();
}

/// Computes the torques of a force on the tip, with the same force on every other tip that a
/// closing coordinate moves with it, each along its own direction: tau = L f.  (coordinates, 3)
Eigen::MatrixX3d load_map(const Hand& hand, const Eigen::VectorXd& q, int tip,
                          const Eigen::Matrix3Xd& J, const Eigen::VectorXd& rates) {
  Eigen::MatrixX3d L = J.transpose();
  const Eigen::Vector3d way = J * rates;
  if (way.isZero(kNoTipMotion)) return L;
  const std::vector<HandTip>& tips = hand.layout().tip_points;
  for (int t = 0; t < static_cast<int>(tips.size()); ++t) {
    if (t == tip || tips[t].link < 0) continue;
    const Eigen::Matrix3Xd other = tip_jacobian(hand, q, tips[t]);
    // Find out if a closing coordinate moves both tips.
    bool shared = false;
    for (Eigen::Index j = 0; j < rates.size(); ++j)
      shared = shared || (rates[j] != 0 && !J.col(j).isZero(kNoTipMotion) &&
                          !other.col(j).isZero(kNoTipMotion));
    // The other tip carries the same force along its own direction.
    const Eigen::Vector3d its = other * rates;
    if (shared && !its.isZero(kNoTipMotion))
      L += other.transpose() * its.normalized() * way.normalized().transpose();
  }
  return L;
}

/// Returns the cone program of the balance of pressing joints, over (s, u, r).
/// @param L  load_map() of these joints (joints, 3) [m]
ConeProgram balance(const Eigen::MatrixXd& J, const Eigen::MatrixXd& L, const Actuation& a,
                    const std::vector<int>& joints) {
  const Eigen::Index n = J.cols(), m = a.B.cols(), count = a.reactions.lower.size();
  // Balance: L J s = B u + R r + tau_0.
  ConeProgram program;
  program.A = Eigen::MatrixXd::Zero(n, n + m + count);
  program.A.leftCols(n) = L * J;
  program.A.middleCols(n, m) = -a.B(joints, Eigen::all);
  program.A.rightCols(count) = -reactions_on(a.reactions, joints);
  program.b = a.tau_0(joints);
  // Finite limits of efforts and reactions become rows.
  Eigen::VectorXd lower(m + count), upper(m + count);
  lower << a.lower, a.reactions.lower;
  upper << a.upper, a.reactions.upper;
  program.G.resize(0, n + m + count);
  const auto add = [&](Eigen::Index i, double sign, double limit) {
    if (std::isfinite(limit))
      internal::append_limit(program, sign * Eigen::RowVectorXd::Unit(n + m + count, n + i),
                             sign * limit);
  };
  for (Eigen::Index i = 0; i < m + count; ++i) {
    add(i, 1, upper[i]);
    add(i, -1, lower[i]);
  }
  return program;
}

/// Maximum tip force in one direction.
struct MaxForce {
  double value;       // max d'f [N]; infinite: joint limits support it; NaN: no answer
  Eigen::Vector3d f;  // force that attains it [N]; zero without a finite answer
};
/// Computes the maximum tip force in direction d.
MaxForce max_force_along(ConeProgram program, const Eigen::MatrixXd& J, const Eigen::Vector3d& d) {
  program.c = Eigen::VectorXd::Zero(program.A.cols());
  program.c.head(J.cols()) = -J.transpose() * d;
  const ConeResult result = solve(program);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  if (result.status == Status::kUnbounded) return {kInfinity, zero};
  if (result.status == Status::kInfeasible) return {0, zero};  // nothing balances the digit
  if (result.status != Status::kSolved) return {kNaN, zero};
  return {-result.objective, J * result.x.head(J.cols())};
}

/// Computes the maximum of |f| by ascent: each force found gives the next direction. |f| is convex,
/// so that each step increases it, and the ascent ends in a corner of the set. [N]
double max_force_by_ascent(const ConeProgram& program, const Eigen::MatrixXd& J,
                           Eigen::Vector3d d) {
  double best = 0;
  for (int step = 0; step < kMaxAscentSteps; ++step) {
    const MaxForce found = max_force_along(program, J, d);
    if (!std::isfinite(found.value)) return found.value;
    const double size = found.f.norm();
    if (!(size > (1 + kMinAscentGain) * best)) break;
    best = size;
    d = found.f / size;
  }
  return best;
}

}  // namespace

TipForces tip_forces(const Hand& hand, const Eigen::VectorXd& q, int tip) {
  const HandLayout& layout = hand.layout();
  const HandTip& place = layout.tip_points[tip];
  if (place.link < 0) return {kNaN, kNaN};
  const Eigen::Matrix3Xd all = tip_jacobian(hand, q, place);
  // Joints that press, and whether their efforts are known.
  const Actuation actuation = actuation_with_joint_limits(hand, q);
  const std::vector<int> joints = pressing_joints(all, actuation.reactions);
  if (joints.empty()) return {0, 0};
  if (is_unknown(actuation, joints)) return {kNaN, kNaN};
  // The program of the balance, for all directions.
  const Eigen::MatrixXd J = all(Eigen::all, joints);
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  const Eigen::MatrixXd L = load_map(hand, q, tip, all, rates)(joints, Eigen::all);
  const ConeProgram program = balance(J, L, actuation, joints);
  const Eigen::Vector3d closing = all * rates;
  TipForces forces;
  // Force in the direction of closing.
  if (!closing.isZero(kNoTipMotion)) {
    const Eigen::Vector3d way = closing.normalized();
    forces.closing = max_force_along(program, J, way).value;
    if (std::isnan(forces.closing)) return {kNaN, kNaN};
    forces.largest = std::max(forces.closing, max_force_by_ascent(program, J, way));
  }
  // Ascent from directions all over the sphere.
  for (int i = 0; i < kForceDirections; ++i) {
    const double ascent = max_force_by_ascent(program, J, spiral_direction(i));
    if (std::isnan(ascent)) return {forces.closing, kNaN};
    forces.largest = std::max(forces.largest, ascent);
  }
  return forces;
}

}  // namespace thenar
