#include "solvers/least_squares.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/QR>

#include "base/error.h"

namespace thenar {
namespace {

Solution run_method(const LeastSquares& problem, const Eigen::VectorXd& start,
                    const SolveOptions& options) {
  if (options.method == LeastSquaresMethod::kCeres)
    return internal::solve_ceres(problem, start, options);
  return options.method == LeastSquaresMethod::kIpopt
             ? internal::solve_ipopt_least_squares(problem, start, options)
             : internal::solve_nlopt(problem, start, options);
}

/// Rejects a point that violates constraints, whatever status the solver returned.
void refute_if_infeasible(const LeastSquares& problem, LeastSquaresMethod method,
                          Solution& solution) {
  if (!problem.constraints) return;
  const Eigen::VectorXd c = problem.constraints(solution.z).c;
  // A NaN counts as a violation.
  const auto satisfied = ((c.array() >= problem.c_lower.array() - internal::kMaxViolation) &&
                          (c.array() <= problem.c_upper.array() + internal::kMaxViolation))
                             .count();
  if (satisfied == c.size()) return;
  if (solution.status == Status::kSolved) solution.status = Status::kStalled;
  solution.message +=
      fmt::format("; breaks {} of {} constraints{}", c.size() - satisfied, c.size(),
                  method == LeastSquaresMethod::kIpopt ? "" : ", which only ipopt honours");
}

/// Returns the coordinates that their bounds do not fix.
std::vector<int> find_free_coordinates(const LeastSquares& problem) {
  std::vector<int> free;
  for (Eigen::Index i = 0; i < problem.lower.size(); ++i)
    if (problem.upper[i] - problem.lower[i] > internal::kMinWidth ||
        !std::isfinite(problem.lower[i]))
      free.push_back(static_cast<int>(i));
  return free;
}

/// Returns the problem of the free coordinates, with all others fixed as in `at`.
LeastSquares reduce_to_free(const LeastSquares& problem, const std::vector<int>& free,
                            const Eigen::VectorXd& at) {
  const auto expand = [free, at](const Eigen::VectorXd& free_z) {
    Eigen::VectorXd z = at;
    z(free) = free_z;
    return z;
  };
  LeastSquares rest;
  rest.lower = problem.lower(free);
  rest.upper = problem.upper(free);
  rest.residuals = [&problem, free, expand](const Eigen::VectorXd& free_z, WithJacobian want) {
    Residuals out = problem.residuals(expand(free_z), want);
    if (want == WithJacobian::kYes) out.J = out.J(Eigen::all, free).eval();
    return out;
  };
  if (!problem.constraints) return rest;
  rest.c_lower = problem.c_lower;
  rest.c_upper = problem.c_upper;
  rest.constraints = [&problem, free, expand](const Eigen::VectorXd& free_z) {
    ConstraintValues out = problem.constraints(expand(free_z));
    out.C = out.C(Eigen::all, free).eval();
    return out;
  };
  return rest;
}

/// Returns the start as the solution of a problem without free coordinates.
Solution fixed_solution(const LeastSquares& problem, const Eigen::VectorXd& start) {
  Solution solution;
  solution.z = start;
  solution.cost = 0.5 * problem.residuals(start, WithJacobian::kNo).r.squaredNorm();
  solution.status = Status::kSolved;
  solution.message = "bounds leave nothing to move";
  solution.evaluations = 1;
  return solution;
}

/// Returns the length of the remaining Newton step without constraints.
double unconstrained_newton_step(const LeastSquares& problem, const Eigen::VectorXd& z,
                                 CostDerivatives slopes) {
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (internal::is_held(problem, z, slopes.gradient[i], i)) fix_coordinate(slopes, i);
  return ArrowFactor(slopes.layout, slopes.rows).whiten(slopes.gradient).norm();
}

/// Returns the rows of active constraints that oppose the descent direction.
Eigen::MatrixXd active_rows(const LeastSquares& problem, const Eigen::VectorXd& z,
                            const Eigen::VectorXd& gradient) {
  // Distance from a bound below which scaled constraints are active [1]
  constexpr double kActiveDistance = 1e-5;
  // Collect constraints at one of their bounds.
  const ConstraintValues at = problem.constraints(z);
  std::vector<Eigen::Index> active;
  for (Eigen::Index k = 0; k < at.c.size(); ++k)
    if (at.c[k] < problem.c_lower[k] + kActiveDistance ||
        at.c[k] > problem.c_upper[k] - kActiveDistance)
      active.push_back(k);
  // Drop constraints with a multiplier of the wrong sign, the largest first.
  while (!active.empty()) {
    Eigen::MatrixXd rows = at.C(active, Eigen::all);
    const Eigen::VectorXd push = rows.transpose().completeOrthogonalDecomposition().solve(gradient);
    Eigen::Index worst = -1;
    double max_pull = 1e-9 * push.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < push.size(); ++k) {
      const bool lower = at.c[active[k]] < problem.c_lower[active[k]] + kActiveDistance;
      const double pull = lower ? -push[k] : push[k];
      if (pull > max_pull) {
        max_pull = pull;
        worst = k;
      }
    }
    if (worst < 0) return rows;
    active.erase(active.begin() + worst);
  }
  return {0, z.size()};
}

/// Returns an orthonormal basis of the null space of A, whose rows may be dependent.
Eigen::MatrixXd null_basis(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return Eigen::MatrixXd::Identity(A.cols(), A.cols());
  // Pivot, over the largest, below which a row is dependent [1]
  constexpr double kDependentPivot = 1e-9;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A.transpose());
  qr.setThreshold(kDependentPivot);
  const Eigen::MatrixXd Q = qr.householderQ();
  return Q.rightCols(A.cols() - qr.rank());
}

/// Returns the length of the remaining Newton step in the directions left free by bounds and active
/// constraints.
double constrained_newton_step(const LeastSquares& problem, const Eigen::VectorXd& z,
                               const CostDerivatives& slopes) {
  // Find the free directions.
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (!internal::is_held(problem, z, slopes.gradient[i], i)) free.push_back(i);
  const Eigen::VectorXd gradient = slopes.gradient(free);
  const Eigen::MatrixXd J = dense_rows(slopes.layout, slopes.rows)(Eigen::all, free);
  const Eigen::MatrixXd A = active_rows(problem, z, slopes.gradient)(Eigen::all, free);
  const Eigen::MatrixXd basis = null_basis(A);
  // Newton step within them.
  if (basis.cols() == 0) return 0;
  const ArrowLayout layout{static_cast<int>(basis.cols())};
  return ArrowFactor(layout, {{-1, J * basis, {}}}).whiten(basis.transpose() * gradient).norm();
}

/// Computes cost, gradient and Jacobian at z; nothing if the residuals have no Jacobian.
std::optional<CostDerivatives> exact_derivatives(const LeastSquares& problem,
                                                 const Eigen::VectorXd& z) {
  CostDerivatives out;
  out.gradient = Eigen::VectorXd::Zero(z.size());
  if (problem.parts.empty()) {
    Residuals at = problem.residuals(z, WithJacobian::kYes);
    if (at.J.rows() != at.r.size() || at.J.cols() != z.size()) return {};
    out.layout.shared = static_cast<int>(z.size());
    out.cost = 0.5 * at.r.squaredNorm();
    out.gradient = at.J.transpose() * at.r;
    out.rows.push_back({-1, std::move(at.J), {}});
    return out;
  }
  out.layout = problem.layout;
  // Add each part to the shared gradient and to that of its block.
  const int shared = out.layout.shared, own = out.layout.own;
  for (const ResidualPart& part : problem.parts) {
    const Residuals at = part.residuals(z, WithJacobian::kYes);
    if (at.J.rows() != at.r.size() || at.J.cols() != shared + (part.block < 0 ? 0 : own)) return {};
    out.cost += 0.5 * at.r.squaredNorm();
    out.gradient.head(shared) += at.J.leftCols(shared).transpose() * at.r;
    out.rows.push_back({part.block, at.J.leftCols(shared), {}});
    if (part.block < 0) continue;
    out.gradient.segment(out.layout.first_index(part.block), own) +=
        at.J.rightCols(own).transpose() * at.r;
    out.rows.back().own = at.J.rightCols(own);
  }
  return out;
}

/// Computes gradient and Jacobian by finite differences of residuals without Jacobian. No point
/// outside the bounds is evaluated.
CostDerivatives derivatives_by_differences(const LeastSquares& problem, const Eigen::VectorXd& z) {
  // Relative step of central differences: the cube root of the rounding error [1]
  constexpr double kRelativeStep = 6e-6;
  const Eigen::VectorXd r = problem.residuals(z, WithJacobian::kNo).r;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(r.size(), z.size());
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const double step = kRelativeStep * std::max(1.0, std::abs(z[i]));
    Eigen::VectorXd below = z, above = z;
    below[i] = std::max(z[i] - step, problem.lower[i]);
    above[i] = std::min(z[i] + step, problem.upper[i]);
    if (!(above[i] > below[i])) continue;  // held by its bounds
    J.col(i) = (problem.residuals(above, WithJacobian::kNo).r -
                problem.residuals(below, WithJacobian::kNo).r) /
               (above[i] - below[i]);
  }
  CostDerivatives out;
  out.cost = 0.5 * r.squaredNorm();
  out.gradient = J.transpose() * r;
  out.layout.shared = static_cast<int>(z.size());
  out.rows.push_back({-1, std::move(J), {}});
  return out;
}

/// Certifies z, and updates the status.
void certify(const LeastSquares& problem, const SolveOptions& options, Solution& solution) {
  if (solution.kink_sides > 1) return;  // certified at a kink
  // Compute the remaining Newton step; NaN if a difference is not finite.
  std::optional<CostDerivatives> exact = exact_derivatives(problem, solution.z);
  const CostDerivatives slopes =
      exact ? std::move(*exact) : derivatives_by_differences(problem, solution.z);
  solution.newton_step = std::nan("");
  if (slopes.gradient.allFinite()) {
    const bool constrained = problem.constraints && options.method == LeastSquaresMethod::kIpopt;
    solution.newton_step = constrained ? constrained_newton_step(problem, solution.z, slopes)
                                       : unconstrained_newton_step(problem, solution.z, slopes);
  }
  // Step up to which differences of a solution are negligible [sd]
  constexpr double kNegligibleStep = 0.01;
  // Compare it with the step that the tolerance allows.
  const double allowed =
      std::max(kNegligibleStep, std::sqrt(20 * options.tolerance * solution.cost));
  if (solution.status == Status::kSolved && !(solution.newton_step <= allowed)) {
    solution.status = Status::kStalled;
    solution.message += fmt::format("; but a step of {:.2g} sds is left", solution.newton_step);
  }
}

/// Restarts Ceres once where it stalled, with the strictest tolerance.
void restart_ceres(const LeastSquares& problem, const SolveOptions& options, Solution& solution) {
  SolveOptions strict = options;
  strict.tolerance = std::min(options.tolerance, 1e-15);
  const Solution first = solution;
  solution = internal::solve_ceres(problem, first.z, strict);
  solution.evaluations += first.evaluations;
  certify(problem, options, solution);
}

/// Solves for the free coordinates: some solvers fail with equal bounds.
Solution solve_free(const LeastSquares& problem, const Eigen::VectorXd& start,
                    const SolveOptions& options) {
  const std::vector<int> free = find_free_coordinates(problem);
  if (free.empty()) return fixed_solution(problem, start);
  // Ceres handles fixed coordinates of blocks.
  const bool blocks = options.method == LeastSquaresMethod::kCeres && !problem.parts.empty();
  if (static_cast<Eigen::Index>(free.size()) == start.size() || blocks)
    return run_method(problem, start, options);
  // Other methods solve a reduced problem.
  Solution solution = run_method(reduce_to_free(problem, free, start), start(free), options);
  Eigen::VectorXd z = start;
  z(free) = solution.z;
  solution.z = z;
  return solution;
}

/// Solves by the requested method. With kCeres and without a limit on evaluations, structured
/// secants need fewer evaluations near the solution: they are tried from the start if residuals
/// come in blocks, and otherwise, or if that does not converge soon, after a rough solution by
/// Ceres. If they fail, too, Ceres continues.
Solution solve_by_method(const LeastSquares& problem, const Eigen::VectorXd& start,
                         const SolveOptions& options) {
  constexpr double kRoughTolerance = 1e-3;  // relative tolerance of the rough solution [1]
  constexpr int kFirstEvaluations = 80, kLastEvaluations = 200;  // limits of secant searches [1]
  // Use other methods, and counted evaluations, as they are.
  if (options.method != LeastSquaresMethod::kCeres || options.max_evaluations > 0 ||
      options.tolerance >= kRoughTolerance)
    return solve_free(problem, start, options);
  // Try secants from the start.
  Solution found;
  found.z = start;
  if (!problem.parts.empty() &&
      internal::search_by_secants(problem, options, kFirstEvaluations, found))
    return found;
  // Find a rough solution, and refine it by secants.
  const auto continue_by_method = [&](double tolerance) {
    SolveOptions next = options;
    next.tolerance = tolerance;
    Solution then = solve_free(problem, found.z, next);
    then.evaluations += found.evaluations;
    found = std::move(then);
  };
  continue_by_method(kRoughTolerance);
  if (found.status != Status::kSolved ||
      internal::search_by_secants(problem, options, kLastEvaluations, found))
    return found;
  // Secants fail at kinks; otherwise Ceres continues.
  if (internal::search_at_kink(problem, options, found)) return found;
  continue_by_method(options.tolerance);
  return found;
}

/// Checks sizes and bounds of the problem.
void check_shapes(const LeastSquares& problem, const Eigen::VectorXd& start) {
  const Eigen::Index n = problem.lower.size();
  require(static_cast<bool>(problem.residuals), "least squares need residuals");
  require(problem.upper.size() == n, "there are {} lower bounds, but {} upper ones", n,
          problem.upper.size());
  require(start.size() == n && start.allFinite(), "start needs {} finite entries, got {}", n,
          start.size());
  for (Eigen::Index i = 0; i < n; ++i)
    require(problem.lower[i] <= problem.upper[i], "bounds {} .. {} of coordinate {} are crossed",
            problem.lower[i], problem.upper[i], i);
  // Constraints.
  const Eigen::Index rows = problem.c_lower.size();
  require(problem.c_upper.size() == rows, "constraints have {} lower bounds, but {} upper ones",
          rows, problem.c_upper.size());
  require(rows == 0 || problem.constraints,
          "{} constraints are bounded but no function computes them", rows);
  for (Eigen::Index k = 0; k < rows; ++k)
    require(problem.c_lower[k] <= problem.c_upper[k],
            "bounds {} .. {} of constraint {} are crossed", problem.c_lower[k], problem.c_upper[k],
            k);
  // Blocks.
  if (problem.parts.empty()) return;
  const ArrowLayout& layout = problem.layout;
  require(layout.size() == n, "the blocks have {} coordinates, the bounds {}", layout.size(), n);
  for (const ResidualPart& part : problem.parts)
    require(part.block >= -1 && part.block < layout.blocks, "no block {}: there are {}", part.block,
            layout.blocks);
}

/// Checks the values that the functions of a problem return at the start.
void check_values(const LeastSquares& problem, const Eigen::VectorXd& z,
                  LeastSquaresMethod method) {
  const bool derivatives =
      method == LeastSquaresMethod::kCeres || method == LeastSquaresMethod::kIpopt;
  const bool blocks = method == LeastSquaresMethod::kCeres && !problem.parts.empty();
  const Residuals whole =
      problem.residuals(z, derivatives && !blocks ? WithJacobian::kYes : WithJacobian::kNo);
  require(whole.r.allFinite(), "residuals at the start are not finite");
  const bool has_jacobian = blocks ? exact_derivatives(problem, z).has_value()
                                   : whole.J.rows() == whole.r.size() && whole.J.cols() == z.size();
  require(has_jacobian || !derivatives, "{} needs the Jacobian of the residuals by {} coordinates",
          name_of(method), z.size());
  if (!problem.constraints) return;
  const ConstraintValues at = problem.constraints(z);
  const Eigen::Index rows = problem.c_lower.size();
  require(at.c.size() == rows && at.C.rows() == rows && (rows == 0 || at.C.cols() == z.size()),
          "{} bounds of constraints, but {} values and a Jacobian of {} x {}", rows, at.c.size(),
          at.C.rows(), at.C.cols());
}

}  // namespace

void fix_coordinate(CostDerivatives& slopes, Eigen::Index i) {
  // Find the position of the coordinate in its block.
  const ArrowLayout& layout = slopes.layout;
  const int block = i < layout.shared ? -1 : static_cast<int>((i - layout.shared) / layout.own);
  const Eigen::Index at = block < 0 ? i : i - layout.first_index(block);
  // Zero its gradient and columns, and append a unit row.
  slopes.gradient[i] = 0;
  for (ArrowRows& rows : slopes.rows) {
    if (block < 0) rows.shared.col(at).setZero();
    if (block >= 0 && rows.block == block) rows.own.col(at).setZero();
  }
  ArrowRows unit{block, Eigen::MatrixXd::Zero(1, layout.shared),
                 Eigen::MatrixXd::Zero(1, block < 0 ? 0 : layout.own)};
  (block < 0 ? unit.shared : unit.own)(0, at) = 1;
  slopes.rows.push_back(std::move(unit));
}

CostDerivatives cost_derivatives(const LeastSquares& problem, const Eigen::VectorXd& z) {
  std::optional<CostDerivatives> slopes = exact_derivatives(problem, z);
  require(slopes.has_value(), "residuals have no Jacobian");
  return std::move(*slopes);
}

Solution solve(const LeastSquares& problem, const Eigen::VectorXd& start,
               const SolveOptions& options) {
  // Check the problem, and project the start onto the bounds.
  check_shapes(problem, start);
  require(options.tolerance > 0 && std::isfinite(options.tolerance),
          "tolerance must be > 0, got {}", options.tolerance);
  const Eigen::VectorXd inside = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  check_values(problem, inside, options.method);
  // Solve and certify.
  const auto begin = std::chrono::steady_clock::now();
  Solution solution = solve_by_method(problem, inside, options);
  certify(problem, options, solution);
  if (solution.status == Status::kStalled && !solution.failed &&
      options.method == LeastSquaresMethod::kCeres)
    restart_ceres(problem, options, solution);
  refute_if_infeasible(problem, options.method, solution);
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return solution;
}

LeastSquaresMethod least_squares_method(const std::string& name) {
  return value_in(kLeastSquaresMethodNames, name, "fit method");
}

std::string name_of(LeastSquaresMethod method) { return name_in(kLeastSquaresMethodNames, method); }

std::string convergence_word(const Solution& solution) {
  if (solution.failed) return "failed";
  constexpr std::array kWords{EnumName{Status::kSolved, "converged"},
                              EnumName{Status::kLimit, "limit reached"},
                              EnumName{Status::kStopped, "stopped"}};
  const std::string word = name_in(kWords, solution.status);
  return word.empty() ? "not stationary" : word;
}

}  // namespace thenar
