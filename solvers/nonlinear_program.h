#pragma once

/// Smooth constrained minimisation of small dense programs.

#include <functional>
#include <string>

#include <Eigen/Core>

#include "base/numbers.h"
#include "solvers/status.h"

namespace thenar {

/// Problem:  minimise objective(x)  subject to  lower <= x <= upper,
/// row_lower <= constraints(x) <= row_upper.
///
/// Bounds may be infinite. Functions must be smooth within the bounds. If `hessian` is empty, it is
/// approximated from gradients by limited-memory BFGS.
struct NonlinearProgram {
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;

  Vector lower, upper;                                 // bounds of x             (n)
  Vector row_lower, row_upper;                         // bounds of constraints   (r)
  std::function<double(const Vector& x)> objective;    // minimised
  std::function<Vector(const Vector& x)> gradient;     // gradient of the objective (n)
  std::function<Vector(const Vector& x)> constraints;  // empty allowed if r = 0  (r)
  std::function<Matrix(const Vector& x)> jacobian;     // Jacobian of the constraints (r, n)
  std::function<Matrix(const Vector& x, double objective_factor, const Vector& multipliers)>
      hessian;  // factor * objective'' + sum multipliers_i constraints_i''         (n, n)
};

struct NonlinearOptions {
  double tolerance = 1e-10;            // scaled optimality error at which iterations stop [1]
  double acceptable_tolerance = 1e-7;  // scaled error accepted if progress ends early [1]
  int max_iterations = 500;            // maximum number of Newton steps
  double kkt_tolerance = 1e-6;         // largest KKT residual that counts as solved, at least [1]
};

/// Residuals of the first-order conditions at x, computed from the functions of the program.
struct KktResidual {
  double violation = kUnknown;     // largest violation of a bound or row, over max(1, |bound|)  [1]
  double stationarity = kUnknown;  // largest slope of the Lagrangian  [objective / x]
  double complementarity = kUnknown;  // sum of multiplier times distance to its bound  [objective]

  static constexpr double kUnknown = kNaN;
};

struct NonlinearResult {
  Status status = Status::kStalled;  // kSolved: a local optimum with the residuals `kkt_residual`;
                                     // kInfeasible: x is a local minimum of the constraint
                                     // violation; kUnbounded: the objective decreases without limit
                                     // along feasible points; kLimit: `max_iterations`; kStalled:
                                     // the conditions hold at no point that was found
  std::string message;       // message of the solver
  Eigen::VectorXd x;         // best point found (n)
  double objective = 0;      // objective at x
  int iterations = 0;        // Newton steps taken
  KktResidual kkt_residual;  // residuals at x, independent of the solver
};

/// Minimises from `x0` by the interior-point method of Ipopt; prints nothing, reads no file.
///
/// Calls are serialised within a process because the sparse solver is not reentrant. Exceptions
/// thrown by functions of the program propagate unchanged.
///
/// The solver's status is verified: kSolved requires that the violation, the stationarity over
/// max(1, steepest slope at x0 and at x) and the complementarity over max(1, |objective|) are at
/// most `kkt_tolerance`, or ten times the acceptable tolerance if that is larger. If the check
/// fails, a second run starts from the best point with the other barrier update rule; if this fails
/// too, the status is kStalled and the message states the residuals.
///
/// @throws InputError if shapes disagree, a required function is empty, or x0 is not finite.
/// Source: [Wachter2006].
[[nodiscard]] NonlinearResult solve_ipopt(const NonlinearProgram& program,
                                          const Eigen::VectorXd& x0,
                                          const NonlinearOptions& options = {});

}  // namespace thenar
