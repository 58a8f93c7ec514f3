#include <ceres/ceres.h>

#include "kinematics_fit/least_squares.h"

namespace thenar::internal {
namespace {

/// All residuals as one block, with their exact Jacobian.
class Cost final : public ceres::CostFunction {
 public:
  Cost(const LeastSquares& problem, int rows, int& evaluations)
      : problem_(problem), evaluations_(evaluations) {
    set_num_residuals(rows);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.lower.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::VectorXd> z(parameters[0], problem_.lower.size());
    const bool want = jacobians != nullptr && jacobians[0] != nullptr;
    const Residuals out = problem_.residuals(z, want ? WithJacobian::kYes : WithJacobian::kNo);
    ++evaluations_;
    Eigen::Map<Eigen::VectorXd>(residuals, out.r.size()) = out.r;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    if (want) Eigen::Map<RowMajor>(jacobians[0], out.J.rows(), out.J.cols()) = out.J;
    return out.r.allFinite();  // a step into nonsense is shortened, not taken
  }

 private:
  const LeastSquares& problem_;
  int& evaluations_;
};

/// Reports every iteration and passes a stop request on.
class Listener final : public ceres::IterationCallback {
 public:
  Listener(const Progress& progress, int limit) : progress_(progress), limit_(limit) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    progress_(static_cast<double>(summary.iteration) / limit_, "ceres");
    return progress_.stop() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const Progress& progress_;
  int limit_;
};

SolveStatus status_of(const ceres::Solver::Summary& summary) {
  switch (summary.termination_type) {
    case ceres::CONVERGENCE:
      return SolveStatus::kConverged;
    case ceres::NO_CONVERGENCE:
      return SolveStatus::kLimit;
    case ceres::USER_SUCCESS:
      return SolveStatus::kStopped;
    default:
      return SolveStatus::kFailed;
  }
}

}  // namespace

Solution solve_ceres(const LeastSquares& problem, const Eigen::VectorXd& start,
                     const SolveOptions& options) {
  const int rows = static_cast<int>(problem.residuals(start, WithJacobian::kNo).r.size());
  Solution solution;
  solution.z = start;

  ceres::Problem ceres_problem;
  ceres_problem.AddResidualBlock(new Cost(problem, rows, solution.evaluations), nullptr,
                                 solution.z.data());
  for (int i = 0; i < static_cast<int>(start.size()); ++i) {
    if (std::isfinite(problem.lower[i]))
      ceres_problem.SetParameterLowerBound(solution.z.data(), i, problem.lower[i]);
    if (std::isfinite(problem.upper[i]))
      ceres_problem.SetParameterUpperBound(solution.z.data(), i, problem.upper[i]);
  }

  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  settings.max_num_iterations = options.max_evaluations > 0 ? options.max_evaluations : 500;
  settings.function_tolerance = options.tolerance;
  settings.parameter_tolerance = 1e-12;
  settings.gradient_tolerance = 1e-10;
  settings.logging_type = ceres::SILENT;
  Listener listener(options.progress, settings.max_num_iterations);
  settings.callbacks.push_back(&listener);
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &ceres_problem, &summary);

  solution.cost = summary.final_cost;
  solution.status = status_of(summary);
  solution.message = summary.message;
  return solution;
}

}  // namespace thenar::internal
