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

// Largest violation of the cone, over the force along the direction [1]
constexpr double kConeViolation = 1e-10;
// Rounding error of a vertex, over the force that tendons make [1]
constexpr double kVertexRounding = 1e-11;
constexpr int kMaxCuts = 200;  // Most cuts; about 20 are needed
// Largest error of prices that pass the checks, over max(1 N, force) [1]
constexpr double kPricesHold = 1e-7;
// Prices that differ by less than this share of the largest are equal [1]
constexpr double kSamePrice = 1e-4;

/// Loads c_1..c_k (columns, scaled like `balance`) whose amounts s join the tensions:
///   maximise s_1  subject to  loads s + tension_part a = constant,  s_1 >= 0.
/// With k = 3 the amounts lie in the cone |(s_2, s_3)| <= s_1, of which `cuts` are tangent planes.
struct LoadProblem {
  const internal::TipBalance& balance;
  MatrixXd loads;            // (n, k)
  std::vector<double> cuts;  // angle of each tangent plane about the axis of the cone [rad]
};

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
  // Balance in the first rows, tangent planes of the cone below.
  program.row_lower.head(n) = program.row_upper.head(n) = problem.balance.constant;
  for (Index cut = 0; cut < cuts; ++cut) {
    const double angle = problem.cuts[cut];
    program.A.row(n + cut).head<3>() << -1, std::cos(angle), std::sin(angle);
  }
  // The amount along the axis and the tensions are not negative.
  program.lower = VectorXd::Zero(k + m);
  program.lower.segment(1, k - 1).setConstant(-kInfinity);
  program.upper = VectorXd::Constant(k + m, kInfinity);
  program.upper.tail(m) = problem.balance.upper;
  return program;
}

/// The directions in which the program never ends: tensions without limit alone, one unit of s_1.
LinearProgram recession(LinearProgram program) {
  const auto homogeneous = [](double bound) { return std::isfinite(bound) ? 0.0 : bound; };
  program.row_lower = program.row_lower.unaryExpr(homogeneous);
  program.row_upper = program.row_upper.unaryExpr(homogeneous);
  program.upper = program.upper.unaryExpr(homogeneous);
  program.upper(0) = 1;
  return program;
}

/// Adds the tangent plane that cuts x off, if x is outside the cone.
bool cut_off(const VectorXd& x, LoadProblem& problem) {
  if (problem.loads.cols() == 1) return false;
  if (std::hypot(x(1), x(2)) <= (1 + kConeViolation) * x(0) + kVertexRounding) return false;
  problem.cuts.push_back(std::atan2(x(2), x(1)));
  return true;
}

/// The optimum, and the program with the cuts that it is one of.
struct CutOptimum {
  LinearProgram program;
  LinearResult best;
};

/// Kelley's method: solve, cut the vertex off if it is outside the cone, and again. While cuts are
/// few the program may be unbounded although the cone is not: then a ray is cut off instead.
CutOptimum maximise(LoadProblem problem) {
  // Four tangent planes to begin with.
  if (problem.loads.cols() == 3) problem.cuts = {0, kPi / 2, kPi, -kPi / 2};
  while (problem.cuts.size() < kMaxCuts) {
    const LinearProgram program = linear_program(problem);
    const LinearResult result = solve(program);
    if (result.status == Status::kUnbounded) {
      // Unbounded for want of planes: cut the ray off.
      const LinearResult ray = solve(recession(program));
      if (ray.status != Status::kSolved || !cut_off(ray.x, problem)) return {program, result};
    } else if (result.status != Status::kSolved || !cut_off(result.x, problem)) {
      return {program, result};
    }
  }
  return {{}, {Status::kLimit, VectorXd(), kInfinity, VectorXd(), {}}};
}

/// A cone of forces about d: |f - d d'f| <= slope d'f.
struct ForceCone {
  Vector3d d;
  double slope;
};

/// Measures, by J and R alone, the distance of the prices p of joint torque from optimal duals of
///   maximise d' f  subject to  J' f - R' t = tau_0,  0 <= t <= F0,  f in the cone.
ForceLimitPrices check_prices(const TipStatics& statics, const ForceCone& cone,
                              const MaxTipForce& largest) {
  const VectorXd& p = largest.torque_shadow_price;
  const VectorXd reward = statics.R * p;      // of a newton more of each tension [N/N]
  const Vector3d w = cone.d - statics.J * p;  // reward of a newton more of force [1]
  const Vector3d across = w - cone.d * cone.d.dot(w);
  ForceLimitPrices checked;
  // No force of the cone may have a reward, and no tension without a limit.
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

/// Prices of F0 from those of the program's bounds; empty if they do not pass the checks.
ForceLimitPrices prices_of(const TipStatics& statics, const internal::TipBalance& balance,
                           const ForceCone& cone, const CutOptimum& optimum,
                           const MaxTipForce& largest) {
  ForceLimitPrices prices = check_prices(statics, cone, largest);
  const double size = kPricesHold * std::max(1.0, std::abs(largest.component));
  if (!(prices.dual_violation <= kPricesHold && prices.slackness <= size && prices.gap <= size))
    return prices;
  const BoundPrices bounds = upper_bound_prices(optimum.program, optimum.best);
  const VectorXd per_newton = balance.force_unit * balance.unit.cwiseInverse();
  prices.increase = per_newton.cwiseProduct(bounds.increase.tail(per_newton.size()));
  prices.decrease = per_newton.cwiseProduct(bounds.decrease.tail(per_newton.size()));
  return prices;
}

/// Returns the force with the same component along d and the same joint torques of which bones
/// alone carry least: it removes the part in the null space of J' across d.
Vector3d without_bone_force(const internal::TipBalance& balance, const Vector3d& d,
                            const Vector3d& force) {
  // Directions that meet no torque, and among them those across d.
  const Eigen::Matrix3Xd carried = balance.U.rightCols(3 - balance.rank);
  const VectorXd along = carried.transpose() * d;
  VectorXd amount = carried.transpose() * force;
  if (along.norm() > internal::kUnitRounding)
    amount -= along * (along.dot(amount) / along.squaredNorm());
  return force - carried * amount;
}

/// Returns the amount that a result holds before, or instead of, an answer.
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

  // The axis of the cone and its two edges, in the basis in which a straight finger has zeros.
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

  // The joint torques of one such wrench, without rounding where it needs none.
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
