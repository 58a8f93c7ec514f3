#include "kinematics_fit/covariance.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

namespace thenar {
namespace {

/// Names a direction by its largest components, at most three.
std::string describe(const Eigen::VectorXd& direction, const std::vector<std::string>& names) {
  std::vector<int> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, order.size()); ++k) {
    const double share = direction[order[k]];
    if (k > 0 && std::abs(share) < 0.1) break;
    if (std::abs(share) > 0.995)
      text = names[order[k]];
    else
      text += fmt::format("{}{:+.2f} {}", k > 0 ? " " : "", share, names[order[k]]);
  }
  return text + ": not identifiable";
}

/// Turns a basis of a null space so that as many coordinates as possible stand alone in it:
/// Gauss-Jordan with full pivoting, each row scaled to unit length.
Eigen::MatrixXd sparse_basis(Eigen::MatrixXd rows) {
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    Eigen::Index pivot_row = 0, pivot_column = 0;
    rows.bottomRows(rows.rows() - k).cwiseAbs().maxCoeff(&pivot_row, &pivot_column);
    rows.row(k).swap(rows.row(k + pivot_row));
    rows.row(k) /= rows(k, pivot_column);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      if (i != k) rows.row(i) -= rows(i, pivot_column) * rows.row(k).eval();
  }
  return rows.rowwise().normalized();
}

}  // namespace

Covariance posterior_covariance(const FitProblem& problem, const Eigen::VectorXd& z) {
  constexpr double kNull = 1e-9;  // data curvature per prior curvature
  const Residuals at = problem.evaluate(z, WithJacobian::kYes);
  const Eigen::MatrixXd data = at.J.topRows(problem.data_rows());
  const Eigen::MatrixXd H = data.transpose() * data;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(H);
  const Eigen::VectorXd& lambda = eigen.eigenvalues();
  const Eigen::MatrixXd& V = eigen.eigenvectors();

  Covariance out;
  const Eigen::VectorXd shrink = (1 + lambda.array().max(0)).inverse();
  out.C = V * shrink.asDiagonal() * V.transpose();
  out.effective_parameters = (lambda.array().max(0) * shrink.array()).sum();

  const std::vector<std::string> names = problem.names();
  const auto nulls = (lambda.array() < kNull).count();
  const Eigen::MatrixXd N = V.leftCols(nulls);  // eigenvalues are sorted
  if (nulls > 0) {
    const Eigen::MatrixXd basis = sparse_basis(N.transpose());
    for (Eigen::Index k = 0; k < nulls; ++k)
      out.nulls.push_back({describe(basis.row(k).transpose(), names), basis.row(k).transpose()});
  }
  constexpr double kOnBound = 1e-6;  // interior-point solvers stop a little short [1]
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const bool at_bound =
        z[i] < problem.lower()[i] + kOnBound || z[i] > problem.upper()[i] - kOnBound;
    out.learnt.push_back(
        {names[i], z[i], std::sqrt(out.C(i, i)), N.row(i).squaredNorm(), at_bound});
  }
  return out;
}

std::vector<int> by_knowledge(const Covariance& covariance) {
  std::vector<int> order(covariance.learnt.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return covariance.learnt[static_cast<std::size_t>(a)].sd <
           covariance.learnt[static_cast<std::size_t>(b)].sd;
  });
  return order;
}

}  // namespace thenar
