#include "kinematics_fit/activation_residuals.h"

#include <cmath>

#include <Eigen/Cholesky>

namespace thenar {
namespace {

/// Returns the lower triangle of X with half of its diagonal: d(L) = L half_lower(L^-1 dS L^-T)
/// where L L' = S.
Eigen::Matrix3d half_lower(const Eigen::Matrix3d& X) {
  Eigen::Matrix3d out = X.triangularView<Eigen::StrictlyLower>();
  out.diagonal() = 0.5 * X.diagonal();
  return out;
}

}  // namespace

Residuals activation_residuals(const ActivationTask& task,
                               const Eigen::Ref<const Eigen::Matrix3Xd>& A,
                               const Eigen::Ref<const Eigen::MatrixXd>& A_u) {
  // Sum the error and the covariance; a component that is not fitted has residual 0 and variance 1,
  // and adds nothing.
  const auto pulls = static_cast<Eigen::Index>(task.pulls.size());
  const Eigen::Vector3d noise = task.sd.array().isFinite().select(task.sd, Eigen::Vector3d::Ones());
  Eigen::Vector3d error = task.sd.array().isFinite().select(-task.force, Eigen::Vector3d::Zero());
  Eigen::Matrix3d S = noise.cwiseAbs2().asDiagonal();
  for (Eigen::Index j = 0; j < pulls; ++j) {
    const MuscleTension& pull = task.pulls[j];
    error += pull.tension * A.col(j);
    S += pull.variance * A.col(j) * A.col(j).transpose();
  }

  // Whiten the error; widening is the log determinant that errors of tensions add to the noise.
  const Eigen::LLT<Eigen::Matrix3d> llt(S);
  const Eigen::Matrix3d L = llt.matrixL();
  const Eigen::Vector3d r = L.triangularView<Eigen::Lower>().solve(error);
  const double widening =
      2 * (L.diagonal().array().log().sum() - noise.array().log().sum());  // >= 0 but for rounding
  const double s = std::sqrt(std::max(0.0, widening));
  Residuals out;
  out.r.resize(4);
  out.r << r, s;
  if (A_u.cols() == 0) return out;

  // Differentiate: dr = L^-1 d(error) - half_lower(L^-1 dS L^-T) r,  ds = tr(S^-1 dS) / (2 s).
  out.J.resize(4, A_u.cols());
  for (Eigen::Index c = 0; c < A_u.cols(); ++c) {
    Eigen::Vector3d by_error = Eigen::Vector3d::Zero();
    Eigen::Matrix3d by_S = Eigen::Matrix3d::Zero();
    for (Eigen::Index j = 0; j < pulls; ++j) {
      const MuscleTension& pull = task.pulls[j];
      const Eigen::Vector3d slope = A_u.block<3, 1>(3 * j, c);
      by_error += pull.tension * slope;
      by_S += pull.variance * (slope * A.col(j).transpose() + A.col(j) * slope.transpose());
    }
    const Eigen::Matrix3d left = L.triangularView<Eigen::Lower>().solve(by_S);
    const Eigen::Matrix3d both =
        L.triangularView<Eigen::Lower>().solve(left.transpose()).transpose();
    out.J.col(c).head<3>() =
        L.triangularView<Eigen::Lower>().solve(by_error) - half_lower(both) * r;
    out.J(3, c) = s > 0 ? both.trace() / (2 * s) : 0;
  }
  return out;
}

}  // namespace thenar
