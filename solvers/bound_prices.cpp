#include "solvers/bound_prices.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Relative distance, over max(1, |bound|), below which a value is at its bound [1]
constexpr double kActiveTolerance = 1e-11;

/// Bounds at which the value of a variable or a row lies.
struct ActiveBounds {
  bool at_lower, at_upper;

  [[nodiscard]] bool is_inactive() const { return !at_lower && !at_upper; }
};

/// Compares a value with its bounds.
ActiveBounds active_bounds(double value, double lower, double upper) {
  const auto is_at = [value](double bound) {
    return std::isfinite(bound) &&
           std::abs(value - bound) <= kActiveTolerance * std::max(1.0, std::abs(bound));
  };
  return {is_at(lower), is_at(upper)};
}

/// Optimum of a program, with its active bounds.
struct Vertex {
  const LinearProgram& program;
  std::vector<ActiveBounds> columns, rows;
  std::vector<Index> binding;  // rows at a bound

  /// Returns whether the vertex may be degenerate. Variables strictly between their bounds are
  /// basic: if there are as many as active rows, no basic variable is at a bound, and the duals are
  /// unique.
  [[nodiscard]] bool may_be_degenerate() const {
    const auto inner = std::count_if(columns.begin(), columns.end(),
                                     [](const ActiveBounds& each) { return each.is_inactive(); });
    return inner < static_cast<std::ptrdiff_t>(binding.size());
  }
};

/// Finds the active bounds at x.
Vertex classify_bounds(const LinearProgram& program, const VectorXd& x) {
  Vertex vertex{program, {}, {}, {}};
  for (Index j = 0; j < x.size(); ++j)
    vertex.columns.push_back(active_bounds(x(j), program.lower(j), program.upper(j)));
  const VectorXd activity = program.A * x;
  for (Index i = 0; i < activity.size(); ++i) {
    vertex.rows.push_back(active_bounds(activity(i), program.row_lower(i), program.row_upper(i)));
    // An equality is active even if it is satisfied to 1e-9 only.
    if (program.row_lower(i) == program.row_upper(i)) vertex.rows.back() = {true, true};
    if (!vertex.rows.back().is_inactive()) vertex.binding.push_back(i);
  }
  return vertex;
}

/// Returns a program over all optimal duals y of the active rows: columns between their bounds have
/// zero reduced cost; those at a bound have a reduced cost of the right sign. The objective is
/// zero.
LinearProgram optimal_duals(const Vertex& vertex) {
  const LinearProgram& program = vertex.program;
  const Index n = program.A.cols(), rows = static_cast<Index>(vertex.binding.size());
  LinearProgram duals;
  duals.objective = VectorXd::Zero(rows);
  duals.A.resize(n, rows);
  duals.lower = VectorXd::Zero(rows);
  duals.upper = VectorXd::Zero(rows);
  // The sign of a row's dual depends on its active bound.
  for (Index k = 0; k < rows; ++k) {
    const Index i = vertex.binding[k];
    const ActiveBounds& at = vertex.rows[i];
    duals.A.col(k) = program.A.row(i).transpose();
    if (at.at_upper) duals.upper(k) = kInfinity;
    if (at.at_lower) duals.lower(k) = -kInfinity;
  }
  // The reduced cost of a column, objective - A' y, is >= 0 at its upper bound.
  duals.row_lower = program.objective;
  duals.row_upper = program.objective;
  for (Index j = 0; j < n; ++j) {
    const ActiveBounds& at = vertex.columns[j];
    if (at.at_upper) duals.row_lower(j) = -kInfinity;
    if (at.at_lower) duals.row_upper(j) = kInfinity;
  }
  return duals;
}

/// Returns the maximum of  sign (objective_j - A_j' y)  over all optimal duals.
double max_price(LinearProgram duals, const LinearProgram& program, Index j, double sign) {
  duals.objective = -sign * duals.A.row(j).transpose();
  const LinearResult best = solve(duals);
  if (best.status == Status::kUnbounded) return kInfinity;
  return best.status == Status::kSolved ? sign * program.objective(j) + best.objective : kNaN;
}

}  // namespace

BoundPrices upper_bound_prices(const LinearProgram& program, const LinearResult& best) {
  require(best.status == Status::kSolved && best.x.size() == program.A.cols() &&
              best.duals.size() == program.A.rows(),
          "prices need a solved program of {} variables and {} rows", program.A.cols(),
          program.A.rows());
  const Index n = program.A.cols();
  const Vertex vertex = classify_bounds(program, best.x);
  const VectorXd reduced_costs = program.objective - program.A.transpose() * best.duals;
  BoundPrices prices{VectorXd::Zero(n), VectorXd::Zero(n)};
  const bool unique = !vertex.may_be_degenerate();
  const LinearProgram duals = unique ? LinearProgram{} : optimal_duals(vertex);

  // Only active bounds have a price.
  for (Index j = 0; j < n; ++j) {
    if (!vertex.columns[j].at_upper) continue;
    const double min_dual = unique ? reduced_costs(j) : -max_price(duals, program, j, -1);
    const double max_dual = unique ? reduced_costs(j) : max_price(duals, program, j, 1);
    prices.increase(j) = std::isnan(min_dual) ? kNaN : std::max(0.0, min_dual);
    prices.decrease(j) = std::isnan(max_dual) ? kNaN : std::max(0.0, max_dual);
  }
  return prices;
}

}  // namespace thenar
