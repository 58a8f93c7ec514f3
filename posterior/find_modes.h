#pragma once

/// Search for the modes of a posterior by least squares, and initial points of chains around them.

#include <optional>
#include <vector>

#include "posterior/mode_curvature.h"

namespace thenar {

/// Local minimum of 1/2 |r(z)|^2 with the Laplace approximation of the posterior there.
struct Mode {
  Eigen::VectorXd z;                       // position, in prior sds (n)
  double cost = 0;                         // 1/2 |r|^2 [1]
  std::optional<ModeCurvature> curvature;  // J'J at the mode; none if the mode was read from a file
  int hits = 0;                            // number of searches that ended here [1]
  double laplace_mass = 0;           // share of exp(-cost) sqrt|covariance| among all modes, 0..1
  Status status = Status::kStalled;  // status of the best search that ended here
};

/// Starting points of the searches, and the criteria by which two minima are one mode.
struct ModeSearchOptions {
  int starts = 16;  // number of starts, drawn from N(0, start_sd^2) within bounds: the prior [1]
  double start_sd = 1;           // sd of the starts [prior sds]
  int global_searches = 1;       // number of derivative-free global searches by NLopt [1]
  Eigen::MatrixXd extra_starts;  // starts that are searched first; may be empty (n, starts)
  double same_distance = 1;      // distance below which two minima are one mode [Laplace sds]
  double same_cost = 0.5;        // largest difference in cost of minima that are one mode [1]
  unsigned seed = 1;             // random seed of the starts
  SolveOptions polish;           // options of the local searches
  Progress progress;
};

/// Modes and the searches that found them.
struct [[nodiscard]] FoundModes {
  std::vector<Mode> modes;  // modes by ascending cost; empty if no search ended at finite cost
  std::vector<Solution> searches;   // all searches, in the order in which they were made
  std::vector<int> mode_of_search;  // index of the mode of each search; -1: none
  Status status = Status::kSolved;  // kStopped: some searches were not made
};

/// Searches from many starts, each polished by the local solver, and merges minima that the data
/// cannot distinguish: z and z_m are one mode if
///   (z - z_m)' C_m^-1 (z - z_m) < same_distance^2  and  |cost - cost_m| < same_cost,
/// with C_m = (J'J)^-1 at the lower minimum. A start with non-finite residuals is a failed search.
/// If the residuals do not come in blocks, directions without curvature get 1e12 times the smallest
/// variance, so that the covariance stays finite.
/// @throws InputError if options are out of range or shapes disagree.
FoundModes find_modes(const LeastSquares& problem, const ModeSearchOptions& search = {});

/// Draws overdispersed initial points of chains from
///   sum_m w_m N(z_m, inflation^2 C_m),   w_m = (laplace_mass_m + 1 / modes) / 2,
/// over modes whose Laplace mass is at least 1e-6: a chain stuck in a lighter mode would bias the
/// run. Draws are reflected at bounds and kept away from them by 1 % of the distance between the
/// bounds (0.01 from a single bound). Consecutive columns are distributed over the modes as evenly
/// as the weights allow.
/// @param count      number of points
/// @param inflation  factor on the Laplace sds [1]
/// @throws InputError if there is no mode, one has no curvature, or an argument is out of range.
[[nodiscard]] Eigen::MatrixXd dispersed_starts(const LeastSquares& problem,
                                               const std::vector<Mode>& modes, int count,
                                               double inflation = 2, unsigned seed = 1);

}  // namespace thenar
