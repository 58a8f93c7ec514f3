#pragma once

/// min 1/2 |r(z)|^2 within bounds, by one of several solvers, with a certificate.

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

enum class WithJacobian { kNo, kYes };

/// Residuals r and, when asked for, J = dr/dz.
struct Residuals {
  Eigen::VectorXd r;  // (rows)
  Eigen::MatrixXd J;  // (rows, n); empty if not asked for, or if the residuals have no Jacobian
};

/// Smooth constraints  lower <= c(z) <= upper, with C = dc/dz.
struct ConstraintValues {
  Eigen::VectorXd c;  // (constraints)
  Eigen::MatrixXd C;  // (constraints, n)
};

/// Residuals that depend on the shared coordinates of a layout and on those of one block.
struct ResidualPart {
  int block = -1;  // -1: shared coordinates alone
  /// r, and J by the shared coordinates, then by those of the block; reads no other entry of z.
  std::function<Residuals(const Eigen::VectorXd& z, WithJacobian want)> residuals;
};

/// A least-squares problem. A solver calls its functions from one thread.
struct LeastSquares {
  Eigen::VectorXd lower, upper;  // bounds, may be infinite (n)
  std::function<Residuals(const Eigen::VectorXd& z, WithJacobian want)> residuals;  // required
  Eigen::VectorXd c_lower, c_upper;  // bounds of the constraints; empty: none (constraints)
  std::function<ConstraintValues(const Eigen::VectorXd& z)> constraints;  // empty: none
  ArrowLayout layout;               // of `parts`; unused without them
  std::vector<ResidualPart> parts;  // the same residuals by blocks, or empty; kCeres and
                                    // the certificate take them in place of `residuals`
};

/// Cost, its gradient, and the Jacobian of the residuals at z, in blocks where the problem has
/// them.
struct CostDerivatives {
  double cost = 0;              // 1/2 |r|^2 [1]
  Eigen::VectorXd gradient;     // J'r (n)
  ArrowLayout layout;           // of the rows
  std::vector<ArrowRows> rows;  // J
};

/// Fixes a coordinate: its gradient and column are zero, and a unit row keeps the rank.
void fix_coordinate(CostDerivatives& slopes, Eigen::Index i);

/// @throws InputError if the residuals have no Jacobian.
[[nodiscard]] CostDerivatives cost_derivatives(const LeastSquares& problem,
                                               const Eigen::VectorXd& z);

/// Solver of a least-squares problem. All minimise the same function; only Ipopt keeps
/// `constraints`. The others search without them: where their minimum breaks one, the status is not
/// kSolved.
enum class LeastSquaresMethod {
  kCeres,        // secants, Levenberg-Marquardt; needs the Jacobian
  kNloptLocal,   // BOBYQA: local, without derivatives
  kNloptGlobal,  // controlled random search, polished by BOBYQA: without derivatives
  kIpopt         // interior point, Gauss-Newton Hessian; needs the Jacobian; keeps constraints
};
inline constexpr std::array kLeastSquaresMethodNames{
    EnumName{LeastSquaresMethod::kCeres, "ceres"},
    EnumName{LeastSquaresMethod::kNloptLocal, "nlopt"},
    EnumName{LeastSquaresMethod::kNloptGlobal, "nlopt-global"},
    EnumName{LeastSquaresMethod::kIpopt, "ipopt"}};

struct SolveOptions {
  LeastSquaresMethod method = LeastSquaresMethod::kCeres;
  int max_evaluations = 0;  // of the residuals; 0: the method's own limit; with kCeres, who counts
                            // them gets Levenberg-Marquardt's steps alone
  double tolerance = 1e-8;  // relative change of the cost at which to stop [1]
  unsigned seed = 1;        // of the global search
  Progress progress;
};

/// The best point found, whatever happened.
struct [[nodiscard]] Solution {
  Eigen::VectorXd z;                 // (n)
  double cost = 0;                   // 1/2 |r|^2 [1]
  Status status = Status::kStalled;  // kSolved: certified by `newton_step`, and no constraint is
                                     // broken; kStalled: one of both is not so, or the solver
                                     // failed
  bool failed = false;     // the solver broke off with an error, or found the bounds infeasible
  std::string message;     // of the solver; then what refutes it, and constraints that are broken
  int evaluations = 0;     // of the residuals
  double seconds = 0;      // wall time [s]
  double newton_step = 0;  // length of the Gauss-Newton step that bounds and active constraints
                           // leave at z, in sds of exp(-cost) [1]; NaN: residuals next to z are
                           // not finite
  int sides = 1;           // of a kink of the residuals at z, whose mean slope `newton_step` is of,
                           // within 1e-3 sds of z; 1: no kink [1]

  /// Certified, and not broken off.
  [[nodiscard]] bool converged() const { return status == Status::kSolved && !failed; }
};

/// Minimises from `start` (n), which is first brought within the bounds; where a lower bound is the
/// upper one, the coordinate is held.
///
/// What a solver calls converged is certified: with F the coordinates that no bound holds against
/// the gradient g, the step left is  sqrt(g_F' (J_F'J_F)^-1 g_F), and must not exceed the larger of
/// 0.01 and sqrt(20 tolerance cost). J is that of the residuals; without one, it is taken by
/// central differences within the bounds. If the step is longer, the status is kStalled; with
/// kCeres, the search first goes on once from there, at a tolerance of 1e-15. With kCeres and no
/// constraints the step may also be that of the mean slope of a kink (`sides`).
/// Constraints are kept to 1e-6; a point that breaks one is kStalled with every method.
/// @throws InputError if shapes disagree, bounds are crossed, start is not finite, the residuals at
///         it are not, kCeres or kIpopt get no Jacobian, or the tolerance is not positive and
///         finite.
Solution solve(const LeastSquares& problem, const Eigen::VectorXd& start,
               const SolveOptions& options = {});

/// "ceres", "nlopt", "nlopt-global" or "ipopt". @throws InputError for another name.
[[nodiscard]] LeastSquaresMethod least_squares_method(const std::string& name);
[[nodiscard]] std::string name_of(LeastSquaresMethod method);

/// The word of fit files and tables for how a search ended: "converged", "limit reached",
/// "stopped", "failed" or "not stationary".
[[nodiscard]] std::string convergence_word(const Solution& solution);

namespace internal {
Solution solve_ceres(const LeastSquares&, const Eigen::VectorXd& start, const SolveOptions&);
Solution solve_nlopt(const LeastSquares&, const Eigen::VectorXd& start, const SolveOptions&);
Solution solve_ipopt_least_squares(const LeastSquares&, const Eigen::VectorXd& start,
                                   const SolveOptions&);

/// Newton steps towards the minimum, to where less is left to gain than the tolerance asks. J'J
/// alone leaves out the curvature of residuals that stay large; what is left out shows in how the
/// Jacobian changes from step to step, part by part, so that many blocks take no more steps than
/// one. The cost never rises beyond rounding.
/// @param most      evaluations at most [1]
/// @param solution  where it begins; the best point found
/// @return whether it got there or was stopped; if not, the status is as before
/// Source: [DennisGayWelsch1981], structured secants; [Griewank1982], part by part.
bool search_by_secants(const LeastSquares&, const SolveOptions&, int most, Solution& solution);

/// Steps to where the slopes of the cost on the sides of a kink balance. Residuals may have slopes
/// that jump; a minimum may lie on such a kink, where no gradient vanishes. With g_i the gradients
/// found within 1e-3 sds of z, the step that is left is that of their smallest mean,
///   min over shares w >= 0, sum w = 1 of  |sum w_i g_i|,  in the norm  sqrt(g' (J'J)^-1 g).
/// Where a step along it does not lower the cost, the gradient beyond the kink joins the others.
/// @param solution  where it begins; the best point found
/// @return whether less than 3e-3 sds is left, or it was stopped; if not, the status is as before
/// Source: [Goldstein1977] for the set of slopes, [Wolfe1975] for the search.
bool search_at_kink(const LeastSquares&, const SolveOptions&, Solution& solution);

/// The parts of the residuals; an ordinary problem is a single part that knows all coordinates.
struct ResidualBlocks {
  ArrowLayout layout;
  std::vector<ResidualPart> parts;
};
[[nodiscard]] ResidualBlocks blocks_of(const LeastSquares&);

/// Returns whether the gradient pushes coordinate i against a bound on which it lies.
[[nodiscard]] bool held(const LeastSquares&, const Eigen::VectorXd& z, double gradient,
                        Eigen::Index i);

/// The coordinates that no bound holds against the gradient (n).
[[nodiscard]] std::vector<bool> free_coordinates(const LeastSquares&, const Eigen::VectorXd& z,
                                                 const Eigen::VectorXd& gradient);
}  // namespace internal

}  // namespace thenar
