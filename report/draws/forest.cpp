#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/draws/draws.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

constexpr std::size_t kLeastKnown = 4;  // rows kept of what nothing was learnt about

/// A quantity against its prior.
struct Learning {
  const Quantity* quantity;
  Eigen::VectorXd posterior, prior;  // rising, in prior sds from the prior mean
  double sd;                         // of the posterior, the same unit [1]
};

double sd_of(const Eigen::VectorXd& x) {
  return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

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
    if (known.size() <= most || k + kLeastKnown < most || k + kLeastKnown >= known.size())
      rows.push_back(row_of(known[k]));
  return {{"type", "interval"},
          {"caption", caption},
          {"x_label", "distance from the prior mean [prior sds]"},
          {"rows", rows}};
}

}  // namespace thenar
