#include <vector>

#include <ceres/ceres.h>

#include "solvers/least_squares.h"

namespace thenar::internal {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Residuals of one part, with their Jacobian by the shared coordinates and by one block.
class PartCost final : public ceres::CostFunction {
 public:
  PartCost(const ResidualPart& part, const ArrowLayout& layout, int rows, int& evaluations)
      : part_(part), layout_(layout), evaluations_(evaluations) {
    set_num_residuals(rows);
    mutable_parameter_block_sizes()->push_back(layout.shared);
    if (part.block >= 0) mutable_parameter_block_sizes()->push_back(layout.own);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    // Gather the entries that the part reads.
    const bool own = part_.block >= 0;
    Eigen::VectorXd z = Eigen::VectorXd::Zero(layout_.size());
    z.head(layout_.shared) = Eigen::Map<const Eigen::VectorXd>(parameters[0], layout_.shared);
    if (own)
      z.segment(layout_.first_index(part_.block), layout_.own) =
          Eigen::Map<const Eigen::VectorXd>(parameters[1], layout_.own);
    const Residuals out =
        part_.residuals(z, jacobians == nullptr ? WithJacobian::kNo : WithJacobian::kYes);
    ++evaluations_;
    // Return the residuals and, if requested, both parts of the Jacobian.
    Eigen::Map<Eigen::VectorXd>(residuals, out.r.size()) = out.r;
    if (jacobians != nullptr && jacobians[0] != nullptr)
      Eigen::Map<RowMajor>(jacobians[0], out.J.rows(), layout_.shared) =
          out.J.leftCols(layout_.shared);
    if (jacobians != nullptr && own && jacobians[1] != nullptr)
      Eigen::Map<RowMajor>(jacobians[1], out.J.rows(), layout_.own) = out.J.rightCols(layout_.own);
    return out.r.allFinite();  // Ceres shortens steps to points that are not finite
  }

 private:
  const ResidualPart& part_;
  const ArrowLayout& layout_;
  int& evaluations_;
};

/// Reports every iteration, and forwards stop requests.
class ProgressCallback final : public ceres::IterationCallback {
 public:
  ProgressCallback(const Progress& progress, int limit) : progress_(progress), limit_(limit) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    progress_(static_cast<double>(summary.iteration) / limit_, "ceres");
    return progress_.stop() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const Progress& progress_;
  int limit_;
};

Status status_of(const ceres::Solver::Summary& summary) {
  if (summary.termination_type == ceres::CONVERGENCE) return Status::kSolved;
  if (summary.termination_type == ceres::NO_CONVERGENCE) return Status::kLimit;
  return summary.termination_type == ceres::USER_SUCCESS ? Status::kStopped : Status::kStalled;
}

/// Sets the bounds of one parameter block of Ceres; coordinates with equal bounds are fixed.
void set_bounds(const LeastSquares& problem, int first, int count, double* z,
                ceres::Problem& ceres) {
  std::vector<int> held;
  // Set the bounds, and collect fixed coordinates.
  for (int i = 0; i < count; ++i) {
    const double lower = problem.lower[first + i], upper = problem.upper[first + i];
    if (upper - lower <= kMinWidth) {
      held.push_back(i);
      continue;
    }
    if (std::isfinite(lower)) ceres.SetParameterLowerBound(z, i, lower);
    if (std::isfinite(upper)) ceres.SetParameterUpperBound(z, i, upper);
  }
  if (static_cast<int>(held.size()) == count)
    ceres.SetParameterBlockConstant(z);
  else if (!held.empty())
    ceres.SetManifold(z, new ceres::SubsetManifold(count, held));
}

}  // namespace

Solution solve_ceres(const LeastSquares& problem, const Eigen::VectorXd& start,
                     const SolveOptions& options) {
  const ResidualBlocks blocks = blocks_of(problem);
  const ArrowLayout& layout = blocks.layout;
  Solution solution;
  solution.z = start;

  // Add each part of the residuals with the parameter blocks that it reads.
  ceres::Problem ceres_problem;
  double* z = solution.z.data();
  int calls = 0;
  for (const ResidualPart& part : blocks.parts) {
    const auto rows = static_cast<int>(part.residuals(start, WithJacobian::kNo).r.size());
    std::vector<double*> block_parameters{z};
    if (part.block >= 0) block_parameters.push_back(z + layout.first_index(part.block));
    ceres_problem.AddResidualBlock(new PartCost(part, layout, rows, calls), nullptr,
                                   block_parameters);
  }
  set_bounds(problem, 0, layout.shared, z, ceres_problem);
  for (int b = 0; b < layout.blocks; ++b)
    set_bounds(problem, layout.first_index(b), layout.own, z + layout.first_index(b),
               ceres_problem);

  // Eliminate blocks by Schur complements if there are any.
  ceres::Solver::Options settings;
  settings.linear_solver_type =
      layout.blocks > 0 ? ceres::DENSE_SCHUR : ceres::DENSE_NORMAL_CHOLESKY;
  if (layout.blocks > 0) {
    auto* order = new ceres::ParameterBlockOrdering;
    order->AddElementToGroup(z, 1);
    for (int b = 0; b < layout.blocks; ++b) order->AddElementToGroup(z + layout.first_index(b), 0);
    settings.linear_solver_ordering.reset(order);
  }
  settings.max_num_iterations = options.max_evaluations > 0 ? options.max_evaluations : 500;
  settings.function_tolerance = options.tolerance;
  settings.parameter_tolerance = 1e-12;
  settings.gradient_tolerance = 1e-10;
  settings.logging_type = ceres::SILENT;
  ProgressCallback callback(options.progress, settings.max_num_iterations);
  settings.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &ceres_problem, &summary);

  solution.evaluations = calls / static_cast<int>(blocks.parts.size());
  solution.cost = summary.final_cost;
  solution.status = status_of(summary);
  solution.failed = solution.status == Status::kStalled;
  solution.message = summary.message;
  return solution;
}

}  // namespace thenar::internal
