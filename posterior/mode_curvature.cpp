#include "posterior/mode_curvature.h"

#include <Eigen/Eigenvalues>

namespace thenar {
namespace {

/// Factorises J'J of residuals in blocks; priors make it full rank.
ArrowFactor factor_blocks(const LeastSquares& problem, const Eigen::VectorXd& z) {
  CostDerivatives slopes = cost_derivatives(problem, z);
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (problem.lower[i] >= problem.upper[i]) fix_coordinate(slopes, i);
  return {slopes.layout, slopes.rows};
}

}  // namespace

ModeCurvature::ModeCurvature(const LeastSquares& problem, const Eigen::VectorXd& z)
    : size_(z.size()) {
  // Curvature, over the largest, below which neither data nor priors determine a direction [1]
  constexpr double kMinCurvatureShare = 1e-12;
  for (int i = 0; i < static_cast<int>(z.size()); ++i)
    if (problem.lower[i] < problem.upper[i]) free_.push_back(i);
  if (!problem.parts.empty()) {
    blocks_ = factor_blocks(problem, z);
    return;
  }
  // Compute the eigenvalues of J'J; undetermined directions get a small one.
  const Eigen::MatrixXd J = problem.residuals(z, WithJacobian::kYes).J(Eigen::all, free_);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(J.transpose() * J));
  const double largest = free_.empty() ? 0 : eigen.eigenvalues().maxCoeff();
  axes_ = eigen.eigenvectors();
  lambda_ = eigen.eigenvalues().cwiseMax(largest > 0 ? kMinCurvatureShare * largest : 1);
}

double ModeCurvature::squared_norm(const Eigen::VectorXd& apart) const {
  if (blocks_) return blocks_->squared_norm(apart);
  return (axes_.transpose() * apart(free_)).cwiseAbs2().dot(lambda_);
}

double ModeCurvature::log_determinant() const {
  return blocks_ ? blocks_->log_determinant() : lambda_.array().log().sum();
}

Eigen::VectorXd ModeCurvature::transform_normal(const Eigen::VectorXd& normal) const {
  // A fixed coordinate has no deviation.
  Eigen::VectorXd out = Eigen::VectorXd::Zero(size_);
  if (blocks_)
    out(free_) = blocks_->unwhiten(normal)(free_);
  else
    out(free_) = axes_ * lambda_.cwiseSqrt().cwiseInverse().cwiseProduct(normal(free_));
  return out;
}

Eigen::MatrixXd ModeCurvature::covariance() const {
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size_, size_);
  if (blocks_)
    C(free_, free_) = blocks_->inverse()(free_, free_);
  else
    C(free_, free_) = axes_ * lambda_.cwiseInverse().asDiagonal() * axes_.transpose();
  return C;
}

}  // namespace thenar
