#include "tendons/topology/select_bands.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace thenar {
namespace {

constexpr std::size_t kStopDescents = 2;  // number of descents, from the best steps
constexpr double kStarts[] = {1, 0.1};    // initial s of all bands, one path each [1]

/// Returns the bands above half their smallest EA.
Topology kept_bands(const BandFitter& fitter, const Eigen::VectorXd& s) {
  Topology bands;
  for (Eigen::Index c = 0; c < s.size(); ++c) {
    const double least = fitter.candidate().candidates[c].min_EA / fitter.typical_EA()(c);
    bands.push_back(s(c) > 0.5 * least);
  }
  return bands;
}

/// Fits the kept bands again without penalty.
PenaltyStep refit(FittedNets& tried, double price, const BandFit& priced) {
  PenaltyStep stop{price, priced.misfit, kept_bands(tried.fitter(), priced.s), 0};
  const double log_rows = std::log(static_cast<double>(tried.fitter().rows()));
  stop.information = score({stop.bands, tried.fit(stop.bands, priced.s)}, log_rows);
  return stop;
}

/// Follows the path from one start, until the net no longer holds.
void follow(FittedNets& tried, const Eigen::VectorXd& start, const SelectOptions& options,
            std::vector<PenaltyStep>& path, const Progress& progress) {
  BandFitter& fitter = tried.fitter();
  // Set prices in geometric progression.
  const Presences either(static_cast<std::size_t>(start.size()), Presence::kEither);
  const double ratio =
      std::pow(options.last_price / options.first_price, 1.0 / std::max(options.prices - 1, 1));
  Eigen::VectorXd s = start;
  double price = options.first_price;
  // Start each price from the previous fit.
  for (int i = 0; i < options.prices; ++i, price *= ratio) {
    if (progress.stop() && !path.empty()) return;
    const BandFit priced = fitter.fit(either, s, Eigen::VectorXd::Constant(s.size(), price));
    if (!priced.holds) return;
    s = priced.s;
    path.push_back(refit(tried, price, priced));
  }
}

}  // namespace

Selection select_bands(FittedNets& tried, const SelectOptions& options, const Progress& progress) {
  const Eigen::Index n = tried.fitter().typical_EA().size();
  Selection out;
  // Follow paths from soft and from typical bands.
  double part = 0;
  for (double s : kStarts) {
    progress(part, "path over the price");
    part += 0.6 / std::size(kStarts);
    if (progress.stop() && !out.path.empty()) break;
    follow(tried, Eigen::VectorXd::Constant(n, s), options, out.path, progress);
  }
  // Fit the full topology, which carries any load that can be carried.
  (void)tried.fit(Topology(static_cast<std::size_t>(n), true), Eigen::VectorXd::Ones(n));
  const double price = std::log(static_cast<double>(tried.fitter().rows()));
  // Sort all nets that carry the loads by Schwarz's criterion.
  const std::vector<FittedNet> starts =
      best_by_score(tried.nets_within(kInfinity), price, kStopDescents);
  if (starts.empty()) return out;
  // Descend from the best of them by single changes.
  for (const FittedNet& start : starts) {
    progress(part += 0.1 / kStopDescents, "changes of single bands");
    if (!progress.stop()) descend(tried, start.bands, start.fit.s, price);
  }
  out.bands = tried.best(price)->bands;
  return out;
}

}  // namespace thenar
