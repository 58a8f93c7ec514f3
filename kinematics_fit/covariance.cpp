#include "kinematics_fit/covariance.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "kinematics_fit/arrow_factor.h"

namespace thenar {
namespace {

constexpr double kNullCurvature = 1e-9;  // of data, per prior curvature: nothing is learnt [1]

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
  if (rows.rows() == 0) return rows;
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

namespace {

/// Layout of z, and the rows of data alone at z.
struct DataRows {
  ArrowLayout layout;
  std::vector<ArrowRows> rows;
};

DataRows data_rows(const FitProblem& problem, const Eigen::VectorXd& z) {
  const int specimens = static_cast<int>(problem.specimens().size());
  const int shared = problem.population_entries(), own = problem.deviations();
  DataRows out{{shared, own, own > 0 ? specimens : 0}, {}};
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Eigen::MatrixXd J = problem.data_residuals(z, e, WithJacobian::kYes).J;
    out.rows.push_back(
        {own > 0 ? problem.specimen_of(e) : -1, J.leftCols(shared), J.rightCols(own)});
  }
  return out;
}

/// Priors: every coordinate is standard normal.
std::vector<ArrowRows> prior_rows(const ArrowLayout& layout) {
  using Eigen::MatrixXd;
  std::vector<ArrowRows> rows{{-1, MatrixXd::Identity(layout.shared, layout.shared), {}}};
  for (int b = 0; b < layout.blocks; ++b)
    rows.push_back(
        {b, MatrixXd::Zero(layout.own, layout.shared), MatrixXd::Identity(layout.own, layout.own)});
  return rows;
}

}  // namespace

Covariance posterior_covariance(const FitProblem& problem, const Eigen::VectorXd& z) {
  // Data and priors together; the factor of J keeps digits that J'J would lose.
  const DataRows data = data_rows(problem, z);
  std::vector<ArrowRows> all = prior_rows(data.layout);
  all.insert(all.end(), data.rows.begin(), data.rows.end());
  Covariance out;
  out.C = ArrowFactor(data.layout, all).inverse();
  out.effective_parameters = static_cast<double>(z.size()) - out.C.trace();

  // What the data leave open, by singular values of their own rows.
  const double least = std::sqrt(kNullCurvature);
  const Eigen::MatrixXd N = arrow_null_space(data.layout, data.rows, least);
  const std::vector<std::string> names = problem.names();
  const Eigen::MatrixXd basis = sparse_basis(N.transpose());
  for (Eigen::Index k = 0; k < basis.rows(); ++k)
    out.nulls.push_back({describe(basis.row(k).transpose(), names), basis.row(k).transpose()});

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
