#pragma once

/// Second-order cone programs of a few dozen variables.

#include <vector>

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// Problem:  minimise c' x  subject to  A x = b,  h - G x in K.
///
/// K is a product of second-order cones { (t, v) : |v| <= t }, stacked along the rows of G. A cone
/// of one row is the inequality t >= 0.
struct ConeProgram {
  Eigen::VectorXd c;       // (n)
  Eigen::MatrixXd A;       // (r, n); r = 0 allowed
  Eigen::VectorXd b;       // (r)
  Eigen::MatrixXd G;       // (m, n)
  Eigen::VectorXd h;       // (m)
  std::vector<int> cones;  // number of rows of each cone; their sum is m
};

struct ConeOptions {
  double tolerance = 1e-10;            // scaled residual and gap at which iterations stop [1]
  double acceptable_tolerance = 1e-7;  // scaled residual and gap that is accepted when rounding
                                       // errors prevent further progress [1]
  int max_iterations = 100;            // Newton iterations
};

struct [[nodiscard]] ConeResult {
  /// kSolved: x is optimal within `residual`; kInfeasible: y and z are a Farkas certificate;
  /// kUnbounded: x is feasible and a direction of descent exists, both verified to 10
  /// `acceptable_tolerance`; kLimit, kStalled: nothing was proved, and x is the best point found.
  Status status = Status::kStalled;
  Eigen::VectorXd x;     // (n)
  Eigen::VectorXd y;     // multipliers of A x = b:  c + A' y + G' z = 0 (r)
  Eigen::VectorXd z;     // multipliers of the cones, in K (m)
  double objective = 0;  // c' x; +infinity: infeasible, -infinity: unbounded
  double dual = 0;       // -b' y - h' z: lower bound of the objective within `residual`
  double residual = 0;   // kSolved: largest violation of the KKT conditions of the original program
                        // (feasibility, dual feasibility, gap), each over 1 + the norm of the terms
                        // compared, recomputed from x, y and z; above 10 `acceptable_tolerance` the
                        // status is kStalled [1]. kInfeasible: no x shorter than its inverse
                        // satisfies all constraints. kUnbounded: violation along the direction over
                        // the decrease of the objective
  int iterations = 0;  // Newton iterations
};

/// Solves by a primal-dual interior-point method on the homogeneous self-dual embedding with
/// Nesterov-Todd scaling and Mehrotra's corrector. Equalities, including redundant ones, are
/// eliminated first. Directions on which neither cones nor equalities depend are removed, or prove
/// unboundedness. Iterative refinement of the Newton steps lets programs with many contacts on one
/// face reach `tolerance`, too. If 12 iterations bring no improvement, the best iterate or
/// certificate is accepted if it is within `acceptable_tolerance`.
///
/// @throws InputError if shapes disagree or an entry is not finite.
/// Source: [Andersen2003] for the method, [Vandenberghe2010] for its linear algebra.
ConeResult solve(const ConeProgram& program, const ConeOptions& options = {});

}  // namespace thenar
