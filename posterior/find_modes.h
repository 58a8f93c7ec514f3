#pragma once

/// Where a posterior has its modes, before any chain is started.

#include <vector>

#include "solvers/least_squares.h"

namespace thenar {

/// A local minimum of 1/2 |r(z)|^2, and the normal density that touches the posterior there.
struct Mode {
  Eigen::VectorXd z;           // in prior sds (n)
  double cost = 0;             // 1/2 |r|^2 [1]
  Eigen::MatrixXd covariance;  // (J'J)^-1; zero where bounds hold a coordinate (n, n)
  int hits = 0;                // searches that ended here [1]
  double laplace_mass = 0;     // share of exp(-cost) sqrt|covariance| among all modes, 0..1
  SolveStatus status = SolveStatus::kFailed;  // of the best search that ended here
};

struct ModeSearchOptions {
  int starts = 16;           // drawn from N(0, spread^2) within bounds: the prior [1]
  double spread = 1;         // [prior sds]
  int global_searches = 1;   // by NLopt, without derivatives [1]
  Eigen::MatrixXd also;      // further starts, searched first; may be empty (n, starts)
  double same_distance = 1;  // minima nearer than this are one mode [Laplace sds]
  double same_cost = 0.5;    // and whose costs differ by less [1]
  unsigned seed = 1;
  SolveOptions polish;  // of the local searches
  Progress progress;
};

/// What the searches found.
struct [[nodiscard]] FoundModes {
  std::vector<Mode> modes;          // by rising cost; empty if no search ended at finite cost
  std::vector<Solution> searches;   // every one, in the order in which it was made
  std::vector<int> mode_of_search;  // index of its mode; -1: none
  bool stopped = false;             // by a stop request: some searches were not made
};

/// Searches from many starts, each polished by the local solver, and gathers minima that the data
/// cannot tell apart: z and z_m are one mode where
///   (z - z_m)' C_m^-1 (z - z_m) < same_distance^2  and  |cost - cost_m| < same_cost,
/// C_m = (J'J)^-1 at the better of both. A start where the residuals are not finite is a failed
/// search. Directions that neither data nor priors know get the variance 1e12 times the smallest
/// known of all, so that the covariance stays finite.
/// @throws InputError if options are out of range or shapes disagree.
FoundModes find_modes(const LeastSquares& problem, const ModeSearchOptions& search = {});

/// Starting points of chains, further out than the posterior reaches: draws from
///   sum_m w_m N(z_m, inflation^2 C_m),   w_m = (laplace_mass_m + 1 / modes) / 2,
/// over modes whose Laplace mass is at least 1e-6: in a lighter one a chain would be stuck where a
/// run of a million draws has no business, and spoil it. Draws are reflected at bounds and kept off
/// them by 1 % of their distance (0.01 from a single one). Columns next to each other are spread
/// over the modes as evenly as the weights allow.
/// @param count      columns
/// @param inflation  of the Laplace sds [1]
/// @throws InputError if there is no mode, or an argument is out of range.
[[nodiscard]] Eigen::MatrixXd dispersed_starts(const LeastSquares& problem,
                                               const std::vector<Mode>& modes, int count,
                                               double inflation = 2, unsigned seed = 1);

}  // namespace thenar
