#include <algorithm>
#include <cmath>

#include <nlopt.hpp>

#include "solvers/least_squares.h"

namespace thenar::internal {
namespace {

// Replacement for an infinite bound of a standard normal coordinate [1]
constexpr double kMaxCoordinate = 8;

/// State of the C callback. It stores the best point, which NLopt discards after a stop.
struct Context {
  const LeastSquares& problem;
  const SolveOptions& options;
  nlopt::opt& optimiser;
  int limit;
  Solution& best;
};

/// Objective function for NLopt.
double evaluate_cost(const std::vector<double>& x, std::vector<double>& /*gradient*/, void* data) {
  auto& context = *static_cast<Context*>(data);
  // Evaluate the cost, and keep the best point.
  const Eigen::VectorXd z =
      Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  const double value = 0.5 * context.problem.residuals(z, WithJacobian::kNo).r.squaredNorm();
  Solution& best = context.best;
  if (++best.evaluations == 1 || value < best.cost) {
    best.cost = value;
    best.z = z;
  }
  // Report progress, and forward stop requests.
  if (best.evaluations % 100 == 0)
    context.options.progress(static_cast<double>(best.evaluations) / context.limit, "nlopt");
  if (context.options.progress.stop()) context.optimiser.force_stop();
  return std::isfinite(value) ? value : HUGE_VAL;
}

/// Clips bounds or a start to finite values.
std::vector<double> clip_to_finite(const Eigen::VectorXd& z) {
  const Eigen::VectorXd near = z.cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
  return {near.data(), near.data() + near.size()};
}

/// Returns initial steps of half a prior sd, or less if the bounds are close: the first simplex
/// must fit between them.
std::vector<double> initial_steps(const LeastSquares& problem) {
  const std::vector<double> lower = clip_to_finite(problem.lower),
                            upper = clip_to_finite(problem.upper);
  std::vector<double> steps;
  for (std::size_t i = 0; i < lower.size(); ++i)
    steps.push_back(std::min(0.5, (upper[i] - lower[i]) / 4));
  return steps;
}

/// Runs one algorithm from best.z, and updates best.
void run_algorithm(nlopt::algorithm algorithm, const LeastSquares& problem,
                   const SolveOptions& options, int limit, Solution& best) {
  // Set bounds, tolerances and initial steps.
  nlopt::opt optimiser(algorithm, static_cast<unsigned>(best.z.size()));
  Context context{problem, options, optimiser, limit, best};
  optimiser.set_min_objective(evaluate_cost, &context);
  optimiser.set_lower_bounds(clip_to_finite(problem.lower));
  optimiser.set_upper_bounds(clip_to_finite(problem.upper));
  optimiser.set_maxeval(limit);
  optimiser.set_ftol_rel(options.tolerance);
  if (algorithm == nlopt::LN_BOBYQA) optimiser.set_initial_step(initial_steps(problem));
  // Run, and translate the result.
  std::vector<double> x = clip_to_finite(best.z);
  double value = 0;
  best.failed = false;
  try {
    const nlopt::result result = optimiser.optimize(x, value);
    best.status = result == nlopt::MAXEVAL_REACHED ? Status::kLimit : Status::kSolved;
    best.message = nlopt_result_to_string(static_cast<nlopt_result>(result));
  } catch (const nlopt::forced_stop&) {
    best.status = Status::kStopped;
    best.message = "stopped";
  } catch (const nlopt::roundoff_limited&) {
    best.status = Status::kSolved;
    best.message = "limited by rounding";
  } catch (const std::exception& e) {
    best.status = Status::kStalled;
    best.failed = true;
    best.message = e.what();
  }
}

}  // namespace

Solution solve_nlopt(const LeastSquares& problem, const Eigen::VectorXd& start,
                     const SolveOptions& options) {
  // Limit the evaluations by the size of the problem.
  Solution best;
  best.z = start;
  const int n = static_cast<int>(start.size());
  const int limit = options.max_evaluations > 0 ? options.max_evaluations : 500 * (n + 10);
  nlopt::srand(options.seed);
  // Search globally if requested, then by BOBYQA from the best point.
  if (options.method == LeastSquaresMethod::kNloptGlobal)
    run_algorithm(nlopt::GN_CRS2_LM, problem, options, limit, best);
  if (best.status != Status::kStopped)
    run_algorithm(nlopt::LN_BOBYQA, problem, options, limit, best);
  return best;
}

}  // namespace thenar::internal
