#include <algorithm>

#include "solvers/least_squares.h"
#include "solvers/nonlinear_program.h"

namespace thenar::internal {
namespace {

/// Exception that leaves the solver after a stop request; the best point has been stored.
struct StopRequested {};

/// Evaluator of residuals with a cache of the last point, because cost, gradient and Hessian are
/// requested at the same point.
class Evaluator {
 public:
  Evaluator(const LeastSquares& problem, const SolveOptions& options, Solution& best)
      : problem_(problem), options_(options), best_(best) {}

  const Residuals& evaluate(const Eigen::VectorXd& z) {
    // Return the cached values at the same point.
    if (z_.size() == z.size() && z_ == z) return last_;
    z_ = z;
    last_ = problem_.residuals(z, WithJacobian::kYes);
    ++best_.evaluations;
    keep_best();
    options_.progress(0, "ipopt");
    if (options_.progress.stop()) throw StopRequested();
    return last_;
  }

 private:
  /// Stores the feasible point with the lowest cost so far, for a search that is stopped.
  void keep_best() {
    // Accept a lower cost if the constraints hold.
    const double cost = 0.5 * last_.r.squaredNorm();
    if (!(best_.evaluations == 1 || cost < best_.cost)) return;
    if (problem_.constraints && best_.evaluations > 1) {
      const Eigen::VectorXd c = problem_.constraints(z_).c;
      if ((c.array() < problem_.c_lower.array() - kMaxViolation).any()) return;
      if ((c.array() > problem_.c_upper.array() + kMaxViolation).any()) return;
    }
    best_.cost = cost;
    best_.z = z_;
  }

  const LeastSquares& problem_;
  const SolveOptions& options_;
  Solution& best_;
  Eigen::VectorXd z_;
  Residuals last_;
};

/// Converts the least-squares problem to a nonlinear program.
NonlinearProgram program_of(const LeastSquares& problem, Evaluator& evaluator) {
  NonlinearProgram program;
  // Cost, bounds and constraints.
  program.lower = problem.lower;
  program.upper = problem.upper;
  program.row_lower = problem.c_lower;
  program.row_upper = problem.c_upper;
  program.objective = [&](const Eigen::VectorXd& z) {
    return 0.5 * evaluator.evaluate(z).r.squaredNorm();
  };
  program.gradient = [&](const Eigen::VectorXd& z) -> Eigen::VectorXd {
    const Residuals& current = evaluator.evaluate(z);
    return current.J.transpose() * current.r;
  };
  // Gauss-Newton Hessian: the curvature of residuals and constraints is neglected.
  program.hessian = [&](const Eigen::VectorXd& z, double factor, const Eigen::VectorXd&) {
    const Residuals& current = evaluator.evaluate(z);
    return Eigen::MatrixXd(factor * current.J.transpose() * current.J);
  };
  if (problem.constraints) {
    program.constraints = [&](const Eigen::VectorXd& z) { return problem.constraints(z).c; };
    program.jacobian = [&](const Eigen::VectorXd& z) { return problem.constraints(z).C; };
  }
  return program;
}

}  // namespace

Solution solve_ipopt_least_squares(const LeastSquares& problem, const Eigen::VectorXd& start,
                                   const SolveOptions& options) {
  Solution best;
  best.z = start;
  Evaluator evaluator(problem, options, best);
  NonlinearOptions settings;
  // In whitened coordinates, the scaled gradient at a minimum decreases with the change of the
  // cost.
  settings.tolerance = options.tolerance;
  settings.acceptable_tolerance = std::max(1e-7, 10 * options.tolerance);
  if (options.max_evaluations > 0) settings.max_iterations = options.max_evaluations;
  try {
    const NonlinearResult result =
        thenar::solve_ipopt(program_of(problem, evaluator), start, settings);
    best.z = result.x;
    best.status = result.status;
    best.failed = result.status == Status::kInfeasible || result.status == Status::kUnbounded;
    best.message = result.message;
  } catch (const StopRequested&) {
    best.status = Status::kStopped;
    best.message = "stopped";
  }
  best.cost = 0.5 * problem.residuals(best.z, WithJacobian::kNo).r.squaredNorm();
  return best;
}

}  // namespace thenar::internal
