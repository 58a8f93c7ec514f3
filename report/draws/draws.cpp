#include "report/draws/draws.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "report/draws/chains.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

constexpr Eigen::Index kCornerDraws = 800, kCornerPrior = 400;  // a quantity
constexpr std::size_t kCornerShown = 6;

/// "deg"; nothing for numbers without unit.
std::string shown_unit(const Quantity& quantity) {
  return quantity.unit == "1" ? "" : quantity.unit;
}

double sd_of(const Eigen::Ref<const Eigen::VectorXd>& x) {
  if (x.size() < 2) return 0;
  return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

Eigen::VectorXd all_draws(const Quantity& quantity) {
  return Eigen::Map<const Eigen::VectorXd>(quantity.draws.data(), quantity.draws.size());
}

Eigen::VectorXd some(const Eigen::VectorXd& x, Eigen::Index most) {
  return x(spread(x.size(), most));
}

/// Information gained from the draws: 1 - sd / prior sd; 0 without a prior.
double learnt(const Quantity& quantity) {
  const double before = sd_of(quantity.prior);
  return before > 0 ? 1 - sd_of(all_draws(quantity)) / before : 0;
}

Json corner_quantity(const Quantity& quantity) {
  const Eigen::VectorXd draws = all_draws(quantity);
  const double sd = sd_of(draws);
  Json out{{"name", quantity.name}, {"draws", rounded(some(draws, kCornerDraws), sd)}};
  if (!shown_unit(quantity).empty()) out["unit"] = shown_unit(quantity);
  if (quantity.prior.size() > 1) out["prior"] = rounded(some(quantity.prior, kCornerPrior), sd);
  if (quantity.truth) out["truth"] = *quantity.truth;
  return out;
}

/// Indices of the quantities that most was learnt about.
std::vector<std::size_t> shown_first(const std::vector<Quantity>& quantities) {
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return learnt(quantities[a]) > learnt(quantities[b]);
  });
  order.resize(std::min(order.size(), kCornerShown));
  std::sort(order.begin(), order.end());
  return order;
}

/// Returns a number rounded to two significant digits of its error.
double to_error(double value, double error) {
  if (!std::isfinite(value) || !(error > 0)) return value;
  const double step = std::pow(10, std::floor(std::log10(error)) - 1);
  return std::stod(fmt::format("{:.12g}", std::round(value / step) * step));
}

Json estimate_row(const Quantity& quantity) {
  const Estimate& e = quantity.estimate;
  const std::string unit = shown_unit(quantity);
  Json row = Json::array({unit.empty() ? quantity.name : quantity.name + " [" + unit + "]"});
  for (const double value : {e.mean, e.mcse_mean}) row.push_back(to_error(value, e.mcse_mean));
  for (const double value : {e.sd, e.mcse_sd}) row.push_back(to_error(value, e.mcse_sd));
  for (const double value : {e.q05, e.median, e.q95}) row.push_back(to_error(value, e.mcse_mean));
  for (const double value : {e.r_hat, e.bulk_ess, e.tail_ess}) row.push_back(value);
  return row;
}

// ---- posteriors beside priors

constexpr std::size_t kMinKnown = 4;  // rows kept of what nothing was learnt about

/// A quantity against its prior.
struct Learning {
  const Quantity* quantity;
  Eigen::VectorXd posterior, prior;  // rising, in prior sds from the prior mean
  double sd;                         // posterior sd, same unit [1]
};

Learning learning(const Quantity& quantity) {
  const double mean = quantity.prior.mean(), sd = sd_of(quantity.prior);
  Learning out{&quantity, sorted(quantity.draws), sorted(quantity.prior), 0};
  out.posterior = ((out.posterior.array() - mean) / sd).matrix();
  out.prior = ((out.prior.array() - mean) / sd).matrix();
  out.sd = sd_of(out.posterior);
  return out;
}

double to_thousandth(double value) { return std::round(1000 * value) / 1000; }

/// "12.30 \u00b1 0.41 deg; 85 % learnt": mean and sd, with the digits that the sd leaves.
std::string own_unit(const Quantity& quantity, double share) {
  const Eigen::VectorXd draws = sorted(quantity.draws);
  const double sd = sd_of(draws);
  const int digits =
      sd > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(sd))), 0, 12) : 4;
  const std::string unit = quantity.unit.empty() || quantity.unit == "1" ? "" : " " + quantity.unit;
  const std::string text = fmt::format("{:.{}f} \u00b1 {:.{}f}{}; {:.0f} % learnt", draws.mean(),
                                       digits, sd, digits, unit, 100 * std::max(0.0, share));
  return text[0] == '-' ? "\u2212" + text.substr(1) : text;
}

Json row_of(const Learning& what) {
  const Quantity& quantity = *what.quantity;
  // Quantiles of the posterior beside those of the prior, in prior sds.
  const auto at = [&](const Eigen::VectorXd& x, double share) {
    return to_thousandth(quantile(x, share));
  };
  Json row{{"name", quantity.name},
           {"estimate", at(what.posterior, 0.5)},
           {"low", at(what.posterior, 0.05)},
           {"high", at(what.posterior, 0.95)},
           {"inner_low", at(what.posterior, 0.25)},
           {"inner_high", at(what.posterior, 0.75)},
           {"prior_low", at(what.prior, 0.05)},
           {"prior_high", at(what.prior, 0.95)},
           {"prior_inner_low", at(what.prior, 0.25)},
           {"prior_inner_high", at(what.prior, 0.75)},
           {"display", own_unit(quantity, 1 - what.sd)}};
  if (quantity.truth)
    row["truth"] = to_thousandth((*quantity.truth - quantity.prior.mean()) / sd_of(quantity.prior));
  return row;
}

}  // namespace

Json corner_block(const std::vector<Quantity>& quantities, const std::string& caption) {
  return {{"type", "corner"},
          {"caption", caption},
          {"shown", shown_first(quantities)},
          {"quantities", list_of_each(quantities, corner_quantity)}};
}

Json forest_block(const std::vector<Quantity>& quantities, const std::string& caption,
                  std::size_t most) {
  std::vector<Learning> known;
  for (const Quantity& quantity : quantities)
    if (quantity.prior.size() > 1 && sd_of(quantity.prior) > 0 && quantity.draws.size() > 1 &&
        quantity.draws.allFinite())
      known.push_back(learning(quantity));
  std::stable_sort(known.begin(), known.end(),
                   [](const Learning& a, const Learning& b) { return a.sd < b.sd; });
  Json rows = Json::array();
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known.size() <= most || k + kMinKnown < most || k + kMinKnown >= known.size())
      rows.push_back(row_of(known[k]));
  return interval_block(caption, "distance from the prior mean [prior sds]", rows);
}

Json estimate_table(const std::vector<Quantity>& quantities, const std::string& caption) {
  std::vector<BlockColumn> columns{"quantity", "mean", "MCSE",    "sd",         "MCSE",      "5 %",
                                   "median",   "95 %", "R-hat:3", "bulk ESS:0", "tail ESS:0"};
  const bool known = any_of(quantities, [](const Quantity& q) { return !q.meaning.empty(); });
  if (known) columns.emplace_back("meaning");
  Json rows = Json::array();
  for (const Quantity* quantity : worst_first(quantities)) {
    rows.push_back(estimate_row(*quantity));
    if (known) rows.back().push_back(quantity->meaning);
  }
  return with(table_block(caption, columns, rows), {{"search", true}});
}

}  // namespace thenar
