#include "kinematics_fit/covariance.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

// Curvature of the data over that of the prior below which a direction is not identifiable [1]
constexpr double kNullCurvature = 1e-9;

using Direction = Eigen::SparseVector<double>;

/// Returns the unit vector along `values`, which are its coordinates from `first` on, among n.
Direction unit_along(const Eigen::VectorXd& values, Eigen::Index first, Eigen::Index n) {
  Direction out(n);
  const Eigen::VectorXd unit = values.normalized();
  for (Eigen::Index i = 0; i < unit.size(); ++i)
    if (unit[i] != 0) out.insertBack(first + i) = unit[i];
  return out;
}

/// Names a direction by its largest components, at most three.
std::string describe(const Direction& direction, const std::vector<std::string>& names) {
  constexpr std::ptrdiff_t kMaxNamedComponents = 3;  // largest number of components in a name
  // Sort components by magnitude.
  std::vector<std::pair<double, Eigen::Index>> shares;
  for (Direction::InnerIterator at(direction); at; ++at)
    shares.emplace_back(at.value(), at.index());
  const auto end =
      shares.begin() + std::min<std::ptrdiff_t>(kMaxNamedComponents, direction.nonZeros());
  std::partial_sort(shares.begin(), end, shares.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first) > std::abs(b.first);
  });
  // Name only the largest if it is nearly everything, otherwise all those above a tenth.
  std::string text;
  for (auto at = shares.begin(); at != end; ++at) {
    const auto& [share, index] = *at;
    const std::string& name = names[index];
    if (at != shares.begin() && std::abs(share) < 0.1) break;
    if (std::abs(share) > 0.995)
      text = name;
    else
      text += fmt::format("{}{:+.2f} {}", at != shares.begin() ? " " : "", share, name);
  }
  return text + ": not identifiable";
}

/// Rows that span a space; each has a 1 in its pivot column, where all other rows are zero.
struct PivotedRows {
  Eigen::MatrixXd rows;
  std::vector<Eigen::Index> pivots;  // column of each row's pivot
};

/// Reduces rows by Gauss-Jordan elimination with full pivoting among the first `columns`, so that
/// each pivot column is nonzero in one row only.
PivotedRows sparse_basis(Eigen::MatrixXd rows, Eigen::Index columns) {
  PivotedRows out{std::move(rows), {}};
  Eigen::MatrixXd& all = out.rows;
  // Bring the largest remaining entry, the pivot, to row k and scale it to 1.
  for (Eigen::Index k = 0; k < all.rows(); ++k) {
    Eigen::Index row = 0, column = 0;
    all.bottomRows(all.rows() - k).leftCols(columns).cwiseAbs().maxCoeff(&row, &column);
    all.row(k).swap(all.row(k + row));
    all.row(k) /= all(k, column);
    // Eliminate the pivot column from all other rows.
    Eigen::VectorXd others = all.col(column);
    others[k] = 0;
    all -= others * all.row(k).eval();
    out.pivots.push_back(column);
  }
  return out;
}

/// Layout of z, and the rows of the data, without priors, at z.
struct DataRows {
  ArrowLayout layout;
  std::vector<ArrowRows> rows;
};

DataRows rows_of_data(const FitProblem& problem, const Eigen::VectorXd& z) {
  const int specimens = static_cast<int>(problem.specimens().size());
  const int shared = problem.coordinates().population_entries(),
            own = problem.coordinates().deviations();
  // Collect the slopes of each experiment by the population's entries and by those of its specimen.
  DataRows out{{shared, own, own > 0 ? specimens : 0}, {}};
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Eigen::MatrixXd J = data_residuals(problem, z, e, WithJacobian::kYes).J;
    out.rows.push_back(
        {own > 0 ? problem.specimen_of(e) : -1, J.leftCols(shared), J.rightCols(own)});
  }
  return out;
}

/// Returns the rows of the priors: every coordinate is standard normal.
std::vector<ArrowRows> prior_rows(const ArrowLayout& layout) {
  using Eigen::MatrixXd;
  std::vector<ArrowRows> rows{{-1, MatrixXd::Identity(layout.shared, layout.shared), {}}};
  for (int b = 0; b < layout.blocks; ++b)
    rows.push_back(
        {b, MatrixXd::Zero(layout.own, layout.shared), MatrixXd::Identity(layout.own, layout.own)});
  return rows;
}

/// Returns the squared length of the projection of coordinate i onto the null space.
double null_share(const ArrowLayout& layout, const ArrowNullSpace& null_directions,
                  Eigen::Index i) {
  const double together = null_directions.coupled.row(i).squaredNorm();
  if (i < layout.shared) return together;
  const Eigen::Index block = (i - layout.shared) / layout.own;
  return together + null_directions.own[block]
                        .row(i - layout.first_index(static_cast<int>(block)))
                        .squaredNorm();
}

/// Names every null direction: those that involve shared coordinates, then those of each block.
void name_nulls(const ArrowLayout& layout, const ArrowNullSpace& null_directions,
                const std::vector<std::string>& names, std::vector<NullDirection>& out) {
  const auto add = [&](const Eigen::VectorXd& values, Eigen::Index first) {
    const Direction unit = unit_along(values, first, layout.size());
    out.push_back({describe(unit, names), unit});
  };
  // Subtract null directions of single blocks from the coupled ones, so that their pivots vanish
  // there.
  Eigen::MatrixXd together = null_directions.coupled.transpose();
  std::vector<PivotedRows> alone;
  for (int b = 0; b < layout.blocks; ++b) {
    alone.push_back(sparse_basis(null_directions.own[b].transpose(), layout.own));
    auto own = together.middleCols(layout.first_index(b), layout.own);
    own -= own(Eigen::all, alone.back().pivots).eval() * alone.back().rows;
  }

  // Add the directions that involve shared coordinates.
  const PivotedRows shared = sparse_basis(std::move(together), layout.shared);
  for (Eigen::Index k = 0; k < shared.rows.rows(); ++k) add(shared.rows.row(k).transpose(), 0);
  // Add the directions within each block.
  for (int b = 0; b < layout.blocks; ++b)
    for (Eigen::Index k = 0; k < alone[b].rows.rows(); ++k)
      add(alone[b].rows.row(k).transpose(), layout.first_index(b));
}

/// Returns the factor of data and priors together; a factor of J keeps digits that J'J would lose.
ArrowFactor factor_of(const DataRows& data) {
  std::vector<ArrowRows> all = prior_rows(data.layout);
  all.insert(all.end(), data.rows.begin(), data.rows.end());
  return {data.layout, all};
}

}  // namespace

ArrowMatrix laplace_blocks(const FitProblem& problem, const Eigen::VectorXd& z) {
  return factor_of(rows_of_data(problem, z)).inverse_blocks();
}

Covariance posterior_covariance(const FitProblem& problem, const Eigen::VectorXd& z) {
  const DataRows data = rows_of_data(problem, z);
  // Factor the posterior, and compute leverages and the effective number of parameters.
  Covariance out;
  const ArrowFactor factor = factor_of(data);
  out.C = factor.inverse_blocks();
  for (const ArrowRows& rows : data.rows) out.leverage.push_back(factor.whiten(rows));
  const Eigen::VectorXd variance = out.C.diagonal();
  out.effective_parameters = static_cast<double>(z.size()) - variance.sum();

  // Find what the data leave undetermined, by the singular values of their rows.
  const ArrowNullSpace null_directions =
      arrow_null_space(data.layout, data.rows, std::sqrt(kNullCurvature));
  const std::vector<std::string> names = problem.coordinates().names();
  name_nulls(data.layout, null_directions, names, out.null_directions);

  // List the estimates.
  // Distance from a bound that still counts as on it: interior-point solvers stop a little short
  // [1]
  constexpr double kOnBound = 1e-6;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const bool at_bound = z[i] < problem.coordinates().lower()[i] + kOnBound ||
                          z[i] > problem.coordinates().upper()[i] - kOnBound;
    out.learnt.push_back({names[i], z[i], std::sqrt(variance[i]),
                          null_share(data.layout, null_directions, i), at_bound});
  }
  return out;
}

std::vector<int> sorted_by_sd(const Covariance& covariance) {
  std::vector<int> order(covariance.learnt.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return covariance.learnt[a].sd < covariance.learnt[b].sd; });
  return order;
}

}  // namespace thenar
