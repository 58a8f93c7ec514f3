#pragma once

/// Joint-axis tilts that the data of a fit do not determine.

#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"

namespace thenar {

/// Tilt of an axis that the forces cannot distinguish from a tilt of the load cell.
struct CorrelatedTilts {
  std::string axis, cell;  // names of the entries of z
  double correlation = 0;  // posterior correlation of the two entries [1]
};

/// Posterior sd, over the prior sd, above which the data have not determined an entry of z [1].
inline constexpr double kUndecidedShare = 0.9;

/// Tilts of axes that a fit leaves undetermined.
struct UndeterminedTilts {
  int tilt_count = 0;                         // number of entries of z that tilt an axis [1]
  std::vector<CoordinateEstimate> undecided;  // tilts that keep more than kUndecidedShare
  std::vector<CorrelatedTilts> correlated;    // pairs with a correlation above 0.8, largest first
};

/// Finds tilts that the forces do not determine, and tilts that are correlated with those of the
/// load cell: there the prior decides which of the two is tilted, with or without
/// inference of its scale.
/// @param covariance  covariance of the fit at z
[[nodiscard]] UndeterminedTilts find_undetermined_tilts(const FitProblem& problem,
                                                        const Eigen::VectorXd& z,
                                                        const Covariance& covariance);

/// Describes the undetermined tilts as warnings of one sentence each.
[[nodiscard]] std::vector<std::string> describe(const UndeterminedTilts& tilts);

}  // namespace thenar
