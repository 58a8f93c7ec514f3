#include "grasp/quality/task_margin.h"

#include <algorithm>

#include <Eigen/QR>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kIndependentShare = 1e-9;  // least share of the longest axis across the others [1]

/// Appends variables p with |p| <= half width, which form the last rows of the wrench.
void add_box(ForceSet& forces, Index size, double half_width) {
  // New wrench columns: unit vectors of the last rows.
  internal::append_variables(forces, size);
  forces.wrench.bottomRightCorner(size, size).setIdentity();
  // Limits  p <= half width  and  -p <= half width.
  MatrixXd limits = MatrixXd::Zero(2 * size, forces.wrench.cols());
  limits.topRightCorner(size, size).setIdentity();
  limits.bottomRightCorner(size, size) = -MatrixXd::Identity(size, size);
  internal::append_limits(forces, limits, Eigen::VectorXd::Constant(2 * size, half_width));
  forces.effort_unit.resize(0);  // efforts no longer stand last, and are not asked for
}

/// Forces whose wrench is Q y, with y as the first rows of the new wrench and zeros below.
ForceSet slice_along(ForceSet forces, const Eigen::ColPivHouseholderQR<MatrixXd>& Q) {
  // Rows across Q must vanish.
  const Index rank = Q.rank(), across = 6 - rank, old = forces.A.rows();
  const MatrixXd basis = Q.householderQ() * MatrixXd::Identity(6, 6);
  forces.A.conservativeResize(old + across, forces.wrench.cols());
  forces.A.bottomRows(across) = basis.rightCols(across).transpose() * forces.wrench;
  forces.b.conservativeResize(old + across);
  forces.b.tail(across).setZero();
  // Coordinates along Q replace the wrench.
  const MatrixXd y = Q.solve(MatrixXd(forces.wrench));
  forces.wrench.setZero();
  forces.wrench.topRows(rank) = y;
  return forces;
}

}  // namespace

TaskMargin margin_of_loads(const ForceSet& forces, const std::vector<ScaledWrench>& loads) {
  TaskMargin margin{Status::kSolved, kInfinity, kInfinity, ScaledWrench{}, 0};
  for (const ScaledWrench& load : loads) {
    // The smallest margin counts; a load without limit sets none.
    if (load.is_zero()) continue;
    const WrenchSupport reach = load_margin(forces, load);
    if (reach.status == Status::kUnbounded) continue;
    margin.residual = max_or_nan(margin.residual, reach.residual);
    if (reach.status != Status::kSolved)
      return {reach.status, reach.value, reach.bound, load, margin.residual};
    if (reach.value < margin.lower) margin.worst_load = load;
    margin.lower = std::min(margin.lower, reach.value);
    margin.upper = std::min(margin.upper, reach.bound);
  }
  return margin;
}

TaskMargin margin_of_box(const ForceSet& forces, const ScaledWrench& lowest,
                         const ScaledWrench& highest) {
  const WrenchCoordinates lower = lowest.vector(), upper = highest.vector();
  require(lower.allFinite() && upper.allFinite() && (lower.array() <= upper.array()).all(),
          "the box of loads needs finite bounds, lower <= upper");
  // All different corners of the box.
  std::vector<ScaledWrench> corners;
  for (int corner = 0; corner < 64; ++corner) {
    WrenchCoordinates load = lower;
    bool repeated = false;
    for (int i = 0; i < 6; ++i) {
      const bool high = (corner >> i & 1) != 0;
      if (high) load(i) = upper(i);
      repeated = repeated || (high && lower(i) == upper(i));
    }
    if (!repeated) corners.push_back(ScaledWrench::from_coordinates(load));
  }
  return margin_of_loads(forces, corners);
}

TaskMargin margin_of_ellipsoid(const ForceSet& forces,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& Q,
                               const BallOptions& options) {
  // Independent axes, in coordinates in which the ellipsoid is a ball.
  require(Q.cols() > 0 && Q.allFinite(), "an ellipsoid needs finite axes, got {}", Q.cols());
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(kIndependentShare);
  qr.compute(Q);
  require(qr.rank() == Q.cols(), "{} axes of the ellipsoid span {} dimensions", Q.cols(),
          qr.rank());
  ForceSet sliced = slice_along(forces, qr);
  if (is_unlimited(sliced, static_cast<int>(Q.cols())))
    return {Status::kSolved, kInfinity, kInfinity, ScaledWrench{}, 0};
  // Missing dimensions get a box, wider than the slice, which does not change its ball.
  if (Q.cols() < 6) {
    const WrenchSupport any = wrench_support(sliced, ScaledWrench::unit(0));
    const double width = any.status == Status::kSolved ? any.value : options.max_total_force;
    add_box(sliced, 6 - Q.cols(), 2 * std::max(width, 1e-3));
  }
  const InscribedBall ball = inscribed_ball(sliced, options);
  return {ball.status, std::max(0.0, ball.lower), std::max(0.0, ball.upper),
          ScaledWrench::from_coordinates(Q * ball.worst_load.vector().head(Q.cols())),
          ball.residual};
}

}  // namespace thenar
