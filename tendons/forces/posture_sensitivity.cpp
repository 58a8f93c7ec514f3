#include "tendons/forces/posture_sensitivity.h"

#include <algorithm>
#include <utility>

#include <Eigen/SVD>

#include "base/error.h"
#include "base/numbers.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kAngleStep = 1e-3;  // step of the finite differences [rad]

/// Least-squares solution of minimum norm,  x = B+ tau.
struct TipLeastSquares {
  MatrixXd B, inverse;   // matrix and its pseudo-inverse B+
  VectorXd x, residual;  // solution, and residual tau - B x
  Index rank;            // rank of B

  TipLeastSquares(MatrixXd matrix, const VectorXd& tau) : B(std::move(matrix)) {
    // Compute pseudo-inverse, solution and residual.
    Eigen::JacobiSVD<MatrixXd> svd(B, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(internal::kRankTolerance);
    rank = svd.rank();
    inverse = svd.solve(MatrixXd::Identity(B.rows(), B.rows()));
    x = inverse * tau;
    residual = tau - B * x;
  }

  /// Computes dx for changes of B and tau at constant rank.
  [[nodiscard]] VectorXd slope(const MatrixXd& dB, const VectorXd& dtau) const {
    const VectorXd across = dB.transpose() * (inverse.transpose() * x);
    return inverse * (dtau - dB * x) +
           inverse * (inverse.transpose() * (dB.transpose() * residual)) + across -
           inverse * (B * across);
  }
};

/// Computes the derivative of the joint torques of tensions t.
VectorXd torque_slope(const StaticsDerivative& slope, const VectorXd& t) {
  return slope.R.transpose() * t + slope.tau_0;
}

}  // namespace

TipStatics tip_statics(const DigitTendons& tendons, const VectorXd& q) {
  TipStatics statics = tip_statics(tendons.digit(), q);
  const auto muscles = static_cast<Index>(tendons.digit().names.muscles.size());
  statics.R = tendons.evaluate(q, VectorXd::Zero(muscles)).R;
  return statics;
}

std::vector<StaticsDerivative> statics_derivatives(const DigitTendons& tendons, const VectorXd& q) {
  std::vector<StaticsDerivative> slopes;
  for (Index k = 0; k < q.size(); ++k) {
    // Take differences of fourth order: two steps each way.
    const auto at = [&](double steps) {
      return tip_statics(tendons, q + steps * kAngleStep * VectorXd::Unit(q.size(), k));
    };
    const TipStatics a = at(1), b = at(-1), c = at(2), d = at(-2);
    const auto slope = [&](auto member) {
      return (8 * (a.*member - b.*member) - (c.*member - d.*member)) / (12 * kAngleStep);
    };
    slopes.push_back({slope(&TipStatics::J), slope(&TipStatics::W), slope(&TipStatics::R),
                      slope(&TipStatics::tau_0)});
  }
  return slopes;
}

Eigen::Matrix3Xd tip_force_jacobian(const TipStatics& statics,
                                    const std::vector<StaticsDerivative>& slopes,
                                    const VectorXd& t) {
  // Solve for force and residual at this posture.
  const TipLeastSquares force(statics.J.transpose(), statics.R.transpose() * t + statics.tau_0);
  const auto n = static_cast<Index>(slopes.size());
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Constant(3, n, kInfinity);
  // Leave infinity where the rank is below that of a regular posture and the force jumps.
  const bool planar = has_rotation(statics) && plane_normal(statics.J, statics.W).has_value();
  const bool regular = force.rank == (planar ? 2 : 3);
  for (Index k = 0; regular && k < n; ++k) {
    const StaticsDerivative& slope = slopes[k];
    result.col(k) = force.slope(slope.J.transpose(), torque_slope(slope, t));
  }
  return result;
}

MatrixXd tip_wrench_jacobian(const TipStatics& statics,
                             const std::vector<StaticsDerivative>& slopes, const VectorXd& t,
                             const TipWrenchOptions& options) {
  require(has_rotation(statics), "a held tip needs the rotation Jacobian W of the tip");
  // Scale the unknowns to moment / length and force.
  const auto n = static_cast<Index>(slopes.size());
  const auto joined = [&](const Eigen::Matrix3Xd& W, const Eigen::Matrix3Xd& J) {
    MatrixXd B(J.cols(), 6);
    B << options.length * W.transpose(), J.transpose();
    return B;
  };
  const TipLeastSquares wrench(joined(statics.W, statics.J),
                               statics.R.transpose() * t + statics.tau_0);
  MatrixXd result = MatrixXd::Constant(6, n, kInfinity);
  const Index possible = plane_normal(statics.J, statics.W) ? 3 : 6;
  const bool regular = wrench.rank == std::min(n, possible);
  for (Index k = 0; regular && k < n; ++k) {
    const StaticsDerivative& slope = slopes[k];
    result.col(k) = wrench.slope(joined(slope.W, slope.J), torque_slope(slope, t));
  }
  // Convert back to moments.
  result.topRows<3>() *= options.length;
  return result;
}

}  // namespace thenar
