#include "solvers/relative_interior.h"

#include <cmath>
#include <vector>

#include <Eigen/SVD>

#include "base/numbers.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Width below which variables, of order one, are fixed [1]
constexpr double kFixedWidth = 1e-9;
// Singular value of the equalities below which it counts as zero [1]
constexpr double kRankTolerance = 1e-12;

/// Returns an orthonormal basis of { z : E z = 0, z_i = 0 for fixed i }.
MatrixXd null_space(const MatrixXd& E, const std::vector<Index>& fixed) {
  // Stack the equalities, and one row for each fixed variable.
  MatrixXd rows = MatrixXd::Zero(E.rows() + static_cast<Index>(fixed.size()), E.cols());
  rows.topRows(E.rows()) = E;
  for (std::size_t k = 0; k < fixed.size(); ++k)
    rows(E.rows() + static_cast<Index>(k), fixed[k]) = 1;
  Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(kRankTolerance);
  MatrixXd Z = svd.matrixV().rightCols(E.cols() - svd.rank());
  for (const Index i : fixed) Z.row(i).setZero();
  return Z;
}

}  // namespace

RelativeInterior relative_interior(LinearProgram program) {
  const Index n = program.lower.size();
  // Find a feasible point.
  program.objective = VectorXd::Zero(n);
  RelativeInterior interior{Status::kSolved, {}, {}, program.lower, program.upper};
  const LinearResult feasible = solve(program);
  interior.status = feasible.status;
  if (feasible.status != Status::kSolved) return interior;

  // Restrict the set to a box of half width one around that point. This keeps the programs below
  // bounded; variables that are fixed in the box are fixed everywhere, because the set is convex.
  program.lower = program.lower.cwiseMax(feasible.x - VectorXd::Ones(n));
  program.upper = program.upper.cwiseMin(feasible.x + VectorXd::Ones(n));

  // Average the points that minimise and maximise each variable: the mean is strictly inside every
  // bound that is inactive at any point.
  std::vector<Index> fixed;
  interior.z0 = feasible.x;
  double points = 1;
  for (Index i = 0; i < n; ++i) {
    if (!std::isfinite(interior.lower(i)) && !std::isfinite(interior.upper(i))) continue;
    double range[2] = {feasible.x(i), feasible.x(i)};
    for (const int end : {0, 1}) {
      program.objective = (end == 0 ? -1 : 1) * VectorXd::Unit(n, i);
      const LinearResult extreme = solve(program);
      // The program is bounded and feasible, so this cannot happen.
      if (extreme.status != Status::kSolved) {
        interior.status = Status::kStalled;
        return interior;
      }
      range[end] = extreme.x(i);
      interior.z0 += extreme.x;
      ++points;
    }
    if (range[1] - range[0] <= kFixedWidth) fixed.push_back(i);
  }
  interior.z0 /= points;
  // Eliminate the fixed variables.
  interior.Z = null_space(program.A, fixed);
  for (const Index i : fixed) {
    interior.lower(i) = -kInfinity;
    interior.upper(i) = kInfinity;
  }
  return interior;
}

NonlinearProgram program_over_interior(const RelativeInterior& interior) {
  // Collect the finite bounds, which become constraints of y.
  std::vector<Index> bounded;
  for (Index i = 0; i < interior.z0.size(); ++i)
    if (std::isfinite(interior.lower(i)) || std::isfinite(interior.upper(i))) bounded.push_back(i);
  const Index k = interior.Z.cols(), rows = static_cast<Index>(bounded.size());
  MatrixXd Z(rows, k);
  NonlinearProgram program;
  program.lower = VectorXd::Constant(k, -kInfinity);
  program.upper = VectorXd::Constant(k, kInfinity);
  program.row_lower.resize(rows);
  program.row_upper.resize(rows);
  for (Index row = 0; row < rows; ++row) {
    const Index i = bounded[row];
    Z.row(row) = interior.Z.row(i);
    program.row_lower(row) = interior.lower(i) - interior.z0(i);
    program.row_upper(row) = interior.upper(i) - interior.z0(i);
  }
  program.constraints = [Z](const VectorXd& y) -> VectorXd { return Z * y; };
  program.jacobian = [Z](const VectorXd&) { return Z; };
  return program;
}

}  // namespace thenar::internal
