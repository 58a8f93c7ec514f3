#include "report/draws/chains.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "sampling/diagnostics/autocovariance.h"
#include "sampling/diagnostics/order_statistics.h"
#include "sampling/diagnostics/split_chains.h"

namespace thenar {
namespace {

// Most points of a trace, and lags of an autocorrelation
constexpr Eigen::Index kTracePoints = 250, kLags = 50;
constexpr int kRankBins = 20;  // Bins of a histogram of ranks
// Chains up to which all traces are drawn, and most traces
constexpr std::size_t kAllShown = 8, kMaxShown = 16;

/// Chains whose traces are drawn, and their names.
struct ShownChains {
  std::vector<Eigen::Index> columns;
  std::vector<std::string> names;
  bool by_group = false;
};

ShownChains shown_chains(const Quantity& quantity) {
  ShownChains shown;
  shown.by_group =
      !quantity.group.empty() && static_cast<std::size_t>(quantity.draws.cols()) > kAllShown;
  std::set<int> seen;
  for (Eigen::Index c = 0; c < quantity.draws.cols(); ++c) {
    if (shown.by_group && !seen.insert(nth(quantity.group, c)).second) continue;
    if (shown.columns.size() == kMaxShown) break;
    shown.columns.push_back(c);
    shown.names.push_back(
        fmt::format("{} {}", shown.by_group ? "group" : "chain", shown.columns.size()));
  }
  return shown;
}

/// Autocorrelations of the chains shown, and the mean time that all need to forget.
struct Memory {
  Json rho = Json::array();  // autocorrelation at every `step`-th lag
  Eigen::Index step = 1;
  double tau = 1;
};

Memory memory_of(const Quantity& quantity, const ShownChains& shown) {
  Memory memory;
  std::vector<Eigen::VectorXd> rho;
  // Mean correlation time of all chains, and the slowest to choose the range.
  double sum = 0, slowest = 1;
  for (Eigen::Index c = 0; c < quantity.draws.cols(); ++c) {
    rho.push_back(autocorrelation(quantity.draws.col(c)));
    const double tau = correlation_time(rho.back());
    sum += std::isfinite(tau) ? tau : 1;
    if (std::isfinite(tau)) slowest = std::max(slowest, tau);
  }
  memory.tau = sum / static_cast<double>(quantity.draws.cols());
  // Far enough to see every chain forget.
  const auto wanted = static_cast<Eigen::Index>(8 * slowest);
  const Eigen::Index last = std::min(std::max<Eigen::Index>(wanted, 30), quantity.draws.rows() / 2);
  memory.step = std::max<Eigen::Index>(1, last / kLags);
  const auto lags = Eigen::seqN(0, last / memory.step + 1, memory.step);
  for (const Eigen::Index c : shown.columns) memory.rho.push_back(rounded(nth(rho, c)(lags), 1));
  return memory;
}

/// Counts of ranks of the chains shown, and the band about them.
Json ranks_of(const Quantity& quantity, const ShownChains& shown, double tau) {
  const Eigen::MatrixXd pooled =
      shown.by_group ? pool_groups(quantity.draws, quantity.group) : quantity.draws;
  const Eigen::MatrixXd counts = rank_counts(pooled, kRankBins);
  Json list = Json::array();
  for (std::size_t k = 0; k < shown.columns.size(); ++k)
    list.push_back(rounded(counts.col(static_cast<Eigen::Index>(k)), 1));
  const CountBand band = rank_band(static_cast<double>(pooled.rows()),
                                   static_cast<double>(pooled.cols()), kRankBins, tau);
  return {{"counts", list},
          {"mean", static_cast<double>(pooled.rows()) / kRankBins},
          {"low", std::round(10 * band.low) / 10},
          {"high", std::round(10 * band.high) / 10}};
}

Json number(double value, double scale) {
  return rounded(Eigen::VectorXd::Constant(1, value), scale)[0];
}

Json quantity_of(const Quantity& quantity) {
  const ShownChains shown = shown_chains(quantity);
  const std::vector<Eigen::Index> chosen = spread(quantity.draws.rows(), kTracePoints);
  const auto trace = [&](Eigen::Index c) {
    return rounded(quantity.draws.col(c)(chosen), quantity.estimate.sd);
  };
  const Memory memory = memory_of(quantity, shown);
  Json out{{"name", quantity.name},
           {"r_hat", number(quantity.estimate.r_hat, 1)},
           {"bulk_ess", number(quantity.estimate.bulk_ess, 1000)},
           {"tail_ess", number(quantity.estimate.tail_ess, 1000)},
           {"traces", list_of_each(shown.columns, trace)},
           {"ranks", ranks_of(quantity, shown, memory.tau)},
           {"autocorrelation", memory.rho},
           {"lag_step", memory.step}};
  if (!quantity.unit.empty() && quantity.unit != "1") out["unit"] = quantity.unit;
  return out;
}

}  // namespace

Eigen::MatrixXd rank_counts(const Eigen::Ref<const Eigen::MatrixXd>& x, int bins) {
  const Eigen::MatrixXd ranks = average_ranks(x);  // 1 .. N
  const auto total = static_cast<double>(x.size());
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(bins, x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c)
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      const int bin = static_cast<int>((ranks(i, c) - 0.5) / total * bins);
      counts(std::clamp(bin, 0, bins - 1), c) += 1;
    }
  return counts;
}

Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& x) {
  if (!x.allFinite() || x.maxCoeff() == x.minCoeff())
    return Eigen::VectorXd::Constant(x.size(), kNaN);
  const Eigen::VectorXd c = autocovariance(x);
  return c / c[0];
}

double correlation_time(const Eigen::Ref<const Eigen::VectorXd>& rho) {
  if (!rho.allFinite()) return kNaN;
  double sum = 0;
  for (Eigen::Index t = 0; t + 1 < rho.size(); t += 2) {
    const double pair = rho[t] + rho[t + 1];
    if (pair <= 0) break;
    sum += pair;
  }
  return std::max(1.0, 2 * sum - 1);
}

CountBand rank_band(double draws, double chains, int bins, double tau) {
  const double total = draws * chains, p = 1.0 / bins;
  const double variance =
      total > 1 ? tau * draws * p * (1 - p) * (total - draws) / (total - 1) : 0.0;
  const double mean = draws * p, reach = 1.96 * std::sqrt(variance);
  return {std::max(0.0, mean - reach), std::min(draws, mean + reach)};
}

bool worse(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a > b; }

std::vector<const Quantity*> worst_first(const std::vector<Quantity>& quantities) {
  std::vector<const Quantity*> order =
      transformed(quantities, [](const Quantity& quantity) { return &quantity; });
  std::stable_sort(order.begin(), order.end(), [](const Quantity* a, const Quantity* b) {
    return worse(a->estimate.r_hat, b->estimate.r_hat);
  });
  return order;
}

Json chains_block(const std::vector<Quantity>& quantities, const std::string& caption) {
  Json block{{"type", "chains"}, {"caption", caption}, {"quantities", Json::array()}};
  if (quantities.empty()) return block;
  for (const Quantity& quantity : quantities) {
    require(quantity.draws.rows() >= 4 && quantity.draws.cols() >= 1,
            "{} has {} draws of {} chains, wanted at least 4 of 1", quantity.name,
            quantity.draws.rows(), quantity.draws.cols());
    require(quantity.draws.rows() == quantities.front().draws.rows() &&
                quantity.draws.cols() == quantities.front().draws.cols(),
            "{} has {} draws of {} chains, {} has {} of {}", quantity.name, quantity.draws.rows(),
            quantity.draws.cols(), quantities.front().name, quantities.front().draws.rows(),
            quantities.front().draws.cols());
  }
  block["chains"] = shown_chains(quantities.front()).names;
  block["draws"] = list_of_each(spread(quantities.front().draws.rows(), kTracePoints),
                                [](Eigen::Index i) { return i + 1; });
  for (const Quantity* quantity : worst_first(quantities))
    block["quantities"].push_back(quantity_of(*quantity));
  return block;
}

}  // namespace thenar
