#pragma once

/// Masses of the modes of a posterior from its draws, and warnings where they are unreliable.

#include <limits>
#include <string>
#include <vector>

#include "sampling/diagnostics/clusters.h"
#include "sampling/run/draws.h"

namespace thenar {

/// A mode found before sampling, with its Laplace approximation.
struct KnownMode {
  Eigen::VectorXd centre;      // (n)
  Eigen::MatrixXd covariance;  // positive definite (n, n)
  // Expected share of the posterior, 0..1; NaN: not known.
  double mass = std::numeric_limits<double>::quiet_NaN();
};

/// Options of tabulate_modes().
struct ModeOptions {
  ClusterOptions clusters;
  long min_crossings = 10;  // fewer steps into and out of a mode make its mass unreliable [1]
};

/// One mode, described by the draws in it.
struct ModeMass {
  double mass = 0;         // share of all draws, 0..1
  double mcse = 0;         // Monte Carlo standard error of the mass; NaN: not known [1]
  Eigen::VectorXd centre;  // mean of its draws; the known centre if it has none (n)
  Eigen::VectorXd sd;      // of its draws; NaN below 2 (n)
  Eigen::VectorXd visits;  // share of each chain's draws (chains)
  long crossings = 0;      // steps of all chains into or out of it [1]
  int known = -1;          // index among the modes known before; -1: found in the draws
};

struct ModeTable {
  std::vector<ModeMass> modes;        // heaviest first
  Eigen::MatrixXi of_draw;            // index in `modes` (draws, chains)
  long crossings = 0;                 // steps of all chains from one mode to another [1]
  std::vector<std::string> warnings;  // sentences; empty: the masses are reliable
};

/// Assigns draws to modes. With known modes, each draw goes to the mode m of the largest normal
/// density
///   -1/2 (x - c_m)' C_m^-1 (x - c_m) - 1/2 log |C_m|.
/// Without known modes the draws are clustered by find_clusters(); see there for its limits.
///
/// A mass is the mean of an indicator and has the indicator's standard error, over ensembles where
/// draws.group says that chains are walkers. Where no chain crosses between modes, the error is
/// meaningless: the masses only repeat where the chains began. A known mode without any draw raises
/// a warning unless its mass promises less than one draw.
/// @throws InputError if shapes disagree, a draw is not finite or a covariance not positive
/// definite.
[[nodiscard]] ModeTable tabulate_modes(const Draws& draws, const std::vector<KnownMode>& known = {},
                                       const ModeOptions& options = {});

}  // namespace thenar
