#include "tendons/forces/tip_force.h"

#include <limits>

#include <Eigen/SVD>

#include "base/error.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

/// Solves  J' f = tau  in least squares, with minimum norm where f is not unique.
/// @param possible  rank of J_W in a regular posture
TipForce balance(const Eigen::Matrix3Xd& J_W, const Eigen::VectorXd& tau, int possible) {
  const Eigen::MatrixXd Jt = J_W.transpose();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(Jt, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(internal::kRankTolerance);
  const auto& sigma = svd.singularValues();

  const Eigen::Vector3d f_W = svd.solve(tau);
  const bool straight = svd.rank() < possible;
  const double condition =
      straight ? std::numeric_limits<double>::infinity() : sigma(0) / sigma(possible - 1);
  return {f_W, tau - Jt * f_W, condition, static_cast<int>(svd.rank()), possible};
}

}  // namespace

TipForce tip_force(const Eigen::Ref<const Eigen::Matrix3Xd>& J_W,
                   const Eigen::Ref<const Eigen::MatrixXd>& R,
                   const Eigen::Ref<const Eigen::VectorXd>& t) {
  require(J_W.cols() > 0, "a finger without joints balances nothing");
  require(R.cols() == J_W.cols(), "R has {} joints, J_W has {}", R.cols(), J_W.cols());
  require(J_W.allFinite() && R.allFinite(), "J_W and R must be finite");
  internal::require_tension(R.rows(), t);
  return balance(J_W, R.transpose() * t, 3);
}

TipForce tip_force(const TipStatics& statics, const Eigen::Ref<const Eigen::VectorXd>& t) {
  internal::require_statics(statics);
  internal::require_tension(statics.R.rows(), t);
  const bool planar = has_rotation(statics) && plane_normal(statics.J, statics.W).has_value();
  return balance(statics.J, statics.R.transpose() * t + statics.tau_0, planar ? 2 : 3);
}

}  // namespace thenar
