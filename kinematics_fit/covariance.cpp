#include "kinematics_fit/covariance.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

// Curvature of data over that of the prior below which nothing is learnt [1]
constexpr double kNullCurvature = 1e-9;

using Direction = Eigen::SparseVector<double>;

/// The unit vector along values that stand at coordinates from `first` on, among n.
Direction unit_along(const Eigen::VectorXd& values, Eigen::Index first, Eigen::Index n) {
  Direction out(n);
  const Eigen::VectorXd unit = values.normalized();
  for (Eigen::Index i = 0; i < unit.size(); ++i)
    if (unit[i] != 0) out.insertBack(first + i) = unit[i];
  return out;
}

/// Names a direction by its largest components, at most three.
std::string describe(const Direction& direction, const std::vector<std::string>& names) {
  constexpr std::ptrdiff_t kMaxNamedComponents = 3;  // Most components that are named
  // Components by falling size.
  std::vector<std::pair<double, Eigen::Index>> shares;
  for (Direction::InnerIterator at(direction); at; ++at)
    shares.emplace_back(at.value(), at.index());
  const auto end =
      shares.begin() + std::min<std::ptrdiff_t>(kMaxNamedComponents, direction.nonZeros());
  std::partial_sort(shares.begin(), end, shares.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first) > std::abs(b.first);
  });
  // The largest alone if it is nearly everything, otherwise those above a tenth.
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

/// Rows that span a space, each of which alone holds its pivot's coordinate, there 1.
struct PivotedRows {
  Eigen::MatrixXd rows;
  std::vector<Eigen::Index> pivots;  // column of each row's pivot
};

/// Turns rows so that as many coordinates as possible stand alone in them: Gauss-Jordan with full
/// pivoting among the first `columns`.
PivotedRows sparse_basis(Eigen::MatrixXd rows, Eigen::Index columns) {
  PivotedRows out{std::move(rows), {}};
  Eigen::MatrixXd& all = out.rows;
  // Pivot: the largest entry that is left, brought to row k and scaled to 1.
  for (Eigen::Index k = 0; k < all.rows(); ++k) {
    Eigen::Index row = 0, column = 0;
    all.bottomRows(all.rows() - k).leftCols(columns).cwiseAbs().maxCoeff(&row, &column);
    all.row(k).swap(all.row(k + row));
    all.row(k) /= all(k, column);
    // Eliminate the pivot's column from all other rows.
    Eigen::VectorXd others = all.col(column);
    others[k] = 0;
    all -= others * all.row(k).eval();
    out.pivots.push_back(column);
  }
  return out;
}

/// Layout of z, and the rows of data alone at z.
struct DataRows {
  ArrowLayout layout;
  std::vector<ArrowRows> rows;
};

DataRows rows_of_data(const FitProblem& problem, const Eigen::VectorXd& z) {
  const int specimens = static_cast<int>(problem.specimens().size());
  const int shared = problem.coordinates().population_entries(),
            own = problem.coordinates().deviations();
  // Slopes of each experiment, by the population's entries and its specimen's own.
  DataRows out{{shared, own, own > 0 ? specimens : 0}, {}};
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Eigen::MatrixXd J = data_residuals(problem, z, e, WithJacobian::kYes).J;
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

/// Length of coordinate i within the null space, squared.
double null_share(const ArrowLayout& layout, const ArrowNullSpace& null_directions,
                  Eigen::Index i) {
  const double together = null_directions.coupled.row(i).squaredNorm();
  if (i < layout.shared) return together;
  const Eigen::Index block = (i - layout.shared) / layout.own;
  return together +
         null_directions.own[block].row(i - layout.first(static_cast<int>(block))).squaredNorm();
}

/// Every null direction by name: those of shared coordinates, then those of each block.
void name_nulls(const ArrowLayout& layout, const ArrowNullSpace& null_directions,
                const std::vector<std::string>& names, std::vector<NullDirection>& out) {
  const auto add = [&](const Eigen::VectorXd& values, Eigen::Index first) {
    const Direction unit = unit_along(values, first, layout.size());
    out.push_back({describe(unit, names), unit});
  };
  // What a block leaves open can be added to a direction of all, until its pivots drop out.
  Eigen::MatrixXd together = null_directions.coupled.transpose();
  std::vector<PivotedRows> alone;
  for (int b = 0; b < layout.blocks; ++b) {
    alone.push_back(sparse_basis(null_directions.own[b].transpose(), layout.own));
    auto own = together.middleCols(layout.first(b), layout.own);
    own -= own(Eigen::all, alone.back().pivots).eval() * alone.back().rows;
  }

  // Directions that involve shared coordinates come first.
  const PivotedRows shared = sparse_basis(std::move(together), layout.shared);
  for (Eigen::Index k = 0; k < shared.rows.rows(); ++k) add(shared.rows.row(k).transpose(), 0);
  // Then the directions within each block.
  for (int b = 0; b < layout.blocks; ++b)
    for (Eigen::Index k = 0; k < alone[b].rows.rows(); ++k)
      add(alone[b].rows.row(k).transpose(), layout.first(b));
}

/// The factor of data and priors together; that of J keeps digits that J'J would lose.
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
  Covariance out;
  const ArrowFactor factor = factor_of(data);
  out.C = factor.inverse_blocks();
  for (const ArrowRows& rows : data.rows) out.leverage.push_back(factor.whiten(rows));
  const Eigen::VectorXd variance = out.C.diagonal();
  out.effective_parameters = static_cast<double>(z.size()) - variance.sum();

  // What the data leave open, by singular values of their own rows.
  const ArrowNullSpace null_directions =
      arrow_null_space(data.layout, data.rows, std::sqrt(kNullCurvature));
  const std::vector<std::string> names = problem.coordinates().names();
  name_nulls(data.layout, null_directions, names, out.null_directions);

  // Estimates, entry by entry.
  // Distance at which z is at a bound: interior-point solvers stop a little short [1]
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
