#pragma once

/// Masses of the modes of a posterior from its draws, with warnings if they are unreliable.

#include <limits>
#include <string>
#include <vector>

#include "sampling/diagnostics/clusters.h"
#include "sampling/run/draws.h"

namespace thenar {

/// Mode found before sampling, with its Laplace approximation.
struct KnownMode {
  Eigen::VectorXd centre;      // (n)
  Eigen::MatrixXd covariance;  // positive definite (n, n)
  // Expected share of the posterior, 0..1; NaN: not known.
  double mass = std::numeric_limits<double>::quiet_NaN();
};

/// Options of tabulate_modes().
struct ModeOptions {
  ClusterOptions clusters;
  long min_crossings =
      10;  // minimum number of steps into and out of a mode for a reliable mass [1]
};

/// Mode described by the draws in it.
struct ModeMass {
  double mass = 0;         // share of all draws, 0..1
  double mcse = 0;         // Monte Carlo standard error of the mass; NaN: not known [1]
  Eigen::VectorXd centre;  // mean of its draws; without draws, the known centre (n)
  Eigen::VectorXd sd;      // sd of its draws; NaN for fewer than 2 (n)
  Eigen::VectorXd visits;  // share of each chain's draws in this mode (chains)
  long crossings = 0;      // number of steps of all chains into or out of it [1]
  int known = -1;          // index among the known modes; -1: found in the draws
};

/// Modes of the draws of a run.
struct ModeTable {
  std::vector<ModeMass> modes;        // modes by falling mass
  Eigen::MatrixXi of_draw;            // index in `modes` of each draw (draws, chains)
  long crossings = 0;                 // number of steps of all chains from one mode to another [1]
  std::vector<std::string> warnings;  // sentences; empty: the masses are reliable
};

/// Assigns draws to modes. With known modes, each draw is assigned to the mode m with the largest
/// normal density
///   -1/2 (x - c_m)' C_m^-1 (x - c_m) - 1/2 log |C_m|.
/// Without known modes the draws are clustered by find_clusters(), with its limitations.
///
/// The mass is the mean of an indicator, and its error the standard error of that mean, over
/// ensembles if draws.group says that chains are walkers. If no chain crosses between modes, the
/// error is meaningless because the masses only reflect the initial points. A known mode without
/// any draw raises a warning unless less than one draw is expected in it.
/// @throws InputError if shapes disagree, a draw is not finite, or a covariance is not positive
///         definite.
[[nodiscard]] ModeTable tabulate_modes(const Draws& draws, const std::vector<KnownMode>& known = {},
                                       const ModeOptions& options = {});

}  // namespace thenar
