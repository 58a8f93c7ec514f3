#include "data/io/robot/linkage.h"

#include <algorithm>
#include <utility>

#include <Eigen/Dense>

#include "base/numbers.h"
#include "data/io/robot/link_poses.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kClosureTolerance = 1e-11;  // Largest residual of a closed loop [m]
// Length that converts rotations of welds to displacements [m]
constexpr double kWeldLength = 0.05;
constexpr double kMaxSearchStep = 0.1;    // Longest step of the search [rad] or [m]
constexpr double kDifferenceStep = 1e-6;  // Step of central differences [rad] or [m]
// Singular values below this share of the largest are zero [1]
constexpr double kLoopRankTolerance = 1e-7;

}  // namespace

Linkage::Linkage(const RobotSpec& robot, const LoopGroup& group, std::string motor)
    : robot_(robot), group_(group), motor_(std::move(motor)) {
  // Links by name.
  for (std::size_t i = 0; i < robot.links.size(); ++i) index_[robot.links[i].name] = i;
  // Passive degrees of freedom with their own spring.
  for (const RobotDof& dof : robot.dofs) {
    if (group.dofs.count(dof.name) == 0 || dof.name == motor_) continue;
    PassiveJoint passive{dof.name, dof.lower, dof.upper, 0, 0};
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof == dof.name && joint.name == dof.name) {
        passive.stiffness = joint.stiffness;
        passive.rest = joint.rest;
      }
    passives_.push_back(passive);
  }
}

VectorXd Linkage::loop_residual(double u, const VectorXd& y) const {
  DofValues values{{motor_, u}};
  for (std::size_t i = 0; i < passives_.size(); ++i) values[passives_[i].name] = y[i];
  return loop_residual(link_poses(robot_, values));
}

VectorXd Linkage::loop_residual(const std::vector<Pose<double>>& links) const {
  std::vector<double> all;
  for (const LoopClosure& closure : group_.closures) {
    // Difference in position, and for welds in rotation.
    const Pose<double> A = links[index_.at(closure.a)] * closure.X_A,
                       B = links[index_.at(closure.b)] * closure.X_B;
    for (int k = 0; k < 3; ++k) all.push_back(A.p[k] - B.p[k]);
    if (!closure.welded) continue;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(A.R.transpose() * B.R));
    for (int k = 0; k < 3; ++k) all.push_back(kWeldLength * turn.angle() * turn.axis()[k]);
  }
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

std::optional<VectorXd> Linkage::close(double u, VectorXd y) const {
  // If the motor moves every joint, the loop closes by itself or not at all.
  if (passives_.empty())
    return max_or_nan(loop_residual(u, y).cwiseAbs()) < kClosureTolerance
               ? std::optional<VectorXd>(y)
               : std::nullopt;
  std::vector<ActiveLimit> stops(passives_.size(), ActiveLimit::kNone);
  for (int iteration = 0; iteration < 400; ++iteration) {
    // SQP step on the joints that are not at a limit.
    const VectorXd c = loop_residual(u, y);
    const MatrixXd J = slopes(u, y);
    bool decided = true;
    VectorXd d = free_step(c, J, y, stops, decided);
    // Closed and optimal, unless a spring pulls a joint off its limit.
    if (max_or_nan(c.cwiseAbs()) < kClosureTolerance && max_or_nan(d.cwiseAbs()) < 1e-10) {
      if (release(J, y, stops)) continue;
      return decided ? std::optional<VectorXd>(y) : std::nullopt;
    }
    // No step and no joint to release: the limits prevent closing.
    if (d.isZero(0) && !release(J, y, stops)) return {};
    // Limited step, up to the first limit.
    const double longest = d.cwiseAbs().maxCoeff();
    if (longest > kMaxSearchStep) d *= kMaxSearchStep / longest;
    go(y, d, stops);
  }
  return {};
}

MatrixXd Linkage::slopes(double u, const VectorXd& y) const {
  MatrixXd J;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const VectorXd e = kDifferenceStep * VectorXd::Unit(y.size(), i);
    const VectorXd column =
        (loop_residual(u, y + e) - loop_residual(u, y - e)) / (2 * kDifferenceStep);
    if (i == 0) J.resize(column.size(), y.size());
    J.col(i) = column;
  }
  return J;
}

/// Moves up to the first limit, and makes it active.
void Linkage::go(VectorXd& y, const VectorXd& d, std::vector<ActiveLimit>& stops) const {
  // Share of the step at which the first joint meets its limit.
  double share = 1;
  std::size_t first = stops.size();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (stops[i] != ActiveLimit::kNone || d[at] == 0) continue;
    const double limit = d[at] < 0 ? passives_[i].lower : passives_[i].upper;
    const double until = std::max(0.0, (limit - y[at]) / d[at]);
    if (until >= share) continue;
    share = until;
    first = i;
  }
  // The joint rests exactly on the limit.
  y += share * d;
  if (first == stops.size()) return;
  const auto at = static_cast<Eigen::Index>(first);
  stops[first] = d[at] < 0 ? ActiveLimit::kLower : ActiveLimit::kUpper;
  y[at] = d[at] < 0 ? passives_[first].lower : passives_[first].upper;
}

/// Releases the joint that springs pull off its limit most. @returns whether there is one
bool Linkage::release(const MatrixXd& J, const VectorXd& y, std::vector<ActiveLimit>& stops) const {
  // Loop forces in least squares that balance the springs of free joints.
  VectorXd pull(y.size());
  MatrixXd balance = J.transpose();
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const PassiveJoint& passive = passives_[i];
    pull[i] = passive.stiffness * (passive.rest - y[i]);
    if (stops[i] != ActiveLimit::kNone) balance.row(i).setZero();
  }
  Eigen::JacobiSVD<MatrixXd> svd(balance, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(kLoopRankTolerance);
  VectorXd free = pull;
  for (Eigen::Index i = 0; i < y.size(); ++i)
    if (stops[i] != ActiveLimit::kNone) free[i] = 0;
  // What is left on each joint after these [N m] or [N].
  const VectorXd left = pull - J.transpose() * svd.solve(free);  // on each joint [N m] or [N]
  // Release the joint that is pulled off its limit most.
  std::size_t worst = stops.size();
  double most = 1e-9 * pull.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double off = (stops[i] == ActiveLimit::kLower ? 1 : -1) * left[i];
    if (stops[i] == ActiveLimit::kNone || off <= most) continue;
    most = off;
    worst = i;
  }
  if (worst == stops.size()) return false;
  stops[worst] = ActiveLimit::kNone;
  return true;
}

/// Step of least spring energy with J d = -c; joints at limits stay.
VectorXd Linkage::free_step(const VectorXd& c, const MatrixXd& J, const VectorXd& y,
                            const std::vector<ActiveLimit>& stops, bool& decided) const {
  // Columns of the free joints.
  std::vector<Eigen::Index> free;
  VectorXd d = VectorXd::Zero(y.size());
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (stops[i] == ActiveLimit::kNone) free.push_back(static_cast<Eigen::Index>(i));
  if (free.empty()) return d;
  MatrixXd A(J.rows(), static_cast<Eigen::Index>(free.size()));
  for (std::size_t f = 0; f < free.size(); ++f)
    A.col(static_cast<Eigen::Index>(f)) = J.col(free[f]);
  // Least-norm step that closes the loop to first order.
  Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
  svd.setThreshold(kLoopRankTolerance);
  const VectorXd least = svd.solve(VectorXd(-c));
  const MatrixXd Z = svd.matrixV().rightCols(A.cols() - svd.rank());
  VectorXd x = least;
  // Remaining freedoms minimise the energy of the springs.
  if (Z.cols() > 0) {
    VectorXd k(A.cols()), pull(A.cols());
    for (std::size_t f = 0; f < free.size(); ++f) {
      const PassiveJoint& passive = passives_[free[f]];
      const auto at = static_cast<Eigen::Index>(f);
      k[at] = passive.stiffness;
      pull[at] = passive.stiffness * (passive.rest - y[free[f]] - least[at]);
    }
    const MatrixXd H = Z.transpose() * k.asDiagonal() * Z;
    const Eigen::FullPivLU<MatrixXd> lu(H);
    // Without a spring the freedom is undetermined.
    decided = H.cwiseAbs().maxCoeff() > 0 && lu.rank() == Z.cols();
    if (decided) x += Z * lu.solve(Z.transpose() * pull);
  }
  for (std::size_t f = 0; f < free.size(); ++f) d[free[f]] = x[f];
  return d;
}

}  // namespace thenar::internal
