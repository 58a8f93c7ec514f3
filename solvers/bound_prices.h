#pragma once

/// Shadow prices of the upper bounds of a linear program, also where they are not unique.

#include "solvers/linear_program.h"

namespace thenar {

/// Prices of upper bounds, the change of the optimum per unit. The optimum is a concave function of
/// each bound, so that a bound let out by one unit gives at most what the same bound drawn in by
/// one unit takes.
struct BoundPrices {
  Eigen::VectorXd increase;  // d optimum / d upper bound as it grows; 0 where it does not bind (n)
  Eigen::VectorXd decrease;  // the same as it shrinks, >= increase; infinite where the program has
                             // no answer below this bound; NaN where no method proves one (n)
};

/// Least and largest price of every upper bound over all optimal duals: over the duals that are
/// feasible and, by complementary slackness with best.x, optimal. Where the vertex is not
/// degenerate the duals are unique and both prices are those of best.duals; elsewhere each price is
/// a linear program of its own, certified like any other.
///
/// @param best  solved, of `program`
/// @throws InputError if `best` is not solved or has other shapes.
/// Source: [Gal1986] for prices at degenerate vertices.
[[nodiscard]] BoundPrices upper_bound_prices(const LinearProgram& program,
                                             const LinearResult& best);

}  // namespace thenar
