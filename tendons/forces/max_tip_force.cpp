#include "tendons/forces/max_tip_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "solvers/bound_prices.h"
#include "solvers/linear_program.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Largest violation of the cone over the force along the direction [1]
constexpr double kConeViolation = 1e-10;
// Rounding error of a vertex over the force that tendons produce [1]
constexpr double kVertexRounding = 1e-11;
constexpr int kMaxCuts = 200;  // largest number of cuts; about 20 are needed
// Largest error of prices that pass the checks over max(1 N, force) [1]
constexpr double kPriceTolerance = 1e-7;
// Difference over the largest price below which prices are equal [1]
constexpr double kSamePrice = 1e-4;

/// Problem of loads c_1..c_k (columns, scaled like `balance`) with amounts s beside the tensions:
///   maximise s_1  subject to  loads s + tension_part a = constant,  s_1 >= 0.
/// With k = 3 the amounts lie in the cone |(s_2, s_3)| <= s_1, approximated by tangent planes,
/// `cuts`.
struct LoadProblem {
  const internal::TipBalance& balance;
  MatrixXd loads;            // (n, k)
  std::vector<double> cuts;  // angle of each tangent plane about the axis of the cone [rad]
};

/// Builds the linear program with the present cuts.
LinearProgram linear_program(const LoadProblem& problem) {
  const Index n = problem.loads.rows(), k = problem.loads.cols();
  const Index m = problem.balance.upper.size(), cuts = static_cast<Index>(problem.cuts.size());
  LinearProgram program;
  program.objective = VectorXd::Unit(k + m, 0);
  program.A = MatrixXd::Zero(n + cuts, k + m);
  program.A.topLeftCorner(n, k) = problem.loads;
  program.A.topRightCorner(n, m) = problem.balance.tension_part;
  program.row_lower = VectorXd::Constant(n + cuts, -kInfinity);
  program.row_upper = VectorXd::Zero(n + cuts);
  // Set the balance in the first rows, tangent planes of the cone below.
  program.row_lower.head(n) = program.row_upper.head(n) = problem.balance.constant;
  for (Index cut = 0; cut < cuts; ++cut) {
    const double angle = problem.cuts[cut];
    program.A.row(n + cut).head<3>() << -1, std::cos(angle), std::sin(angle);
  }
  // Bound the amount along the axis and the tensions from below by zero.
  program.lower = VectorXd::Zero(k + m);
  program.lower.segment(1, k - 1).setConstant(-kInfinity);
  program.upper = VectorXd::Constant(k + m, kInfinity);
  program.upper.tail(m) = problem.balance.upper;
  return program;
}

/// Builds the program of the recession cone, with one unit of s_1: directions in which the program
/// is unbounded.
LinearProgram recession(LinearProgram program) {
  const auto homogeneous = [](double bound) { return std::isfinite(bound) ? 0.0 : bound; };
  program.row_lower = program.row_lower.unaryExpr(homogeneous);
  program.row_upper = program.row_upper.unaryExpr(homogeneous);
  program.upper = program.upper.unaryExpr(homogeneous);
  program.upper(0) = 1;
  return program;
}

/// Adds the tangent plane that cuts off x, if x is outside the cone. @return whether it did
bool cut_off(const VectorXd& x, LoadProblem& problem) {
  if (problem.loads.cols() == 1) return false;
  if (std::hypot(x(1), x(2)) <= (1 + kConeViolation) * x(0) + kVertexRounding) return false;
  problem.cuts.push_back(std::atan2(x(2), x(1)));
  return true;
}

/// Optimum, and the program with its cuts.
struct CutOptimum {
  LinearProgram program;
  LinearResult best;
};

/// Maximises by Kelley's method: solves, cuts off a vertex outside the cone, and repeats. With few
/// cuts the program may be unbounded although the cone is not: then a ray is cut off instead.
CutOptimum maximise(LoadProblem problem) {
  // Start with four tangent planes.
  if (problem.loads.cols() == 3) problem.cuts = {0, kPi / 2, kPi, -kPi / 2};
  while (problem.cuts.size() < kMaxCuts) {
    const LinearProgram program = linear_program(problem);
    const LinearResult result = solve(program);
    if (result.status == Status::kUnbounded) {
      // Cut off the ray of an unbounded program.
      const LinearResult ray = solve(recession(program));
      if (ray.status != Status::kSolved || !cut_off(ray.x, problem)) return {program, result};
    } else if (result.status != Status::kSolved || !cut_off(result.x, problem)) {
      return {program, result};
    }
  }
  return {{}, {Status::kLimit, VectorXd(), kInfinity, VectorXd(), {}}};
}

/// Cone of forces about d: |f - d d'f| <= slope d'f.
struct ForceCone {
  Vector3d d;
  double slope;
};

/// Measures, from J and R alone, the distance of the prices p of joint torque from optimal duals of
///   maximise d' f  subject to  J' f - R' t = tau_0,  0 <= t <= F0,  f in the cone.
ForceLimitPrices check_prices(const TipStatics& statics, const ForceCone& cone,
                              const MaxTipForce& largest) {
  const VectorXd& p = largest.torque_shadow_price;
  const VectorXd reward = statics.R * p;      // gain per newton of each tension [N/N]
  const Vector3d w = cone.d - statics.J * p;  // gain per newton of force [1]
  const Vector3d across = w - cone.d * cone.d.dot(w);
  ForceLimitPrices checked;
  // Check that no force of the cone has a gain, nor any tension without a limit.
  checked.dual_violation = std::max(0.0, cone.d.dot(w) + cone.slope * across.norm());
  checked.slackness = std::abs(w.dot(largest.force));
  double paid = p.dot(statics.tau_0);
  for (Index i = 0; i < reward.size(); ++i) {
    const double F0 = statics.max_tension(i), price = std::max(0.0, reward(i));
    checked.slackness += std::max(0.0, -reward(i)) * largest.tension(i);
    if (std::isinf(F0)) {
      checked.dual_violation = std::max(checked.dual_violation, price);
    } else {
      checked.slackness += price * (F0 - largest.tension(i));
      paid += price * F0;
    }
  }
  checked.gap = std::abs(largest.component - paid);
  return checked;
}

/// Computes the prices of F0 from those of the program's bounds; empty if they do not pass the
/// checks.
ForceLimitPrices prices_of(const TipStatics& statics, const internal::TipBalance& balance,
                           const ForceCone& cone, const CutOptimum& optimum,
                           const MaxTipForce& largest) {
  ForceLimitPrices prices = check_prices(statics, cone, largest);
  const double size = kPriceTolerance * std::max(1.0, std::abs(largest.component));
  if (!(prices.dual_violation <= kPriceTolerance && prices.slackness <= size && prices.gap <= size))
    return prices;
  const BoundPrices bounds = upper_bound_prices(optimum.program, optimum.best);
  const VectorXd per_newton = balance.force_unit * balance.unit.cwiseInverse();
  prices.increase = per_newton.cwiseProduct(bounds.increase.tail(per_newton.size()));
  prices.decrease = per_newton.cwiseProduct(bounds.decrease.tail(per_newton.size()));
  return prices;
}

/// Computes the force with the same component along d and the same joint torques whose part carried
/// by bones alone is smallest: it removes the part in the null space of J' across d.
Vector3d without_bone_force(const internal::TipBalance& balance, const Vector3d& d,
                            const Vector3d& force) {
  // Remove from the directions without torque the part across d.
  const Eigen::Matrix3Xd carried = balance.U.rightCols(3 - balance.rank);
  const VectorXd along = carried.transpose() * d;
  VectorXd amount = carried.transpose() * force;
  if (along.norm() > internal::kUnitRounding)
    amount -= along * (along.dot(amount) / along.squaredNorm());
  return force - carried * amount;
}

/// Returns the amount in a result without a solution.
double amount_without_answer(Status status) { return status == Status::kUnbounded ? kInfinity : 0; }

}  // namespace

bool ForceLimitPrices::degenerate() const {
  if (increase.size() == 0) return false;
  const double same = kSamePrice * increase.cwiseAbs().maxCoeff();
  return !((decrease - increase).array() <= same + kVertexRounding).all();
}

MaxTipForce max_tip_force(const TipStatics& statics, const Vector3d& direction,
                          const MaxTipForceOptions& options) {
  require(options.tolerance >= 0 && options.tolerance < kPi / 2,
          "the tolerance about a direction must be in [0, pi/2) rad, got {}", options.tolerance);
  const internal::TipBalance balance = internal::tip_balance(statics);
  const Vector3d d = internal::unit_direction(direction);

  // Express the axis of the cone and its two edges in a basis with exact zeros when straight.
  const Tangents side = tangents(d);
  const double slope = std::tan(options.tolerance);
  Eigen::Matrix3Xd axes(3, options.tolerance > 0 ? 3 : 1);
  axes.col(0) = d;
  if (axes.cols() == 3) axes.rightCols<2>() << side.e1, side.e2;
  Eigen::Matrix3Xd turned = internal::without_rounding(balance.U.transpose() * axes);
  axes.rightCols(axes.cols() - 1) *= slope;
  turned.rightCols(axes.cols() - 1) *= slope;

  const CutOptimum optimum = maximise({balance, balance.force_part * turned, {}});
  const LinearResult& best = optimum.best;
  const Status status = best.status;
  MaxTipForce result{status,
                     Vector3d::Zero(),
                     amount_without_answer(status),
                     VectorXd::Zero(balance.upper.size()),
                     VectorXd::Zero(balance.upper.size()),
                     VectorXd::Zero(statics.J.cols()),
                     {}};
  if (status != Status::kSolved) return result;
  result.force =
      without_bone_force(balance, d, balance.force_unit * (axes * best.x.head(axes.cols())));
  result.component = balance.force_unit * best.x(0);
  result.tension = internal::tension(balance, best.x.tail(balance.upper.size()));
  result.activation = internal::activation(statics, result.tension);
  result.torque_shadow_price =
      balance.force_unit * best.duals.head(statics.J.cols()).cwiseProduct(balance.row_scale);
  const Vector3d across = result.force - d * d.dot(result.force);
  result.check = {balance.force_unit * best.certificate.gap,
                  std::max(0.0, across.norm() - slope * result.component),
                  internal::imbalance(statics, result.force, result.tension)};
  if (options.prices) result.prices = prices_of(statics, balance, {d, slope}, optimum, result);
  return result;
}

MaxTipWrench max_tip_wrench(const TipStatics& statics, const Wrench& wrench) {
  const auto& [moment, force] = wrench;
  const internal::TipBalance balance = internal::tip_balance(statics);
  require(moment.allFinite() && force.allFinite(), "a wrench must be finite");
  require(!moment.isZero(0) || !force.isZero(0), "a wrench must not be zero");
  require(moment.isZero(0) || has_rotation(statics),
          "a moment needs the rotation Jacobian W of the tip");

  // Compute the joint torques of one such wrench, with rounding errors set to zero.
  VectorXd torque = statics.J.transpose() * force;
  double size = statics.J.norm() * force.norm();
  if (has_rotation(statics)) {
    torque += statics.W.transpose() * moment;
    size += statics.W.norm() * moment.norm();
  }
  VectorXd load = balance.row_scale.cwiseProduct(
      (torque.array().abs() > internal::kRankTolerance * size).select(torque, 0));
  const double unit = load.norm() > 0 ? 1 / load.norm() : 1;
  load *= unit;

  const LinearResult best = maximise({balance, load, {}}).best;
  const Status status = best.status;
  MaxTipWrench result{status, amount_without_answer(status), VectorXd::Zero(balance.upper.size()),
                      VectorXd::Zero(balance.upper.size()), MaxTipForceCheck::kUnknown};
  if (status != Status::kSolved) return result;
  result.multiple = unit * best.x(0);
  result.gap = unit * best.certificate.gap;
  result.tension = internal::tension(balance, best.x.tail(balance.upper.size()));
  result.activation = internal::activation(statics, result.tension);
  return result;
}

}  // namespace thenar
