#include "tendons/linear_program.h"

#include <algorithm>
#include <limits>

#include <ClpSimplex.hpp>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kTolerance = 1e-9;  // primal and dual, in the units of rows and columns

Eigen::VectorXd clp_bounds(const Eigen::VectorXd& bounds) {
  return bounds.cwiseMax(-COIN_DBL_MAX).cwiseMin(COIN_DBL_MAX);
}

void check(const LinearProgram& program) {
  const Eigen::Index n = program.objective.size(), rows = program.row_lower.size();
  require(program.A.cols() == n && program.lower.size() == n && program.upper.size() == n,
          "objective has {} variables, A {}, bounds {} and {}", n, program.A.cols(),
          program.lower.size(), program.upper.size());
  require(program.A.rows() == rows && program.row_upper.size() == rows,
          "A has {} rows, its bounds {} and {}", program.A.rows(), rows, program.row_upper.size());
  require(program.A.allFinite() && program.objective.allFinite(),
          "A and the objective must be finite");
  const auto any_nan = [](const Eigen::VectorXd& v) { return v.array().isNaN().any(); };
  require(!any_nan(program.lower) && !any_nan(program.upper) && !any_nan(program.row_lower) &&
              !any_nan(program.row_upper),
          "a bound is NaN");
}

void load(ClpSimplex& simplex, const LinearProgram& program) {
  const Eigen::VectorXd lower = clp_bounds(program.lower), upper = clp_bounds(program.upper);
  const Eigen::VectorXd row_lower = clp_bounds(program.row_lower);
  const Eigen::VectorXd row_upper = clp_bounds(program.row_upper);
  CoinPackedMatrix A(true, 0, 0);  // by columns
  A.setDimensions(static_cast<int>(program.A.rows()), static_cast<int>(program.A.cols()));
  for (int j = 0; j < program.A.cols(); ++j)
    for (int i = 0; i < program.A.rows(); ++i)
      if (program.A(i, j) != 0) A.modifyCoefficient(i, j, program.A(i, j));
  simplex.loadProblem(A, lower.data(), upper.data(), program.objective.data(), row_lower.data(),
                      row_upper.data());
  simplex.setOptimizationDirection(-1);  // maximise
  simplex.setPrimalTolerance(kTolerance);
  simplex.setDualTolerance(kTolerance);
  simplex.setPerturbation(100);  // none: the same program gives the same vertex
  simplex.setLogLevel(0);
}

bool feasible(LinearProgram program) {
  ClpSimplex simplex;
  program.objective.setZero();
  load(simplex, program);
  simplex.primal();
  return simplex.status() == 0;
}

LinearStatus status_of(const ClpSimplex& simplex, const LinearProgram& program) {
  switch (simplex.status()) {
    case 0:
      return LinearStatus::kSolved;
    case 1:
      return LinearStatus::kInfeasible;
    case 2:
      return feasible(program) ? LinearStatus::kUnbounded : LinearStatus::kInfeasible;
    default:
      return LinearStatus::kStalled;
  }
}

}  // namespace

LinearResult solve(const LinearProgram& program) {
  check(program);
  ClpSimplex simplex;
  load(simplex, program);
  simplex.primal();

  LinearResult result{status_of(simplex, program), Eigen::VectorXd::Zero(program.objective.size()),
                      std::numeric_limits<double>::quiet_NaN()};
  if (result.status != LinearStatus::kSolved) return result;
  if (result.x.size() > 0)
    result.x = Eigen::Map<const Eigen::VectorXd>(simplex.primalColumnSolution(), result.x.size());
  result.x = result.x.cwiseMax(program.lower).cwiseMin(program.upper);
  result.objective = program.objective.dot(result.x);
  return result;
}

}  // namespace thenar
