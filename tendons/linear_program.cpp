#include "tendons/linear_program.h"

#include <limits>

#include <ClpSimplex.hpp>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

constexpr double kFeasible = 1e-12;       // violation of a row that is asked for
constexpr double kBarelyFeasible = 1e-9;  // violation that is accepted where that fails
constexpr double kOptimal = 1e-9;         // of reduced costs

VectorXd clp_bounds(const VectorXd& bounds) {
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
  const auto any_nan = [](const VectorXd& v) { return v.array().isNaN().any(); };
  require(!any_nan(program.lower) && !any_nan(program.upper) && !any_nan(program.row_lower) &&
              !any_nan(program.row_upper),
          "a bound is NaN");
}

void load(ClpSimplex& simplex, const LinearProgram& program, double tolerance) {
  const VectorXd lower = clp_bounds(program.lower), upper = clp_bounds(program.upper);
  const VectorXd row_lower = clp_bounds(program.row_lower);
  const VectorXd row_upper = clp_bounds(program.row_upper);
  CoinPackedMatrix A(true, 0, 0);  // by columns
  A.setDimensions(static_cast<int>(program.A.rows()), static_cast<int>(program.A.cols()));
  for (int j = 0; j < program.A.cols(); ++j)
    for (int i = 0; i < program.A.rows(); ++i)
      if (program.A(i, j) != 0) A.modifyCoefficient(i, j, program.A(i, j));
  simplex.loadProblem(A, lower.data(), upper.data(), program.objective.data(), row_lower.data(),
                      row_upper.data());
  simplex.setOptimizationDirection(-1);  // maximise
  simplex.setPrimalTolerance(tolerance);
  simplex.setDualTolerance(kOptimal);
  simplex.setPerturbation(100);  // none: the same program gives the same vertex
  simplex.setLogLevel(0);
}

bool feasible(LinearProgram program, double tolerance) {
  ClpSimplex simplex;
  program.objective.setZero();
  load(simplex, program, tolerance);
  simplex.primal();
  return simplex.status() == 0;
}

LinearStatus status_of(const ClpSimplex& simplex, const LinearProgram& program, double tolerance) {
  switch (simplex.status()) {
    case 0:
      return LinearStatus::kSolved;
    case 1:
      return LinearStatus::kInfeasible;
    case 2:
      return feasible(program, tolerance) ? LinearStatus::kUnbounded : LinearStatus::kInfeasible;
    default:
      return LinearStatus::kStalled;
  }
}

enum class Method { kPrimal, kDual };

LinearResult solve_to(const LinearProgram& program, double tolerance, Method method) {
  ClpSimplex simplex;
  load(simplex, program, tolerance);
  if (method == Method::kPrimal)
    simplex.primal();
  else
    simplex.dual();
  LinearResult result{status_of(simplex, program, tolerance),
                      VectorXd::Zero(program.objective.size()),
                      std::numeric_limits<double>::quiet_NaN()};
  if (result.status != LinearStatus::kSolved) return result;
  if (result.x.size() > 0)
    result.x = Eigen::Map<const VectorXd>(simplex.primalColumnSolution(), result.x.size());
  if (!result.x.allFinite()) result = {LinearStatus::kStalled, VectorXd::Zero(result.x.size()), 0};
  result.x = result.x.cwiseMax(program.lower).cwiseMin(program.upper);
  result.objective = program.objective.dot(result.x);
  return result;
}

}  // namespace

LinearResult solve(const LinearProgram& program) {
  check(program);
  const LinearResult sharp = solve_to(program, kFeasible, Method::kPrimal);
  if (sharp.status == LinearStatus::kSolved || sharp.status == LinearStatus::kUnbounded)
    return sharp;
  return solve_to(program, kBarelyFeasible, Method::kDual);  // feasible but for rounding?
}

}  // namespace thenar
