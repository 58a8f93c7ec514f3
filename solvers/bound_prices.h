#pragma once

/// Shadow prices of the upper bounds of a linear program, including degenerate optima.

#include "solvers/linear_program.h"

namespace thenar {

/// One-sided shadow prices of upper bounds: the change of the optimum per unit of the bound. The
/// optimum is a concave function of each bound, so relaxing a bound by one unit gains at most what
/// tightening it by one unit costs.
struct BoundPrices {
  // d optimum / d upper bound as the bound grows; 0 where it is not active (n)
  Eigen::VectorXd increase;
  // d optimum / d upper bound as it shrinks, >= increase; infinite if the program is infeasible
  // below this bound; NaN if no method certifies a price (n)
  Eigen::VectorXd decrease;
};

/// Computes the minimum and maximum price of every upper bound over all optimal duals, i.e. the
/// feasible duals that satisfy complementary slackness with best.x. At a nondegenerate vertex the
/// duals are unique and both prices are those of best.duals; otherwise each price is the certified
/// optimum of another linear program.
///
/// @param best  certified solution of `program`
/// @throws InputError if `best` is not solved or its shapes disagree.
/// Source: [Gal1986] for prices at degenerate vertices.
[[nodiscard]] BoundPrices upper_bound_prices(const LinearProgram& program,
                                             const LinearResult& best);

}  // namespace thenar
