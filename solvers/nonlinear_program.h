#pragma once

/// Smooth constrained minimisation of small dense programs.

#include <functional>
#include <string>

#include <Eigen/Core>

#include "base/numbers.h"
#include "solvers/status.h"

namespace thenar {

/// minimise objective(x)  subject to  lower <= x <= upper,  row_lower <= constraints(x) <=
/// row_upper.
///
/// Bounds may be infinite. Functions must be smooth where the bounds hold; `hessian` may be left
/// empty, it is then built up from gradients (limited-memory BFGS).
struct NonlinearProgram {
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;

  Vector lower, upper;                                 // bounds of x             (n)
  Vector row_lower, row_upper;                         // bounds of constraints   (r)
  std::function<double(const Vector& x)> objective;    // minimised
  std::function<Vector(const Vector& x)> gradient;     // of the objective        (n)
  std::function<Vector(const Vector& x)> constraints;  // empty allowed if r = 0  (r)
  std::function<Matrix(const Vector& x)> jacobian;     // of the constraints      (r, n)
  std::function<Matrix(const Vector& x, double objective_factor, const Vector& multipliers)>
      hessian;  // factor * objective'' + sum multipliers_i constraints_i''         (n, n)
};

struct NonlinearOptions {
  double tolerance = 1e-10;            // scaled optimality error that counts as solved     [1]
  double acceptable_tolerance = 1e-7;  // the same, if progress ends before `tolerance`     [1]
  int max_iterations = 500;            // Newton steps                                      [1]
  double certified = 1e-6;  // what our own check of the conditions asks for, at least      [1]
};

/// Residuals of the first-order conditions at x, computed from the functions of the program.
struct KktResidual {
  double violation = kUnknown;        // of a bound or row, over max(1, |bound|)      [1]
  double stationarity = kUnknown;     // largest slope of the Lagrangian  [objective / x]
  double complementarity = kUnknown;  // sum of price times distance to its bound [objective]

  static constexpr double kUnknown = kNaN;
};

struct NonlinearResult {
  Status status;  // kSolved: a local optimum, whose conditions are those of `kkt_residual`;
                  // kInfeasible: x violates the constraints, locally least; kUnbounded: the
                  // objective falls along feasible points; kLimit: `max_iterations`; kStalled:
                  // the conditions do not hold at any point that was found
  std::string message;       // the solver's own word for it
  Eigen::VectorXd x;         // best point found (n)
  double objective;          // there
  int iterations;            // taken
  KktResidual kkt_residual;  // there, by arithmetic of our own
};

/// Minimises from `x0` by the interior-point method of Ipopt; prints nothing, reads no file.
///
/// Calls are serialised in a process: the sparse solver below is not reentrant. An exception thrown
/// by a function of the program leaves this function unchanged.
///
/// The solver's word is not believed: kSolved needs a violation, a stationarity over max(1,
/// steepest slope at x0 and at x) and a complementarity over max(1, |objective|) of at most
/// `certified`, or ten times the acceptable tolerance if that is more. If they fail, a second run
/// starts from the best point with the other rule for its barrier; if these fail too, the status is
/// kStalled and the message says what is left.
///
/// @throws InputError if shapes disagree, a required function is empty, or x0 is not finite.
/// Source: [Wachter2006].
[[nodiscard]] NonlinearResult solve_ipopt(const NonlinearProgram& program,
                                          const Eigen::VectorXd& x0,
                                          const NonlinearOptions& options = {});

}  // namespace thenar
