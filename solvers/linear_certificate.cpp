#include "solvers/linear_certificate.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/numbers.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// Maximum violation of a row, over max(1, its terms) [1]
constexpr double kFeasibilityError = 1e-12;
constexpr double kDualError = 1e-11;  // maximum violation of a dual, over max(1, its terms) [1]
constexpr double kGapError = 1e-11;   // maximum duality gap, over max(1, |objective|) [1]
constexpr int kBasisRefinements = 2;  // refinements of a linear system; one reaches rounding

/// Returns column k of [A, -1].
VectorXd column(const LinearProgram& program, Index k) {
  const Index n = program.A.cols();
  return k < n ? VectorXd(program.A.col(k)) : VectorXd(-VectorXd::Unit(program.A.rows(), k - n));
}

/// Solves S x = b with iterative refinement in long double.
template <typename Solver>
VectorXd solve_refined(const Solver& solver, const MatrixXd& S, const LongVector& b) {
  LongVector x = LongVector::Zero(b.size());
  for (int k = 0; k <= kBasisRefinements; ++k) {
    const LongVector residual = b - S.cast<long double>() * x;
    x += solver.solve(VectorXd(residual.cast<double>())).template cast<long double>();
  }
  return x.cast<double>();
}

/// Dual of a variable, with the value and the bounds of the variable.
struct BoundDual {
  long double price;
  double terms;  // sum of the absolute values of the terms of the price
  double value, lower, upper;
};

/// Adds the contribution of a dual to the certificate.
void add_dual(const BoundDual& dual, LinearCertificate& certificate) {
  // A zero dual does not contribute.
  const auto price = static_cast<double>(std::abs(dual.price));
  const double bound = dual.price > 0 ? dual.upper : dual.lower;
  if (price == 0) return;
  // Price times distance to the bound.
  if (std::isfinite(bound)) {
    certificate.gap += price * std::abs(bound - dual.value);
    return;
  }
  // The bound to which the price belongs is infinite.
  certificate.dual_violation =
      max_or_nan(certificate.dual_violation, price / std::max(1.0, dual.terms));
  certificate.gap += price * std::abs(dual.value);
}

double violation(double value, double lower, double upper, double terms) {
  return max_or_nan({0.0, lower - value, value - upper}) / std::max(1.0, terms);
}

}  // namespace

PrimalDualPoint vertex_of(const LinearProgram& program, const SimplexBasis& basis) {
  const Index n = program.A.cols(), rows = program.A.rows();
  // Assemble the basis matrix and its costs.
  VectorXd all = basis.values, costs = VectorXd::Zero(n + rows), basic_costs(rows);
  costs.head(n) = program.objective;
  MatrixXd B(rows, rows);
  for (Index k = 0; k < rows; ++k) {
    const Index variable = basis.basic[k];
    B.col(k) = column(program, variable);
    basic_costs(k) = costs(variable);
    all(variable) = 0;
  }
  if (rows == 0) return {all.cwiseMax(program.lower).cwiseMin(program.upper), VectorXd(0)};

  // Solve for the basic variables, and for the duals.
  const LongVector nonbasic = all.cast<long double>();
  const LongVector right_side =
      nonbasic.tail(rows) - program.A.cast<long double>() * nonbasic.head(n);
  const Eigen::PartialPivLU<MatrixXd> lu(B);
  const VectorXd values = solve_refined(lu, B, right_side);
  const MatrixXd B_transposed = B.transpose();
  const Eigen::PartialPivLU<MatrixXd> lu_transposed(B_transposed);
  const VectorXd duals =
      solve_refined(lu_transposed, B_transposed, basic_costs.cast<long double>());

  // Project the vertex onto its bounds.
  for (Index k = 0; k < rows; ++k) all(basis.basic[k]) = values(k);
  const VectorXd x = all.head(n);
  if (!x.allFinite()) return {x, duals};
  return {x.cwiseMax(program.lower).cwiseMin(program.upper), duals};
}

LinearCertificate certify(const LinearProgram& program, const PrimalDualPoint& point) {
  LinearCertificate certificate{0, 0, 0};
  const VectorXd &x = point.x, &y = point.duals;
  if (!x.allFinite() || !y.allFinite()) return {kNaN, kNaN, kNaN};
  const auto record_violation = [&](double value) {
    certificate.violation = max_or_nan(certificate.violation, value);
  };

  // Columns: reduced costs.
  for (Index j = 0; j < x.size(); ++j) {
    long double price = program.objective(j);
    double terms = std::abs(program.objective(j));
    for (Index i = 0; i < y.size(); ++i) {
      price -= static_cast<long double>(program.A(i, j)) * y(i);
      terms += std::abs(program.A(i, j) * y(i));
    }
    record_violation(violation(x(j), program.lower(j), program.upper(j), std::abs(x(j))));
    add_dual({price, terms, x(j), program.lower(j), program.upper(j)}, certificate);
  }

  // Rows.
  for (Index i = 0; i < y.size(); ++i) {
    long double activity = 0;
    double terms = 0;
    for (Index j = 0; j < x.size(); ++j) {
      activity += static_cast<long double>(program.A(i, j)) * x(j);
      terms += std::abs(program.A(i, j) * x(j));
    }
    const auto value = static_cast<double>(activity);
    record_violation(violation(value, program.row_lower(i), program.row_upper(i), terms));
    add_dual({y(i), std::abs(y(i)), value, program.row_lower(i), program.row_upper(i)},
             certificate);
  }
  return certificate;
}

bool is_certified(const LinearCertificate& certificate, double objective) {
  return certificate.violation <= kFeasibilityError && certificate.dual_violation <= kDualError &&
         certificate.gap <= kGapError * std::max(1.0, std::abs(objective));
}

}  // namespace thenar::internal
