#pragma once

/// Search for the modes of a posterior by least squares, and starting points of chains about them.

#include <optional>
#include <vector>

#include "posterior/mode_curvature.h"

namespace thenar {

/// A local minimum of 1/2 |r(z)|^2 with the Laplace approximation of the posterior there.
struct Mode {
  Eigen::VectorXd z;                       // in prior sds (n)
  double cost = 0;                         // 1/2 |r|^2 [1]
  std::optional<ModeCurvature> curvature;  // J'J there; none of a mode that a file has kept
  int hits = 0;                            // searches that ended here [1]
  double laplace_mass = 0;           // share of exp(-cost) sqrt|covariance| among all modes, 0..1
  Status status = Status::kStalled;  // of the best search that ended here
};

/// Starts of the searches, and when two minima are one mode.
struct ModeSearchOptions {
  int starts = 16;               // drawn from N(0, start_sd^2) within bounds: the prior [1]
  double start_sd = 1;           // [prior sds]
  int global_searches = 1;       // by NLopt, without derivatives [1]
  Eigen::MatrixXd extra_starts;  // searched first; may be empty (n, starts)
  double same_distance = 1;      // minima nearer than this are one mode [Laplace sds]
  double same_cost = 0.5;        // if their costs differ by less than this [1]
  unsigned seed = 1;
  SolveOptions polish;  // of the local searches
  Progress progress;
};

/// Modes and all searches.
struct [[nodiscard]] FoundModes {
  std::vector<Mode> modes;          // by rising cost; empty if no search ended at finite cost
  std::vector<Solution> searches;   // all searches, in the order in which they were made
  std::vector<int> mode_of_search;  // index of its mode; -1: none
  Status status = Status::kSolved;  // kStopped: some searches were not made
};

/// Searches from many starts, each polished by the local solver, and merges minima that the data
/// cannot separate: z and z_m are one mode where
///   (z - z_m)' C_m^-1 (z - z_m) < same_distance^2  and  |cost - cost_m| < same_cost,
/// C_m = (J'J)^-1 at the better of both. A start where the residuals are not finite is a failed
/// search. Where residuals do not come in blocks, directions without curvature of data or priors
/// get 1e12 times the smallest variance, so that the covariance stays finite.
/// @throws InputError if options are out of range or shapes disagree.
FoundModes find_modes(const LeastSquares& problem, const ModeSearchOptions& search = {});

/// Overdispersed starting points of chains: draws from
///   sum_m w_m N(z_m, inflation^2 C_m),   w_m = (laplace_mass_m + 1 / modes) / 2,
/// over modes whose Laplace mass is at least 1e-6: a chain that is stuck in a lighter mode would
/// distort the run. Draws are reflected at bounds and kept away from them by 1 % of the distance
/// between the bounds (0.01 from a single bound). Neighbouring columns are spread over the modes as
/// evenly as the weights allow.
/// @param count      columns
/// @param inflation  of the Laplace sds [1]
/// @throws InputError if there is no mode, one has no curvature, or an argument is out of range.
[[nodiscard]] Eigen::MatrixXd dispersed_starts(const LeastSquares& problem,
                                               const std::vector<Mode>& modes, int count,
                                               double inflation = 2, unsigned seed = 1);

}  // namespace thenar
