#pragma once

/// Which modes the draws of a posterior are in, how heavy each is, and whether to believe it.

#include <limits>
#include <string>
#include <vector>

#include "sampling/diagnostics/clusters.h"
#include "sampling/run/draws.h"

namespace thenar {

/// A mode found before sampling, and the normal density that touches the posterior there.
struct KnownMode {
  Eigen::VectorXd centre;      // (n)
  Eigen::MatrixXd covariance;  // positive definite (n, n)
  // Share of the posterior that it should hold, 0..1; NaN: not known.
  double mass = std::numeric_limits<double>::quiet_NaN();
};

struct ModeOptions {
  ClusterOptions clusters;
  long min_crossings = 10;  // fewer into and out of a mode: its mass is not to be trusted [1]
};

/// One mode, from the draws that are in it.
struct ModeMass {
  double mass = 0;         // share of all draws, 0..1
  double mcse = 0;         // its Monte Carlo standard error; NaN: cannot be told [1]
  Eigen::VectorXd centre;  // mean of its draws; the known centre if it has none (n)
  Eigen::VectorXd sd;      // of its draws; NaN below 2 (n)
  Eigen::VectorXd visits;  // share of each chain's draws (chains)
  long crossings = 0;      // steps of all chains into or out of it [1]
  int known = -1;          // its place among the modes known before; -1: found in the draws
};

struct ModeTable {
  std::vector<ModeMass> modes;        // heaviest first
  Eigen::MatrixXi of_draw;            // index in `modes` (draws, chains)
  long crossings = 0;                 // steps of all chains from one mode to another [1]
  std::vector<std::string> warnings;  // sentences; empty: the masses can be trusted
};

/// Sorts draws into modes. Known ones: each draw goes to the mode m of the largest normal density
///   -1/2 (x - c_m)' C_m^-1 (x - c_m) - 1/2 log |C_m|.
/// None known: by find_clusters(), whose header says what it cannot see.
///
/// A mass is a mean of indicators, so that its standard error is theirs, of ensembles where
/// draws.group says that chains are walkers; it means nothing where chains do not cross: masses
/// then only repeat where the chains began. A known mode that holds no draw is doubted, unless its
/// mass promises less than one.
/// @throws InputError if shapes disagree, a draw is not finite or a covariance not positive
/// definite.
[[nodiscard]] ModeTable tabulate_modes(const Draws& draws, const std::vector<KnownMode>& known = {},
                                       const ModeOptions& options = {});

}  // namespace thenar
