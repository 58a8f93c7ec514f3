#pragma once

/// Nonlinear least squares  min 1/2 |r(z)|^2  within bounds, by one of several solvers, with a
/// certificate.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/progress.h"
#include "solvers/arrow_factor.h"
#include "solvers/status.h"

namespace thenar {

/// Request for a Jacobian.
enum class WithJacobian { kNo, kYes };

/// Residuals r and, if requested, their Jacobian J = dr/dz.
struct Residuals {
  Eigen::VectorXd r;  // (rows)
  Eigen::MatrixXd J;  // Jacobian (rows, n); empty if not requested or not available
};

/// Values of smooth constraints  lower <= c(z) <= upper,  with C = dc/dz.
struct ConstraintValues {
  Eigen::VectorXd c;  // (constraints)
  Eigen::MatrixXd C;  // (constraints, n)
};

/// Residuals that depend on the shared coordinates of a layout and on those of one block.
struct ResidualPart {
  int block = -1;  // index of the block; -1: only shared coordinates
  /// Returns r and J; columns of J are the shared coordinates, then those of the block. Reads no
  /// other entry of z.
  std::function<Residuals(const Eigen::VectorXd& z, WithJacobian want)> residuals;
};

/// Least-squares problem. A solver calls its functions from one thread.
struct LeastSquares {
  Eigen::VectorXd lower, upper;  // bounds, possibly infinite (n)
  std::function<Residuals(const Eigen::VectorXd& z, WithJacobian want)> residuals;  // required
  Eigen::VectorXd c_lower, c_upper;  // bounds of the constraints; empty: none (constraints)
  std::function<ConstraintValues(const Eigen::VectorXd& z)> constraints;  // empty: none
  ArrowLayout layout;               // layout of the coordinates in `parts`; unused without them
  std::vector<ResidualPart> parts;  // residuals by blocks, or empty; used instead of `residuals` by
                                    // kCeres and by the certificate
};

/// Cost, its gradient, and the Jacobian of the residuals at z, by blocks if the problem has them.
struct CostDerivatives {
  double cost = 0;              // 1/2 |r|^2 [1]
  Eigen::VectorXd gradient;     // J'r (n)
  ArrowLayout layout;           // layout of the coordinates
  std::vector<ArrowRows> rows;  // rows of J
};

/// Fixes a coordinate: sets its gradient and column to zero, and adds a unit row to keep full rank.
void fix_coordinate(CostDerivatives& slopes, Eigen::Index i);

/// Computes cost, gradient and Jacobian at z.
/// @throws InputError if the residuals have no Jacobian.
[[nodiscard]] CostDerivatives cost_derivatives(const LeastSquares& problem,
                                               const Eigen::VectorXd& z);

/// Solver of a least-squares problem. All minimise the same function; only Ipopt enforces
/// `constraints`. The others ignore them: if their minimum violates one, the status is not kSolved.
enum class LeastSquaresMethod {
  kCeres,        // structured secant steps and Levenberg-Marquardt; needs the Jacobian
  kNloptLocal,   // BOBYQA: local, derivative-free
  kNloptGlobal,  // controlled random search, polished by BOBYQA: derivative-free
  kIpopt         // interior point, Gauss-Newton Hessian; needs the Jacobian; enforces constraints
};
inline constexpr std::array kLeastSquaresMethodNames{
    EnumName{LeastSquaresMethod::kCeres, "ceres"},
    EnumName{LeastSquaresMethod::kNloptLocal, "nlopt"},
    EnumName{LeastSquaresMethod::kNloptGlobal, "nlopt-global"},
    EnumName{LeastSquaresMethod::kIpopt, "ipopt"}};

struct SolveOptions {
  LeastSquaresMethod method = LeastSquaresMethod::kCeres;
  int max_evaluations = 0;  // maximum number of evaluations of the residuals; 0: default of the
                            // method. With kCeres, a limit disables the secant steps
  double tolerance = 1e-8;  // relative change of the cost at which iterations stop [1]
  unsigned seed = 1;        // random seed of the global search
  Progress progress;
};

/// Best point found, whether or not the search converged.
struct [[nodiscard]] Solution {
  Eigen::VectorXd z;  // (n)
  double cost = 0;    // 1/2 |r|^2 [1]
  // kSolved: certified by `newton_step`, and no constraint is violated; kStalled: one of these does
  // not hold, or the solver failed
  Status status = Status::kStalled;
  bool failed = false;  // the solver ended with an error, or found the bounds infeasible
  std::string message;  // message of the solver, followed by failed checks and violated constraints
  int evaluations = 0;  // number of evaluations of the residuals
  double seconds = 0;   // wall time [s]
  // Length of the Gauss-Newton step along the directions left free by bounds and active constraints
  // at z, in sds of exp(-cost) [1]; NaN: the residuals near z are not finite
  double newton_step = 0;
  int kink_sides = 1;  // number of sides of a kink of the residuals within 1e-3 sds of z, whose
                       // averaged gradient gives `newton_step`; 1: no kink [1]

  /// Returns whether the point is certified and the solver did not fail.
  [[nodiscard]] bool converged() const { return status == Status::kSolved && !failed; }
};

/// Minimises from `start` (n), which is projected onto the bounds first. A coordinate with equal
/// bounds is held fixed.
///
/// The convergence claimed by a solver is verified: with F the coordinates that no bound holds
/// against the gradient g, the remaining step is  sqrt(g_F' (J_F'J_F)^-1 g_F), and must not exceed
/// the larger of 0.01 and sqrt(20 tolerance cost). J is the Jacobian of the residuals or, if they
/// have none, computed by central differences within the bounds. If the step is longer, the status
/// is kStalled; kCeres first restarts once from there with a tolerance of 1e-15. With kCeres and
/// without constraints, the step may also be that of the averaged gradient at a kink
/// (`kink_sides`). Constraints are satisfied to 1e-6; a point that violates one is kStalled with
/// every method.
/// @throws InputError if shapes disagree, bounds are crossed, start or the residuals there are not
/// finite, kCeres or kIpopt get no Jacobian, or the tolerance is not positive and finite.
Solution solve(const LeastSquares& problem, const Eigen::VectorXd& start,
               const SolveOptions& options = {});

/// Returns the method named "ceres", "nlopt", "nlopt-global" or "ipopt". @throws InputError
/// otherwise.
[[nodiscard]] LeastSquaresMethod least_squares_method(const std::string& name);
[[nodiscard]] std::string name_of(LeastSquaresMethod method);

/// Returns the word that fit files and tables use for the outcome of a search: "converged",
/// "limit reached", "stopped", "failed" or "not stationary".
[[nodiscard]] std::string convergence_word(const Solution& solution);

namespace internal {
/// Distance of two bounds up to which they are equal to rounding [prior sds].
inline constexpr double kMinWidth = 1e-12;
/// Largest violation of scaled constraints at a feasible point [1].
inline constexpr double kMaxViolation = 1e-6;

Solution solve_ceres(const LeastSquares&, const Eigen::VectorXd& start, const SolveOptions&);
Solution solve_nlopt(const LeastSquares&, const Eigen::VectorXd& start, const SolveOptions&);
Solution solve_ipopt_least_squares(const LeastSquares&, const Eigen::VectorXd& start,
                                   const SolveOptions&);

/// Takes Newton steps until the predicted decrease is below the tolerance. Gauss-Newton's J'J
/// neglects the curvature of large residuals; secant updates estimate it from the changes of the
/// Jacobian between steps. The update is done part by part, so that many blocks need no more steps
/// than one. The cost never rises beyond rounding.
/// @param max_evaluations  maximum number of evaluations [1]
/// @param solution         initial point on input, best point found on output
/// @return whether it converged or was stopped; if not, the status is unchanged
/// Source: [DennisGayWelsch1981], structured secants; [Griewank1982], part by part.
bool search_by_secants(const LeastSquares&, const SolveOptions&, int max_evaluations,
                       Solution& solution);

/// Searches for a minimum on a kink, where the residuals' derivatives jump and no gradient
/// vanishes. With g_i the gradients found within 1e-3 sds of z, the remaining step is that of the
/// convex combination of minimum norm,
///   min over w >= 0, sum w = 1 of  |sum w_i g_i|,  in the norm  sqrt(g' (J'J)^-1 g).
/// If a step along it does not lower the cost, the gradient beyond the kink is added to the set.
/// @param solution  initial point on input, best point found on output
/// @return whether the remaining step is below 3e-3 sds, or the search was stopped; if not, the
/// status is unchanged
/// Source: [Goldstein1977] for the set of gradients, [Wolfe1975] for the search.
bool search_at_kink(const LeastSquares&, const SolveOptions&, Solution& solution);

/// Residuals by parts; a dense problem is a single part that depends on all coordinates.
struct ResidualBlocks {
  ArrowLayout layout;
  std::vector<ResidualPart> parts;
};
[[nodiscard]] ResidualBlocks blocks_of(const LeastSquares&);

/// Returns whether coordinate i lies on a bound that the gradient pushes it against.
[[nodiscard]] bool is_held(const LeastSquares&, const Eigen::VectorXd& z, double gradient,
                           Eigen::Index i);

/// Returns, for each coordinate, whether no bound holds it against the gradient (n).
[[nodiscard]] std::vector<bool> free_coordinates(const LeastSquares&, const Eigen::VectorXd& z,
                                                 const Eigen::VectorXd& gradient);
}  // namespace internal

}  // namespace thenar
