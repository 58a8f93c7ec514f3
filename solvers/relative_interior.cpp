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
constexpr double kPinnedWidth = 1e-9;
// Singular value of the equalities below which it counts as zero [1]
constexpr double kDependentValue = 1e-12;

/// Returns an orthonormal basis of { z : E z = 0, z_i = 0 for pinned i }.
MatrixXd null_space(const MatrixXd& E, const std::vector<Index>& pinned) {
  // Stack the equalities, and one row for each fixed variable.
  MatrixXd rows = MatrixXd::Zero(E.rows() + static_cast<Index>(pinned.size()), E.cols());
  rows.topRows(E.rows()) = E;
  for (std::size_t k = 0; k < pinned.size(); ++k)
    rows(E.rows() + static_cast<Index>(k), pinned[k]) = 1;
  Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(kDependentValue);
  MatrixXd Z = svd.matrixV().rightCols(E.cols() - svd.rank());
  for (const Index i : pinned) Z.row(i).setZero();
  return Z;
}

}  // namespace

RelativeInterior relative_interior(LinearProgram program) {
  const Index n = program.lower.size();
  // Find a feasible point.
  program.objective = VectorXd::Zero(n);
  RelativeInterior interior{Status::kSolved, {}, {}, program.lower, program.upper};
  const LinearResult any = solve(program);
  interior.status = any.status;
  if (any.status != Status::kSolved) return interior;

  // Restrict the set to a box of half width one around that point. This keeps the programs below
  // bounded; variables that are fixed in the box are fixed everywhere, because the set is convex.
  program.lower = program.lower.cwiseMax(any.x - VectorXd::Ones(n));
  program.upper = program.upper.cwiseMin(any.x + VectorXd::Ones(n));

  // Average the points that minimise and maximise each variable: the mean is strictly inside every
  // bound that is inactive at any point.
  std::vector<Index> pinned;
  interior.z0 = any.x;
  double points = 1;
  for (Index i = 0; i < n; ++i) {
    if (!std::isfinite(interior.lower(i)) && !std::isfinite(interior.upper(i))) continue;
    double reached[2] = {any.x(i), any.x(i)};
    for (const int end : {0, 1}) {
      program.objective = (end == 0 ? -1 : 1) * VectorXd::Unit(n, i);
      const LinearResult extreme = solve(program);
      if (extreme.status !=
          Status::kSolved) {  // cannot happen: the program is bounded and feasible
        interior.status = Status::kStalled;
        return interior;
      }
      reached[end] = extreme.x(i);
      interior.z0 += extreme.x;
      ++points;
    }
    if (reached[1] - reached[0] <= kPinnedWidth) pinned.push_back(i);
  }
  interior.z0 /= points;
  // Eliminate the fixed variables.
  interior.Z = null_space(program.A, pinned);
  for (const Index i : pinned) {
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
