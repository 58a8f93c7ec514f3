#include "report/draws/modes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "report/words.h"

namespace thenar {
namespace {

/// Means of one quantity in every mode, and the distance between them.
struct ModeMeans {
  const Quantity* quantity;
  Eigen::VectorXd mean;  // NaN in a mode without draws [unit] (modes)
  double apart;          // range of the means, in sds of all draws [1]
};

ModeMeans means_of(const ModeTable& table, const Quantity& quantity) {
  require(quantity.draws.rows() == table.of_draw.rows() &&
              quantity.draws.cols() == table.of_draw.cols(),
          "{} has {} draws of {} chains, the modes have {} of {}", quantity.name,
          quantity.draws.rows(), quantity.draws.cols(), table.of_draw.rows(), table.of_draw.cols());
  // Mean of the quantity within each mode.
  const auto modes = static_cast<Eigen::Index>(table.modes.size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(modes), count = sum;
  for (Eigen::Index c = 0; c < quantity.draws.cols(); ++c)
    for (Eigen::Index i = 0; i < quantity.draws.rows(); ++i) {
      sum[table.of_draw(i, c)] += quantity.draws(i, c);
      count[table.of_draw(i, c)] += 1;
    }
  ModeMeans out{&quantity, sum.cwiseQuotient(count), 0};
  // Measure how far the modes are apart, in sds of all draws.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double mean : out.mean)
    if (std::isfinite(mean)) {
      low = std::min(low, mean);
      high = std::max(high, mean);
    }
  const double all = quantity.draws.mean();
  const double sd = std::sqrt((quantity.draws.array() - all).square().mean());
  out.apart = sd > 0 ? (high - low) / sd : 0;
  return out;
}

/// "0, 100, 98 %" of the chains' draws.
std::string visits_of(const ModeMass& mode) {
  return each_in_words(mode.visits,
                       [](double share) { return fmt::format("{:.0f}", 100 * share); });
}

}  // namespace

Json mode_table(const ModeTable& modes, const std::vector<Quantity>& quantities, std::size_t most) {
  // Show the quantities in which modes differ most.
  std::vector<ModeMeans> means =
      transformed(quantities, [&](const Quantity& quantity) { return means_of(modes, quantity); });
  std::stable_sort(means.begin(), means.end(),
                   [](const ModeMeans& a, const ModeMeans& b) { return a.apart > b.apart; });
  means.resize(std::min(most, means.size()));

  std::vector<BlockColumn> columns{"mode:0", "share of draws [%]:1", "MCSE [%]:1",
                                   "of each chain [%]", "crossings:0"};
  for (const ModeMeans& of : means)
    columns.push_back({of.quantity->name, of.quantity->unit == "1" ? "" : of.quantity->unit});
  Json rows = Json::array();
  for (std::size_t m = 0; m < modes.modes.size(); ++m) {
    const ModeMass& mode = modes.modes[m];
    Json row =
        Json::array({m + 1, 100 * mode.mass, 100 * mode.mcse, visits_of(mode), mode.crossings});
    for (const ModeMeans& of : means) row.push_back(of.mean[static_cast<Eigen::Index>(m)]);
    rows.push_back(std::move(row));
  }
  return table_block(
      "Modes, the heaviest first: share of the draws with its Monte Carlo error, how "
      "often chains went in or out, and means of what tells the modes apart",
      columns, rows);
}

}  // namespace thenar
