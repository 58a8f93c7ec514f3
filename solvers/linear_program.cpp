#include "solvers/linear_program.h"

#include <cmath>
#include <optional>

#include <ClpSimplex.hpp>

#include "base/error.h"
#include "base/numbers.h"
#include "solvers/dense_simplex.h"
#include "solvers/linear_certificate.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::SimplexBasis;

constexpr double kClpTolerance = 1e-12;         // violation of rows that CLP allows
constexpr double kOptimalityError = 1e-11;      // violation of reduced costs that CLP allows
constexpr double kMaxRoundingViolation = 1e-9;  // sum of violations that rounding may cause

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

void load(ClpSimplex& simplex, const LinearProgram& program) {
  // Copy the matrix by columns, without zeros.
  const VectorXd lower = clp_bounds(program.lower), upper = clp_bounds(program.upper);
  const VectorXd row_lower = clp_bounds(program.row_lower);
  const VectorXd row_upper = clp_bounds(program.row_upper);
  CoinPackedMatrix A(true, 0, 0);  // column-major
  A.setDimensions(static_cast<int>(program.A.rows()), static_cast<int>(program.A.cols()));
  for (int j = 0; j < program.A.cols(); ++j)
    for (int i = 0; i < program.A.rows(); ++i)
      if (program.A(i, j) != 0) A.modifyCoefficient(i, j, program.A(i, j));
  simplex.loadProblem(A, lower.data(), upper.data(), program.objective.data(), row_lower.data(),
                      row_upper.data());
  // Choose settings that make answers reproducible.
  simplex.setOptimizationDirection(-1);  // maximise
  simplex.scaling(0);                    // scaling would hide wrong signs of reduced costs
  simplex.setPrimalTolerance(kClpTolerance);
  simplex.setDualTolerance(kOptimalityError);
  simplex.setPerturbation(100);  // none: the same program gives the same vertex
  simplex.setLogLevel(0);
}

/// Proposal of a method. It is not trusted: `claim` only indicates what to prove.
struct Proposal {
  Status claim;
  std::optional<SimplexBasis> basis;
};

/// Returns CLP's final basis; nothing if the number of basic variables is not that of the rows.
std::optional<SimplexBasis> basis_of(const ClpSimplex& simplex, const LinearProgram& program) {
  const Index n = program.A.cols(), rows = program.A.rows();
  SimplexBasis basis{{}, VectorXd::Zero(n + rows)};
  const auto add = [&](Index k, ClpSimplex::Status status, double value, double lower,
                       double upper) {
    if (status == ClpSimplex::basic) {
      basis.basic.push_back(k);
      return;
    }
    const bool at_upper = std::abs(value - upper) < std::abs(value - lower);
    const double nearest = at_upper ? upper : lower;
    basis.values(k) = std::isfinite(nearest) ? nearest : value;
  };
  // Columns, then rows.
  for (Index j = 0; j < n; ++j)
    add(j, simplex.getColumnStatus(static_cast<int>(j)), simplex.primalColumnSolution()[j],
        program.lower(j), program.upper(j));
  for (Index i = 0; i < rows; ++i)
    add(n + i, simplex.getRowStatus(static_cast<int>(i)), simplex.primalRowSolution()[i],
        program.row_lower(i), program.row_upper(i));
  if (static_cast<Index>(basis.basic.size()) != rows) return std::nullopt;
  return basis;
}

enum class Method { kClpPrimal, kClpDual, kDense };
constexpr Method kLinearMethods[] = {Method::kClpPrimal, Method::kClpDual, Method::kDense};

Proposal propose(const LinearProgram& program, Method method) {
  if (method == Method::kDense) {
    const internal::SimplexVertex vertex = internal::dense_simplex(program);
    return {vertex.claim, vertex.basis};
  }
  // Run CLP's primal or dual method.
  ClpSimplex simplex;
  load(simplex, program);
  method == Method::kClpPrimal ? simplex.primal() : simplex.dual();
  constexpr Status kEnds[] = {Status::kSolved, Status::kInfeasible, Status::kUnbounded};
  const int status = simplex.status();
  const Status claim = status >= 0 && status < 3 ? kEnds[status] : Status::kStalled;
  return {claim, basis_of(simplex, program)};
}

LinearResult unsolved(const LinearProgram& program, Status status) {
  return {status,
          VectorXd::Zero(program.A.cols()),
          kNaN,
          VectorXd::Zero(program.A.rows()),
          {kNaN, kNaN, kNaN}};
}

/// Returns the vertex of a basis if its certificate holds.
std::optional<LinearResult> certified_result(const LinearProgram& program,
                                             const Proposal& proposal) {
  if (!proposal.basis) return std::nullopt;
  const internal::PrimalDualPoint point = internal::vertex_of(program, *proposal.basis);
  const double objective = program.objective.dot(point.x);
  const LinearCertificate certificate = internal::certify(program, point);
  if (!internal::is_certified(certificate, objective)) return std::nullopt;
  return LinearResult{Status::kSolved, point.x, objective, point.duals, certificate};
}

/// Tries every method until a result is certified; for programs that have an optimum.
LinearResult find_optimum(const LinearProgram& program) {
  for (const Method method : kLinearMethods)
    if (const auto result = certified_result(program, propose(program, method))) return *result;
  return unsolved(program, Status::kStalled);
}

/// Returns the program  maximise -sum (p + q)  subject to  row_lower <= A x + p - q <= row_upper.
/// It always has an optimum, and its duals are a Farkas ray if that is not zero.
LinearProgram elastic_program(const LinearProgram& program) {
  const Index n = program.A.cols(), rows = program.A.rows();
  LinearProgram result = program;
  // Add two variables for the violation of each row.
  result.A.resize(rows, n + 2 * rows);
  result.A << program.A, MatrixXd::Identity(rows, rows), -MatrixXd::Identity(rows, rows);
  result.objective = -VectorXd::Ones(n + 2 * rows);
  result.objective.head(n).setZero();
  result.lower = VectorXd::Zero(n + 2 * rows);
  result.lower.head(n) = program.lower;
  result.upper = VectorXd::Constant(n + 2 * rows, kInfinity);
  result.upper.head(n) = program.upper;
  return result;
}

/// Returns the program of recession directions, no component longer than one.
LinearProgram recession_program(LinearProgram program) {
  const auto homogeneous = [](double bound) { return std::isfinite(bound) ? 0.0 : bound; };
  program.row_lower = program.row_lower.unaryExpr(homogeneous);
  program.row_upper = program.row_upper.unaryExpr(homogeneous);
  program.lower = program.lower.unaryExpr(homogeneous).cwiseMax(-1);
  program.upper = program.upper.unaryExpr(homogeneous).cwiseMin(1);
  return program;
}

/// Finds whether a feasible point exists. Rows that are violated by rounding only are relaxed.
/// @param proof  receives the optimum of the elastic program: a point, or duals that are a Farkas
///         ray
Status find_feasible(LinearProgram& program, LinearResult& proof) {
  // Minimise the sum of violations.
  proof = find_optimum(elastic_program(program));
  if (proof.status != Status::kSolved) return Status::kStalled;
  if (-proof.objective > kMaxRoundingViolation) return Status::kInfeasible;
  // Relax the rows by violations due to rounding.
  const Index rows = program.A.rows();
  const VectorXd added = proof.x.segment(proof.x.size() - 2 * rows, rows);
  program.row_lower -= added;
  program.row_upper += proof.x.tail(rows);
  return Status::kSolved;
}

/// Handles a program without certified optimum: proves that there is none, or relaxes rows to
/// rounding.
LinearResult resolve_without_optimum(const LinearProgram& original) {
  LinearProgram program = original;
  LinearResult proof;
  const Status feasible = find_feasible(program, proof);
  if (feasible != Status::kSolved) {
    LinearResult result = unsolved(program, feasible);
    result.certificate = proof.certificate;
    if (feasible == Status::kInfeasible) result.ray = proof.duals;
    return result;
  }
  // Find a ray along which the objective improves without limit.
  const LinearResult ray = find_optimum(recession_program(program));
  if (ray.status == Status::kSolved && ray.objective > kMaxRoundingViolation) {
    LinearResult result = unsolved(program, Status::kUnbounded);
    result.certificate = ray.certificate;
    result.x = proof.x.head(program.A.cols());
    result.ray = ray.x;
    return result;
  }
  // Solve with relaxed rows, and report the violation of the original ones.
  LinearResult result = find_optimum(program);
  if (result.status == Status::kSolved)
    result.certificate.violation = internal::certify(original, {result.x, result.duals}).violation;
  return result;
}

bool bounds_cross(const LinearProgram& program) {
  return (program.lower.array() > program.upper.array()).any() ||
         (program.row_lower.array() > program.row_upper.array()).any();
}

/// Solves a program with duals and objective of order one.
LinearResult solve_scaled(const LinearProgram& program) {
  // A claim that there is no optimum is proved or refuted at once.
  for (const Method method : kLinearMethods) {
    const Proposal proposal = propose(program, method);
    if (const auto result = certified_result(program, proposal)) return *result;
    if (proposal.claim == Status::kInfeasible || proposal.claim == Status::kUnbounded) {
      LinearResult result = resolve_without_optimum(program);
      if (result.status != Status::kStalled) return result;
    }
  }
  return resolve_without_optimum(program);
}

}  // namespace

LinearResult solve(const LinearProgram& program) {
  check(program);
  if (bounds_cross(program)) return unsolved(program, Status::kInfeasible);
  // Scale the objective to order one.
  const double size = program.objective.size() > 0 ? program.objective.cwiseAbs().maxCoeff() : 0;
  if (size == 0) return solve_scaled(program);
  LinearProgram scaled = program;
  scaled.objective /= size;
  LinearResult result = solve_scaled(scaled);
  if (result.status != Status::kSolved) return result;
  // Restore the original scale.
  result.objective = program.objective.dot(result.x);
  result.duals *= size;
  result.certificate.gap *= size;
  return result;
}

}  // namespace thenar
