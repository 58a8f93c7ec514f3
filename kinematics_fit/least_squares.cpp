#include "kinematics_fit/least_squares.h"

#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

struct MethodName {
  FitMethod method;
  const char* name;
};
constexpr std::array kMethods{
    MethodName{FitMethod::kCeres, "ceres"}, MethodName{FitMethod::kNloptLocal, "nlopt"},
    MethodName{FitMethod::kNloptGlobal, "nlopt-global"}, MethodName{FitMethod::kIpopt, "ipopt"}};

Solution dispatch(const LeastSquares& problem, const Eigen::VectorXd& start,
                  const SolveOptions& options) {
  switch (options.method) {
    case FitMethod::kCeres:
      return internal::solve_ceres(problem, start, options);
    case FitMethod::kIpopt:
      return internal::solve_ipopt_fit(problem, start, options);
    default:
      return internal::solve_nlopt(problem, start, options);
  }
}

/// A solver that knows no constraints at least says which its answer breaks.
void tell_broken_constraints(const LeastSquares& problem, Solution& solution) {
  if (!problem.constraints) return;
  constexpr double kSlack = 1e-9;  // of rounding in scaled constraints [1]
  const Eigen::VectorXd c = problem.constraints(solution.z).c;
  const auto broken = ((c.array() < problem.c_lower.array() - kSlack) ||
                       (c.array() > problem.c_upper.array() + kSlack))
                          .count();
  if (broken > 0)
    solution.message +=
        fmt::format("; breaks {} of {} constraints, which only ipopt honours", broken, c.size());
}

/// Coordinates whose bounds leave them room to move.
std::vector<int> find_free(const LeastSquares& problem) {
  constexpr double kRoom = 1e-12;  // less is rounding, in prior sds [1]
  std::vector<int> free;
  for (Eigen::Index i = 0; i < problem.lower.size(); ++i)
    if (problem.upper[i] - problem.lower[i] > kRoom || !std::isfinite(problem.lower[i]))
      free.push_back(static_cast<int>(i));
  return free;
}

/// The problem of the free coordinates, all others held where `at` has them.
LeastSquares reduce(const LeastSquares& problem, const std::vector<int>& free,
                    const Eigen::VectorXd& at) {
  const auto whole = [free, at](const Eigen::VectorXd& some) {
    Eigen::VectorXd z = at;
    z(free) = some;
    return z;
  };
  LeastSquares rest;
  rest.lower = problem.lower(free);
  rest.upper = problem.upper(free);
  rest.residuals = [&problem, free, whole](const Eigen::VectorXd& some, WithJacobian want) {
    Residuals out = problem.residuals(whole(some), want);
    if (want == WithJacobian::kYes) out.J = out.J(Eigen::all, free).eval();
    return out;
  };
  if (!problem.constraints) return rest;
  rest.c_lower = problem.c_lower;
  rest.c_upper = problem.c_upper;
  rest.constraints = [&problem, free, whole](const Eigen::VectorXd& some) {
    ConstraintValues out = problem.constraints(whole(some));
    out.C = out.C(Eigen::all, free).eval();
    return out;
  };
  return rest;
}

/// Where nothing can move, the start is the answer.
Solution stay(const LeastSquares& problem, const Eigen::VectorXd& start) {
  Solution solution;
  solution.z = start;
  solution.cost = 0.5 * problem.residuals(start, WithJacobian::kNo).r.squaredNorm();
  solution.status = SolveStatus::kConverged;
  solution.message = "bounds leave nothing to move";
  solution.evaluations = 1;
  return solution;
}

/// Solves for what bounds leave free: some solvers fail where a lower bound is the upper one.
Solution solve_free(const LeastSquares& problem, const Eigen::VectorXd& start,
                    const SolveOptions& options) {
  const std::vector<int> free = find_free(problem);
  if (free.empty()) return stay(problem, start);
  if (static_cast<Eigen::Index>(free.size()) == start.size())
    return dispatch(problem, start, options);
  Solution solution = dispatch(reduce(problem, free, start), start(free), options);
  Eigen::VectorXd z = start;
  z(free) = solution.z;
  solution.z = z;
  return solution;
}

}  // namespace

Solution solve(const LeastSquares& problem, const Eigen::VectorXd& start,
               const SolveOptions& options) {
  require(start.size() == problem.lower.size() && start.allFinite(),
          "start needs {} finite entries, got {}", problem.lower.size(), start.size());
  for (Eigen::Index i = 0; i < start.size(); ++i)
    require(problem.lower[i] <= problem.upper[i], "bounds {} .. {} of coordinate {} are crossed",
            problem.lower[i], problem.upper[i], i);
  require(options.tolerance > 0 && std::isfinite(options.tolerance),
          "tolerance must be > 0, got {}", options.tolerance);
  const Eigen::VectorXd inside = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  require(problem.residuals(inside, WithJacobian::kNo).r.allFinite(),
          "residuals at the start are not finite");
  const auto begin = std::chrono::steady_clock::now();
  Solution solution = solve_free(problem, inside, options);
  if (options.method != FitMethod::kIpopt) tell_broken_constraints(problem, solution);
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return solution;
}

FitMethod fit_method(const std::string& name) {
  for (const MethodName& known : kMethods)
    if (name == known.name) return known.method;
  throw InputError(
      fmt::format("no fit method '{}'; there are ceres, nlopt, nlopt-global, ipopt", name));
}

std::string name_of(FitMethod method) {
  for (const MethodName& known : kMethods)
    if (method == known.method) return known.name;
  return {};
}

std::string name_of(SolveStatus status) {
  constexpr std::array kNames{"converged", "limit reached", "stopped", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

}  // namespace thenar
