#pragma once

/// Linear complementarity problems by Lemke's algorithm.

#include <string>

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// Find z with  w = M z + q,  z >= 0,  w >= 0,  z' w = 0.
struct LinearComplementarity {
  Eigen::MatrixXd M;  // (n, n)
  Eigen::VectorXd q;  // (n)
};

struct ComplementarityOptions {
  double tolerance = 1e-10;  // of the residual [1]
  int max_pivots = 0;        // 0: 50 (n + 1)
};

struct [[nodiscard]] ComplementaritySolution {
  /// kSolved: the residual is at most the tolerance. kInfeasible: `ray` proves that no z >= 0 has
  /// M z + q >= 0. kStalled: ended on a ray that proves nothing (M is not copositive-plus, or
  /// rounding). kLimit: of pivots.
  Status status = Status::kStalled;
  std::string message;
  Eigen::VectorXd z, w;  // w = M z + q, computed from M and q (n)
  double residual = 0;   // complementarity_residual() of z
  Eigen::VectorXd ray;   // direction z + t ray on which the algorithm ended (n), else (0)
  int pivots = 0;
};

/// Complementary pivoting from an artificial variable that covers every row, by the lexicographic
/// rule, which cannot cycle. It ends in an answer or on a ray; where M is copositive-plus (as
/// positive semidefinite matrices and those of friction pyramids are), a ray means that there is
/// no answer. The last basis is solved anew from M and q, so pivots leave no rounding behind.
/// Cost: n^2 a pivot, some n pivots.
/// @throws InputError unless shapes fit and all is finite.
/// Source: [Lemke1965]; [CottlePangStone1992], section 4.4 and, for the rule, 4.9.
[[nodiscard]] ComplementaritySolution solve_complementarity(
    const LinearComplementarity& problem, const ComplementarityOptions& options = {});

/// Largest of  -w_i / |q|,  -z_i / |z|,  min(z_i / |z|, w_i / |q|),  with the largest entries |q|
/// and |z| (1 where they are 0) and w = M z + q: 0 at answers only.
[[nodiscard]] double complementarity_residual(const LinearComplementarity& problem,
                                              const Eigen::VectorXd& z);

/// Returns whether  y >= 0,  M' y <= 0,  q' y < 0  to rounding: then no z >= 0 has M z + q >= 0, as
/// y' (M z + q) < 0 for every one (Farkas).
[[nodiscard]] bool proves_infeasible(const LinearComplementarity& problem,
                                     const Eigen::VectorXd& y);

}  // namespace thenar
