#include "sampling/methods/mass_matrix.h"

#include <Eigen/Cholesky>

#include "base/error.h"

namespace thenar::internal {

MassMatrix::MassMatrix(Metric metric, int n, const Eigen::MatrixXd& covariance) : metric_(metric) {
  // The identity, unless there is a covariance to start from.
  factor_.setOnes(n, 1);
  if (dense()) factor_.setIdentity(n, n);
  if (covariance.size() == 0) return;
  require(covariance.rows() == n && covariance.cols() == n,
          "covariance must be {} x {}, got {} x {}", n, n, covariance.rows(), covariance.cols());
  require(covariance.allFinite() && covariance.isApprox(covariance.transpose(), 1e-6),
          "covariance must be finite and symmetric");
  const bool positive = dense() ? set(covariance) : set(covariance.diagonal());
  require(positive, "covariance must be positive definite");
}

void MassMatrix::drift(Eigen::VectorXd& x, const Eigen::VectorXd& r, double time) const {
  if (dense())
    x.noalias() += time * factor_ * r;
  else
    x += time * factor_.col(0).cwiseProduct(r);
}

void MassMatrix::whiten_gradient(const Eigen::VectorXd& gradient, Eigen::VectorXd& slope) const {
  if (dense())
    slope.noalias() = factor_.transpose() * gradient;
  else
    slope = factor_.col(0).cwiseProduct(gradient);
}

Eigen::MatrixXd MassMatrix::covariance() const {
  if (dense()) return factor_ * factor_.transpose();
  return factor_.cwiseAbs2();
}

bool MassMatrix::set(const Eigen::MatrixXd& covariance) {
  if (!covariance.allFinite()) return false;
  if (dense()) {
    const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
    if (cholesky.info() != Eigen::Success) return false;
    factor_ = cholesky.matrixL();
    return true;
  }
  if (covariance.minCoeff() <= 0) return false;
  factor_ = covariance.cwiseSqrt();
  return true;
}

CovarianceEstimate::CovarianceEstimate(Metric metric, int n)
    : mean_(Eigen::VectorXd::Zero(n)),
      square_(Eigen::MatrixXd::Zero(n, metric == Metric::kDense ? n : 1)) {}

void CovarianceEstimate::add(const Eigen::VectorXd& x) {
  ++count_;
  const Eigen::VectorXd before = x - mean_;
  mean_ += before / static_cast<double>(count_);
  const double weight = 1 - 1 / static_cast<double>(count_);
  // before (x - mean)' with the new mean is weight times before before'.
  if (square_.cols() == 1)
    square_ += weight * before.cwiseAbs2();
  else
    square_ += weight * before * before.transpose();
}

void CovarianceEstimate::clear() {
  count_ = 0;
  mean_.setZero();
  square_.setZero();
}

Eigen::MatrixXd CovarianceEstimate::shrunk(const Eigen::MatrixXd& before) const {
  const auto n = static_cast<double>(count_);
  return n / (n + 5) / (n - 1) * square_ + 5 / (n + 5) * 1e-3 * before;
}

void CovarianceEstimate::save(StateWriter& to) const {
  to.put(std::int64_t{count_});
  to.put(mean_);
  to.put(square_);
}

void CovarianceEstimate::restore(StateReader& from) {
  count_ = from.integer();
  mean_ = from.matrix();
  square_ = from.matrix();
}

}  // namespace thenar::internal
