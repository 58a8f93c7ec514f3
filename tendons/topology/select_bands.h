#pragma once

/// Topology by sparse selection: all candidates at once, at a price.

#include "base/progress.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

struct SelectOptions {
  double first_price = 1;   // of the log-sum penalty [1]
  double last_price = 300;  // [1]
  int prices = 6;           // on the way, in equal ratios
};

/// One price on the path.
struct PenaltyStep {
  double price;        // [1]
  double misfit;       // chi^2 of the priced fit [1]
  Topology bands;      // that it keeps
  double information;  // chi^2 of the refit without price + log(rows) * bands [1]; infinite if it
                       // does not carry the loads
};

struct [[nodiscard]] Selection {
  std::vector<PenaltyStep> path;
  Topology bands;  // after descent from the stop of least information
};

/// Minimises  chi^2 + price * sum log(1 + s / kSoft),  s = EA / typical EA >= 0,  over a path of
/// prices from several starts; bands above half their least EA are kept and fitted again without
/// price; Schwarz's criterion chooses the stop; single changes that lower it are then made.
///
/// The plain L1 price on EA is not used: nets of equal ratios of EA differ little, so it would buy
/// a lower price by softening all bands alike. Source: [Candes2008] for the penalty, [Schwarz1978]
/// for the criterion.
[[nodiscard]] Selection select_bands(FittedNets& tried, const SelectOptions& options = {},
                                     const Progress& progress = {});

}  // namespace thenar
