#pragma once

/// Topology by sparse selection: a penalised fit of all candidates at once.

#include "base/progress.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

/// Options of select_bands().
struct SelectOptions {
  double first_price = 1;   // first price of the log-sum penalty [1]
  double last_price = 300;  // last price [1]
  int prices = 6;           // number of prices, in geometric progression
};

/// Step of the path at one price.
struct PenaltyStep {
  double price = 0;        // [1]
  double misfit = 0;       // chi^2 of the penalised fit [1]
  Topology bands;          // bands that it keeps
  double information = 0;  // chi^2 of the refit without penalty + log(rows) * bands [1]; infinite
                           // if it does not carry the loads
};

/// Result of select_bands().
struct [[nodiscard]] Selection {
  std::vector<PenaltyStep> path;
  Topology bands;  // topology after descent from the step of minimal information
};

/// Minimises  chi^2 + price * sum log(1 + s / kSoftRatio),  s = EA / typical EA >= 0,  over a path
/// of prices from several starts. Bands above half their smallest EA are kept and fitted again
/// without penalty; Schwarz's criterion chooses the step; single changes that lower it are then
/// made.
///
/// The plain L1 penalty on EA is not used: nets of equal ratios of EA differ little, so it would
/// lower the penalty by softening all bands alike. Source: [Candes2008] for the penalty,
/// [Schwarz1978] for the criterion.
[[nodiscard]] Selection select_bands(FittedNets& tried, const SelectOptions& options = {},
                                     const Progress& progress = {});

}  // namespace thenar
