#pragma once

/// Second-order cone programmes of a few dozen variables.

#include <vector>

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// minimise c' x  subject to  A x = b,  h - G x in K.
///
/// K is a product of second-order cones { (t, v) : |v| <= t }, one after the other down the rows of
/// G; a cone of one row is t >= 0, an inequality.
struct ConeProgram {
  Eigen::VectorXd c;       // (n)
  Eigen::MatrixXd A;       // (r, n); r = 0 allowed
  Eigen::VectorXd b;       // (r)
  Eigen::MatrixXd G;       // (m, n)
  Eigen::VectorXd h;       // (m)
  std::vector<int> cones;  // rows of each; their sum is m
};

struct ConeOptions {
  double tolerance = 1e-10;  // scaled residual and gap at which it stops [1]
  double acceptable = 1e-7;  // the same for the best iterate or certificate, where rounding ends
                             // progress [1]
  int max_iterations = 100;
};

struct [[nodiscard]] ConeResult {
  Status status;      // kSolved: x is optimal within `residual`; kInfeasible: y and z are Farkas'
                      // proof; kUnbounded: a feasible point, and a direction along which the
                      // objective falls, both checked anew to 10 `acceptable`; kLimit, kStalled:
                      // nothing could be shown, x is the best point found
  Eigen::VectorXd x;  // (n)
  Eigen::VectorXd y;  // multipliers of A x = b:  c + A' y + G' z = 0 (r)
  Eigen::VectorXd z;  // multipliers of the cones, in K (m)
  double objective;   // c' x; +infinity: infeasible, -infinity: unbounded
  double dual;        // -b' y - h' z: a bound of the objective from below within `residual`
  double residual;    // largest of the KKT conditions of the programme as asked: feasibility, dual
                      // feasibility, gap, each divided by 1 + the norm of what it is compared
                      // with; computed anew from x, y and z. Above 10 `acceptable`: kStalled [1].
                      // Infeasible: no x shorter than its inverse obeys all. Unbounded: how far the
                      // direction leaves the set, over the fall of the objective
  int iterations;
};

/// Solves by a primal-dual interior-point method on the homogeneous self-dual embedding with
/// Nesterov-Todd scaling and Mehrotra's corrector. Equalities, also redundant ones, are removed
/// first; directions that neither cones nor equalities see are removed or prove unboundedness.
/// Newton steps are refined, so that programmes with many contacts on one face end within
/// `tolerance`, too; where 12 iterations bring nothing better, the best one counts if `acceptable`.
///
/// @throws InputError if shapes disagree or an entry is not finite.
/// Source: [Andersen2003] for the method, [Vandenberghe2010] for its linear algebra.
ConeResult solve(const ConeProgram& program, const ConeOptions& options = {});

}  // namespace thenar
