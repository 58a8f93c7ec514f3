#include "tendons/forces/max_tip_load.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/error.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMomentArm = 0.01;  // lever arm that converts moments to newtons [m]
constexpr double kStopArm = 0.01;    // moment arm of the tendon that models a stop [m]

/// Balance as one of forces alone, for max_tip_force().
struct LoadBalance {
  TipStatics statics;          // J is that of the maximised load, per `unit`
  double unit;                 // unit of that load: 1 N, or kMomentArm [N m]
  Eigen::Matrix3Xd B;          // Jacobian of the other load (3, n)
  MatrixXd N;                  // torques that are balanced in `statics`, as columns (n, balanced)
  Eigen::Matrix3Xd pair_axes;  // other load of each pair of additional tendons (3, 0 or 3)
};

/// Computes an orthonormal basis of the torques that no other load produces: the null space of B
/// (n, n - rank).
MatrixXd null_space(const Eigen::Matrix3Xd& B) {
  const Eigen::JacobiSVD<MatrixXd> svd(B, Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  const Index rank = (sigma.array() > internal::kRankTolerance * sigma(0)).count();
  return svd.matrixV().rightCols(B.cols() - (sigma(0) > 0 ? rank : 0));
}

/// Returns the matrix with entries that are rounding of `size` set to zero.
MatrixXd cleaned(const MatrixXd& matrix, double size) {
  return (matrix.array().abs() > internal::kRankTolerance * size).select(matrix, 0);
}

/// Reduces the balance to the torques N. Where nothing remains, it has one joint without any load.
void eliminate(const MatrixXd& N, TipStatics& statics) {
  if (N.cols() == 0) {
    statics.J = Eigen::Matrix3Xd::Zero(3, 1);
    statics.R = MatrixXd::Zero(statics.R.rows(), 1);
    statics.tau_0 = VectorXd::Zero(1);
    return;
  }
  statics.J = cleaned(statics.J * N, statics.J.norm());
  statics.R = cleaned(statics.R * N, statics.R.norm());
  statics.tau_0 = N.transpose() * statics.tau_0;
}

/// Adds a tendon for each stop, below those of muscles.
void add_stops(const std::vector<JointStop>& stops, TipStatics& statics) {
  const Index m = statics.R.rows(), n = statics.R.cols();
  const auto count = static_cast<Index>(stops.size());
  statics.R.conservativeResize(m + count, Eigen::NoChange);
  statics.R.bottomRows(count).setZero();
  statics.max_tension.conservativeResize(m + count);
  for (Index k = 0; k < count; ++k) {
    const JointStop& stop = stops[k];
    require(stop.coordinate >= 0 && stop.coordinate < n, "a stop of joint {}, there are {}",
            stop.coordinate, n);
    require(std::abs(stop.max_torque) > 0, "a stop carries some torque, got {} N m",
            stop.max_torque);
    statics.R(m + k, stop.coordinate) = std::copysign(kStopArm, stop.max_torque);
    statics.max_tension[m + k] = std::abs(stop.max_torque) / kStopArm;
  }
}

/// Computes the torque of each stop [N m] (stops). @param tension  tension of its tendon [N]
/// (stops)
VectorXd stop_torques(const std::vector<JointStop>& stops, const VectorXd& tension) {
  VectorXd torque(tension.size());
  for (Index k = 0; k < torque.size(); ++k)
    torque[k] = std::copysign(kStopArm, stops[k].max_torque) * tension[k];
  return torque;
}

/// Computes the passive torque of all joints, stops included [N m] (n).
VectorXd passive_with_stops(const TipStatics& statics, const std::vector<JointStop>& stops,
                            const VectorXd& torque) {
  VectorXd passive = statics.tau_0;
  for (Index k = 0; k < torque.size(); ++k) passive[stops[k].coordinate] += torque[k];
  return passive;
}

/// Adds tendons that produce each component of the other load, in both senses, up to `max_load`.
void add_pairs(const LoadBalance& balance, double max_load, TipStatics& statics) {
  const Index m = statics.R.rows(), pairs = balance.pair_axes.cols();
  const MatrixXd arms = balance.pair_axes.transpose() * balance.B;
  statics.R.conservativeResize(m + 2 * pairs, Eigen::NoChange);
  statics.R.middleRows(m, pairs) = -arms;
  statics.R.bottomRows(pairs) = arms;
  statics.max_tension.conservativeResize(m + 2 * pairs);
  statics.max_tension.tail(2 * pairs).setConstant(max_load);
}

/// Builds the balance of the requested load.
LoadBalance load_balance(const TipStatics& statics, const TipLoadOptions& options) {
  const bool moment = options.load == TipLoad::kMoment;
  internal::require_statics(statics);
  require(options.max_other >= 0, "the other load of a tip is at least 0, got {}",
          options.max_other);
  require(has_rotation(statics) || (!moment && options.max_other == 0),
          "a moment needs the rotation Jacobian W of the tip");
  LoadBalance balance{statics, moment ? kMomentArm : 1, moment ? statics.J : statics.W,
                      MatrixXd::Identity(statics.J.cols(), statics.J.cols()),
                      Eigen::Matrix3Xd(3, 0)};
  TipStatics& asked = balance.statics;
  asked.W = Eigen::Matrix3Xd(3, 0);
  add_stops(options.stops, asked);
  if (moment) asked.J = kMomentArm * statics.W;
  if (std::isinf(options.max_other)) {
    balance.N = null_space(balance.B);
    eliminate(balance.N, asked);
  } else if (options.max_other > 0) {
    balance.pair_axes = options.axes;
    add_pairs(balance, options.max_other, asked);
  }
  return balance;
}

/// Computes the other load at a solution [N m] or [N] (3).
/// @param passive  torque of all joints without muscles [N m] (n)
/// @param tension  tensions of muscles, stops and pairs [N]
Vector3d other_load(const TipStatics& statics, const LoadBalance& balance, const Vector3d& asked,
                    const VectorXd& passive, const VectorXd& tension) {
  const Index m = statics.R.rows(), pairs = balance.pair_axes.cols();
  // Read it from the pairs of tendons.
  if (pairs > 0)
    return balance.pair_axes * (tension.tail(2 * pairs).head(pairs) - tension.tail(pairs));
  // Return zero if it is not part of the balance.
  if (balance.N.cols() == balance.N.rows()) return Vector3d::Zero();
  // Find the smallest load that balances the rest.
  const Eigen::Matrix3Xd A = balance.unit == 1 ? statics.J : statics.W;
  const VectorXd left = statics.R.transpose() * tension.head(m) + passive - A.transpose() * asked;
  Eigen::JacobiSVD<MatrixXd> svd(balance.B.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(internal::kRankTolerance);
  return svd.solve(left);
}

/// Converts prices and their checks to the unit of the load, and to muscles alone.
ForceLimitPrices prices_in(double unit, Index muscles, const ForceLimitPrices& prices) {
  ForceLimitPrices result{
      {}, {}, unit * prices.gap, unit * prices.slackness, prices.dual_violation};
  if (prices.increase.size() == 0) return result;
  result.increase = unit * prices.increase.head(muscles);
  result.decrease = unit * prices.decrease.head(muscles);
  return result;
}

}  // namespace

MaxTipLoad max_tip_load(const TipStatics& statics, const Vector3d& direction,
                        const TipLoadOptions& options) {
  const LoadBalance balance = load_balance(statics, options);
  const Index m = statics.R.rows();
  const auto stops = static_cast<Index>(options.stops.size());
  const double unit = balance.unit;
  MaxTipLoad result{max_tip_force(balance.statics, direction, {options.tolerance, options.prices}),
                    Vector3d::Zero(), VectorXd::Zero(stops), VectorXd()};
  MaxTipForce& largest = result.largest;
  const VectorXd tension = largest.tension;
  // Convert from newtons of the program to the unit of the load, and to muscles alone.
  largest.force *= unit;
  largest.component *= unit;
  largest.tension = tension.head(m);
  largest.activation = VectorXd(largest.activation.head(m));
  const bool solved = largest.status == Status::kSolved;
  largest.torque_shadow_price = solved && balance.N.cols() > 0
                                    ? VectorXd(unit * (balance.N * largest.torque_shadow_price))
                                    : VectorXd::Zero(statics.J.cols());
  largest.check.gap *= unit;
  largest.check.outside *= unit;
  if (largest.prices.increase.size() > 0)
    result.stop_price = unit / kStopArm * largest.prices.increase.segment(m, stops);
  largest.prices = prices_in(unit, m, largest.prices);
  if (!solved) return result;

  // Compute the stops, the other load, and the imbalance from J, W and R themselves.
  result.stop_torque = stop_torques(options.stops, tension.segment(m, stops));
  const VectorXd passive = passive_with_stops(statics, options.stops, result.stop_torque);
  result.other = other_load(statics, balance, largest.force, passive, tension);
  const bool moment = options.load == TipLoad::kMoment;
  VectorXd left = statics.R.transpose() * largest.tension + passive;
  left -= statics.J.transpose() * (moment ? result.other : largest.force);
  if (has_rotation(statics))
    left -= statics.W.transpose() * (moment ? largest.force : result.other);
  largest.check.imbalance = left.cwiseAbs().maxCoeff();
  return result;
}

FeasibleForceSet feasible_load_set(const TipStatics& statics, const TipLoadOptions& options) {
  const LoadBalance balance = load_balance(statics, options);
  const Index m = statics.R.rows();
  FeasibleForceSet set = feasible_force_set(balance.statics);
  set.vertices *= balance.unit;
  set.offsets *= balance.unit;
  if (set.dimension > 0) set.volume *= std::pow(balance.unit, set.dimension);
  set.tension = MatrixXd(set.tension.leftCols(m));
  set.activation = MatrixXd(set.activation.leftCols(m));
  return set;
}

VectorXd max_tip_load_gradient(const TipStatics& statics,
                               const std::vector<StaticsDerivative>& slopes,
                               const MaxTipLoad& largest, TipLoad load, DirectionFrame frame) {
  const bool moment = load == TipLoad::kMoment;
  const Vector3d& f = moment ? largest.other : largest.largest.force;
  const Vector3d& m = moment ? largest.largest.force : largest.other;
  require(has_rotation(statics) || (m.isZero(0) && frame == DirectionFrame::kWorld),
          "a moment, or a direction that turns with the tip, needs its rotation Jacobian W");
  VectorXd result(slopes.size());
  for (Index k = 0; k < result.size(); ++k) {
    // Compute the torque that the change leaves unbalanced.
    const StaticsDerivative& slope = slopes[k];
    VectorXd torque =
        slope.R.transpose() * largest.largest.tension + slope.tau_0 - slope.J.transpose() * f;
    if (has_rotation(statics)) torque -= slope.W.transpose() * m;
    // Rotate the loads if directions turn with the tip.
    if (frame == DirectionFrame::kTip) {
      const Vector3d w = statics.W.col(k);
      torque -= statics.J.transpose() * w.cross(f) + statics.W.transpose() * w.cross(m);
    }
    result(k) = largest.largest.torque_shadow_price.dot(torque);
  }
  return result;
}

}  // namespace thenar
