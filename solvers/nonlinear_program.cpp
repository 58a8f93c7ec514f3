#include "solvers/nonlinear_program.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>

#define HAVE_CSTDDEF  // Ipopt 3.11 asks for it and leaves its own configuration out
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>

#include "base/error.h"
#include "solvers/kkt_residual.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;
using ConstMap = Eigen::Map<const VectorXd>;
using Map = Eigen::Map<VectorXd>;

/// Adapter of a program to Ipopt; every matrix is passed as dense.
class DenseTnlp : public Ipopt::TNLP {
 public:
  DenseTnlp(const NonlinearProgram& program, const VectorXd& x0)
      : program_(program),
        n_(x0.size()),
        rows_(program.row_lower.size()),
        x_(x0),
        row_prices_(VectorXd::Zero(rows_)),
        bound_prices_(VectorXd::Zero(n_)) {}

  [[nodiscard]] const VectorXd& x() const { return x_; }
  [[nodiscard]] double objective() const { return objective_; }
  [[nodiscard]] const VectorXd& row_prices() const { return row_prices_; }
  [[nodiscard]] const VectorXd& bound_prices() const { return bound_prices_; }
  [[nodiscard]] std::exception_ptr thrown() const { return thrown_; }

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = static_cast<Index>(n_);
    m = static_cast<Index>(rows_);
    nnz_jac_g = n * m;
    nnz_h_lag = program_.hessian ? n * (n + 1) / 2 : 0;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* x_l, Number* x_u, Index, Number* g_l, Number* g_u) override {
    const auto finite = [](double bound) {
      return std::clamp(bound, -kIpoptInfinity, kIpoptInfinity);
    };
    Map(x_l, n_) = program_.lower.unaryExpr(finite);
    Map(x_u, n_) = program_.upper.unaryExpr(finite);
    Map(g_l, rows_) = program_.row_lower.unaryExpr(finite);
    Map(g_u, rows_) = program_.row_upper.unaryExpr(finite);
    return true;
  }

  // NOLINTNEXTLINE(readability-function-size): the signature is Ipopt's
  bool get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    Map(x, n_) = x_;
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& value) override {
    return guarded([&] { value = program_.objective(ConstMap(x, n_)); });
  }

  bool eval_grad_f(Index, const Number* x, bool, Number* gradient) override {
    return guarded([&] { Map(gradient, n_) = program_.gradient(ConstMap(x, n_)); });
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    if (rows_ == 0) return true;
    return guarded([&] { Map(g, rows_) = program_.constraints(ConstMap(x, n_)); });
  }

  // NOLINTNEXTLINE(readability-function-size): the signature is Ipopt's
  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* row, Index* column,
                  Number* values) override {
    if (rows_ == 0) return true;
    if (values == nullptr) {
      for (Index k = 0; k < rows_ * n_; ++k) {
        row[k] = k % static_cast<Index>(rows_);
        column[k] = k / static_cast<Index>(rows_);
      }
      return true;
    }
    return guarded([&] {
      Eigen::Map<Eigen::MatrixXd>(values, rows_, n_) = program_.jacobian(ConstMap(x, n_));
    });
  }

  // NOLINTNEXTLINE(readability-function-size): the signature is Ipopt's
  bool eval_h(Index, const Number* x, bool, Number factor, Index, const Number* lambda, bool, Index,
              Index* row, Index* column, Number* values) override {
    if (!program_.hessian) return false;
    if (values == nullptr) {
      for_each_lower([&](Index k, Index i, Index j) {
        row[k] = i;
        column[k] = j;
      });
      return true;
    }
    return guarded([&] {
      const Eigen::MatrixXd H = program_.hessian(ConstMap(x, n_), factor, ConstMap(lambda, rows_));
      for_each_lower([&](Index k, Index i, Index j) { values[k] = H(i, j); });
    });
  }

  /// Ends the search after an exception; otherwise Ipopt would try ever shorter steps for minutes.
  // NOLINTNEXTLINE(readability-function-size): the signature is Ipopt's
  bool intermediate_callback(Ipopt::AlgorithmMode, Index, Number, Number, Number, Number, Number,
                             Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return !thrown_;
  }

  // NOLINTNEXTLINE(readability-function-size): the signature is Ipopt's
  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number* at_lower,
                         const Number* at_upper, Index, const Number*, const Number* lambda,
                         Number value, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    x_ = ConstMap(x, n_);
    bound_prices_ = ConstMap(at_upper, n_) - ConstMap(at_lower, n_);
    if (rows_ > 0) row_prices_ = ConstMap(lambda, rows_);
    objective_ = value;
  }

 private:
  static constexpr double kIpoptInfinity = 1e20;  // Ipopt's representation of "no bound"

  /// Stores an exception for solve_ipopt(), which rethrows it: none may propagate through Ipopt.
  template <typename Work>
  bool guarded(const Work& work) {
    if (thrown_) return false;
    try {
      work();
      return true;
    } catch (...) {
      if (!thrown_) thrown_ = std::current_exception();
      return false;
    }
  }

  template <typename Visit>
  void for_each_lower(const Visit& visit) const {
    Index k = 0;
    for (Index i = 0; i < n_; ++i)
      for (Index j = 0; j <= i; ++j) visit(k++, i, j);
  }

  const NonlinearProgram& program_;
  Eigen::Index n_, rows_;
  VectorXd x_, row_prices_, bound_prices_;
  double objective_ = std::numeric_limits<double>::quiet_NaN();
  std::exception_ptr thrown_;
};

void check(const NonlinearProgram& program, const VectorXd& x0) {
  const Eigen::Index n = x0.size(), rows = program.row_lower.size();
  require(program.lower.size() == n && program.upper.size() == n,
          "x0 has {} variables, its bounds {} and {}", n, program.lower.size(),
          program.upper.size());
  require(program.row_upper.size() == rows, "{} lower but {} upper constraint bounds", rows,
          program.row_upper.size());
  require(x0.allFinite(), "x0 must be finite");
  require(program.objective && program.gradient, "the program needs an objective and its gradient");
  require(rows == 0 || (program.constraints && program.jacobian),
          "{} constraints are bounded but no function computes them", rows);
}

/// Meaning of a return code of Ipopt.
struct IpoptEnding {
  Ipopt::ApplicationReturnStatus ipopt_status;
  Status status;
  const char* message;
};
constexpr IpoptEnding kIpoptEndings[] = {
    {Ipopt::Solve_Succeeded, Status::kSolved, "solved"},
    {Ipopt::Feasible_Point_Found, Status::kSolved, "feasible point found"},
    {Ipopt::Solved_To_Acceptable_Level, Status::kSolved, "solved to the acceptable level"},
    {Ipopt::Infeasible_Problem_Detected, Status::kInfeasible,
     "converged to a point of local infeasibility"},
    {Ipopt::Diverging_Iterates, Status::kUnbounded, "iterates diverge"},
    {Ipopt::Maximum_Iterations_Exceeded, Status::kLimit, "iteration limit reached"},
    {Ipopt::Search_Direction_Becomes_Too_Small, Status::kStalled,
     "search direction becomes too small"},
    {Ipopt::Restoration_Failed, Status::kStalled, "restoration failed"},
    {Ipopt::Error_In_Step_Computation, Status::kStalled, "no step could be computed"},
    {Ipopt::Not_Enough_Degrees_Of_Freedom, Status::kStalled,
     "more equality constraints than variables"},
    {Ipopt::Invalid_Number_Detected, Status::kStalled, "a function value is not finite"}};

IpoptEnding ending_of(Ipopt::ApplicationReturnStatus status) {
  for (const IpoptEnding& ending : kIpoptEndings)
    if (ending.ipopt_status == status) return ending;
  return {status, Status::kStalled, "the solver gave up"};
}

/// Update rule of the barrier parameter.
enum class Barrier { kAdaptive, kMonotone };

void set_options(Ipopt::OptionsList& list, const NonlinearProgram& program,
                 const NonlinearOptions& options, Barrier barrier) {
  // Silent, with our tolerances.
  list.SetIntegerValue("print_level", 0);
  list.SetStringValue("sb", "yes");  // no banner
  list.SetNumericValue("tol", options.tolerance);
  list.SetNumericValue("constr_viol_tol", options.tolerance);
  list.SetNumericValue("dual_inf_tol", options.tolerance * 1e4);
  list.SetNumericValue("compl_inf_tol", options.tolerance);
  list.SetNumericValue("acceptable_tol", options.acceptable_tolerance);
  list.SetNumericValue("bound_relax_factor", 0.0);  // bounds are satisfied exactly
  list.SetStringValue("mu_strategy", barrier == Barrier::kAdaptive ? "adaptive" : "monotone");
  list.SetIntegerValue("max_iter", options.max_iterations);
  if (!program.hessian) list.SetStringValue("hessian_approximation", "limited-memory");
}

/// Result with the scale of its stationarity.
struct Run {
  NonlinearResult result;
  double slope = 0;  // gradient_scale() at the final point
};

/// Runs Ipopt once, and computes the KKT residuals at the final point.
Run run(const NonlinearProgram& program, const VectorXd& x0, const NonlinearOptions& options,
        Barrier barrier) {
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  set_options(*application->Options(), program, options, barrier);
  const Ipopt::SmartPtr<DenseTnlp> tnlp = new DenseTnlp(program, x0);
  Ipopt::ApplicationReturnStatus status = application->Initialize("");
  if (status == Ipopt::Solve_Succeeded) status = application->OptimizeTNLP(GetRawPtr(tnlp));
  if (tnlp->thrown()) std::rethrow_exception(tnlp->thrown());

  // Compute the KKT residuals at Ipopt's result.
  const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application->Statistics();
  const IpoptEnding outcome = ending_of(status);
  Run run{{outcome.status, outcome.message, tnlp->x(), tnlp->objective(), 0, KktResidual{}}, 0};
  NonlinearResult& result = run.result;
  if (IsValid(statistics)) result.iterations = statistics->IterationCount();
  if (!result.x.allFinite()) return run;
  result.kkt_residual = kkt_residual(program, result.x, tnlp->row_prices(), tnlp->bound_prices());
  run.slope = gradient_scale(program, result.x, tnlp->row_prices(), tnlp->bound_prices());
  return run;
}

/// Returns whether the KKT residuals support the status. NaN fails.
bool supports_status(const NonlinearProgram& program, const VectorXd& x0, const Run& run,
                     double certified) {
  const NonlinearResult& result = run.result;
  const KktResidual& at = result.kkt_residual;
  switch (result.status) {
    case Status::kSolved:
      return std::isfinite(run.slope) && at.violation <= certified &&
             at.stationarity <= certified * std::max(1.0, run.slope) &&
             at.complementarity <= certified * std::max(1.0, std::abs(result.objective));
    case Status::kInfeasible:
      return at.violation > certified;
    case Status::kUnbounded:
      return result.objective < program.objective(x0) &&
             at.violation <= certified * std::max(1.0, result.x.cwiseAbs().maxCoeff());
    default:
      return false;
  }
}

/// Returns the result with a message about its KKT residuals, and kStalled.
NonlinearResult refuted_result(NonlinearResult result) {
  if (is_undecided(result.status)) return result;
  const KktResidual& at = result.kkt_residual;
  result.message = fmt::format(
      "{}, but first-order conditions do not hold: violation {:.2g}, stationarity {:.2g}, "
      "complementarity {:.2g}",
      result.message, at.violation, at.stationarity, at.complementarity);
  result.status = Status::kStalled;
  return result;
}

}  // namespace

NonlinearResult solve_ipopt(const NonlinearProgram& program, const VectorXd& x0,
                            const NonlinearOptions& options) {
  check(program, x0);
  // Handle programs without variables.
  if (x0.size() == 0) {
    const KktResidual at{violation(program, x0), 0, 0};
    const bool feasible = at.violation <= options.kkt_tolerance;
    return {feasible ? Status::kSolved : Status::kInfeasible,
            "nothing to vary",
            x0,
            program.objective(x0),
            0,
            at};
  }

  // MUMPS, which Ipopt calls, has global state; see the header.
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);

  const double certified = std::max(options.kkt_tolerance, 10 * options.acceptable_tolerance);
  const Run first = run(program, x0, options, Barrier::kAdaptive);
  if (supports_status(program, x0, first, certified)) return first.result;
  if (first.result.status == Status::kLimit) return first.result;  // limit of the caller

  // Restart with the other barrier rule; iterations are added up.
  const VectorXd restart = first.result.x.allFinite() ? first.result.x : x0;
  Run second = run(program, restart, options, Barrier::kMonotone);
  second.result.iterations += first.result.iterations;
  if (supports_status(program, x0, second, certified)) return second.result;

  // Accept a point at which the conditions hold even if Ipopt gave up there.
  for (Run stalled : {second, first}) {
    if (!is_undecided(stalled.result.status)) continue;
    stalled.result.status = Status::kSolved;
    if (supports_status(program, x0, stalled, certified)) return stalled.result;
  }
  return refuted_result(first.result);
}

}  // namespace thenar
