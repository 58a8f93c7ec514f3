#include "kinematics_fit/least_squares.h"

#include <array>
#include <chrono>

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

}  // namespace

Solution solve(const LeastSquares& problem, const Eigen::VectorXd& start,
               const SolveOptions& options) {
  require(start.size() == problem.lower.size() && start.allFinite(),
          "start needs {} finite entries, got {}", problem.lower.size(), start.size());
  const Eigen::VectorXd inside = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  require(problem.residuals(inside, WithJacobian::kNo).r.allFinite(),
          "residuals at the start are not finite");
  const auto begin = std::chrono::steady_clock::now();
  Solution solution = dispatch(problem, inside, options);
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
