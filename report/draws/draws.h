#pragma once

/// Draws of a posterior as blocks: traces with ranks, marginals by pairs, and intervals. Any number
/// of draws may be given: plotted draws are thinned, so that 60 quantities of 4 chains take about 1
/// MB; ranks, correlations and intervals use all draws.

#include <optional>
#include <string>
#include <vector>

#include "report/blocks.h"
#include "sampling/diagnostics/convergence.h"

namespace thenar {

/// One quantity of a posterior, in a readable unit.
struct Quantity {
  std::string name;        // "axis/CMC1_FE/direction/1"
  std::string unit;        // "deg"; empty or "1": none
  Eigen::MatrixXd draws;   // after warm-up [unit] (draws, chains)
  std::vector<int> group;  // group of each chain, see Draws::group; empty: each its own (chains)
  Estimate estimate;       // [unit]; name is not used
  Eigen::VectorXd prior;   // draws from the prior [unit] (any); empty: not known
  std::optional<double> truth;  // true value behind simulated data [unit]
  std::string meaning;          // "CMC flexion axis: tilt about the digit's length"; may be empty
};

/// Returns a corner plot: densities of single quantities and of pairs, 50 and 90 % regions, the
/// prior as a light outline; those with the largest information gain first.
[[nodiscard]] Json corner_block(const std::vector<Quantity>& quantities,
                                const std::string& caption);

/// Returns a chart of posterior 50 and 90 % intervals beside the prior's, in units of the prior's
/// sd about its mean, sorted by 1 - sd / prior sd. Quantities without a prior are left out.
/// @param most  largest number of rows; of more, the best known and the four least known are kept
[[nodiscard]] Json forest_block(const std::vector<Quantity>& quantities, const std::string& caption,
                                std::size_t most = 40);

/// Returns a table of mean, sd, Monte Carlo errors, quantiles, R-hat and ESS of all quantities, and
/// their meanings where known; worst R-hat first.
[[nodiscard]] Json estimate_table(const std::vector<Quantity>& quantities,
                                  const std::string& caption);

}  // namespace thenar
