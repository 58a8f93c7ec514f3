#pragma once

/// Smooth constrained minimisation of small dense programs.

#include <functional>
#include <string>

#include <Eigen/Core>

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
};

enum class NonlinearStatus {
  kSolved,      // local optimum to `tolerance`
  kAcceptable,  // local optimum to `acceptable_tolerance`
  kInfeasible,  // converged to a point of locally least constraint violation
  kUnbounded,   // the objective falls without limit
  kStalled      // iteration limit, restoration failure or a non-finite function value
};

struct NonlinearResult {
  NonlinearStatus status;  // read this first
  std::string message;     // the solver's own word for it
  Eigen::VectorXd x;       // best point found (n)
  double objective;        // there
  int iterations;          // taken
};

/// Minimises from `x0` by the interior-point method of Ipopt; prints nothing, reads no file.
///
/// Calls are serialised in a process: the sparse solver below is not reentrant. An exception thrown
/// by a function of the program leaves this function unchanged.
///
/// @throws InputError if shapes disagree, a required function is empty, or x0 is not finite.
/// Source: [Wachter2006].
[[nodiscard]] NonlinearResult solve_ipopt(const NonlinearProgram& program,
                                          const Eigen::VectorXd& x0,
                                          const NonlinearOptions& options = {});

}  // namespace thenar
