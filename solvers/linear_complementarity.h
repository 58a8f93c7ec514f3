#pragma once

/// Linear complementarity problems by Lemke's algorithm.

#include <string>

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// Problem: find z with  w = M z + q,  z >= 0,  w >= 0,  z' w = 0.
struct LinearComplementarity {
  Eigen::MatrixXd M;  // (n, n)
  Eigen::VectorXd q;  // (n)
};

struct ComplementarityOptions {
  double tolerance = 1e-10;  // maximum residual of a solution [1]
  int max_pivots = 0;        // maximum number of pivots; 0: 50 (n + 1)
};

struct [[nodiscard]] ComplementaritySolution {
  /// Outcome. kSolved: the residual is at most the tolerance. kInfeasible: `ray` proves that no z
  /// >= 0 satisfies M z + q >= 0. kStalled: ended on a ray without proof (M is not copositive-plus,
  /// or rounding). kLimit: the maximum number of pivots was reached.
  Status status = Status::kStalled;
  std::string message;
  Eigen::VectorXd z, w;  // w = M z + q, computed from M and q (n)
  double residual = 0;   // complementarity_residual() of z
  Eigen::VectorXd ray;   // direction z + t ray on which the algorithm ended (n), or empty
  int pivots = 0;
};

/// Solves by Lemke's complementary pivoting with an artificial variable in every row and the
/// lexicographic rule, which prevents cycling. The algorithm ends with a solution or on a ray. If M
/// is copositive-plus, as positive semidefinite matrices and those of friction pyramids are, a ray
/// means that there is no solution. The last basis is solved again from M and q, which removes the
/// rounding errors of the pivots. Cost: n^2 per pivot, about n pivots.
/// @throws InputError if shapes disagree or an entry is not finite.
/// Source: [Lemke1965]; [CottlePangStone1992], section 4.4 and, for the rule, 4.9.
[[nodiscard]] ComplementaritySolution solve_complementarity(
    const LinearComplementarity& problem, const ComplementarityOptions& options = {});

/// Returns the maximum of  -w_i / |q|,  -z_i / |z|,  min(z_i / |z|, w_i / |q|),  with the largest
/// entries |q| and |z| (1 where they are 0) and w = M z + q. Zero at solutions only.
[[nodiscard]] double complementarity_residual(const LinearComplementarity& problem,
                                              const Eigen::VectorXd& z);

/// Returns whether  y >= 0,  M' y <= 0,  q' y < 0  to rounding. Then no z >= 0 satisfies M z + q >=
/// 0, because y' (M z + q) < 0 for every z >= 0 (Farkas).
[[nodiscard]] bool proves_infeasible(const LinearComplementarity& problem,
                                     const Eigen::VectorXd& y);

}  // namespace thenar
