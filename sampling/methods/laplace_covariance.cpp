#include "sampling/methods/laplace_covariance.h"

#include <Eigen/Eigenvalues>

namespace thenar {
namespace {

constexpr double kGradientStep = 1e-4;  // step of the finite differences of gradients [prior sds]
constexpr double kMinBend = 0.05;       // minimum curvature; that of the prior is 1 [1]

}  // namespace

Eigen::MatrixXd laplace_covariance(const Target& target, const Eigen::VectorXd& x) {
  // Compute central differences of the gradient along every coordinate in one evaluation.
  const Eigen::Index n = x.size();
  Eigen::MatrixXd points = x.replicate(1, 2 * n);
  points.leftCols(n).diagonal().array() += kGradientStep;
  points.rightCols(n).diagonal().array() -= kGradientStep;
  const Densities at = target.evaluate(points, WithGradient::kYes);
  const Eigen::MatrixXd gradient = at.prior_gradient + at.likelihood_gradient;
  const Eigen::MatrixXd bend = (gradient.rightCols(n) - gradient.leftCols(n)) / (2 * kGradientStep);
  if (!bend.allFinite()) return Eigen::MatrixXd::Identity(n, n);
  // Invert the symmetric part, with positive curvatures.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      Eigen::MatrixXd((bend + bend.transpose()) / 2));
  const Eigen::VectorXd positive = eigen.eigenvalues().cwiseAbs().cwiseMax(kMinBend);
  return eigen.eigenvectors() * positive.cwiseInverse().asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace thenar
