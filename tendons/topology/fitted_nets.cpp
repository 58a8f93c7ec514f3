#include "tendons/topology/fitted_nets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

// Largest number of pairs of changes tried where noise does not explain the misfit
constexpr int kMaxChangePairs = 40;

/// Tries all topologies that differ by one band. @return the bands, best change first
std::vector<int> change_singly(FittedNets& tried, const FittedNet& here, double price) {
  // Compute the score after each single change.
  std::vector<std::pair<double, int>> changes;
  for (int c = 0; c < static_cast<int>(here.bands.size()); ++c) {
    const Topology next = flipped(here.bands, c);
    changes.emplace_back(score({next, tried.fit(next, here.fit.s)}, price), c);
  }
  std::sort(changes.begin(), changes.end());
  return transformed(changes, &std::pair<double, int>::second);
}

/// Tries pairs of the changes that alone increase the score least, until one helps.
void change_in_pairs(FittedNets& tried, const FittedNet& here, const std::vector<int>& order,
                     double price) {
  int left = kMaxChangePairs;
  for (std::size_t b = 1; b < order.size(); ++b)
    for (std::size_t a = 0; a < b && left > 0; ++a, --left) {
      const Topology next = flipped(flipped(here.bands, order[a]), order[b]);
      if (score({next, tried.fit(next, here.fit.s)}, price) < score(here, price)) return;
    }
}

}  // namespace

std::vector<Eigen::VectorXd> FittedNets::usual_starts() const {
  const Eigen::Index n = fitter_->typical_EA().size();
  return {Eigen::VectorXd::Ones(n), fitter_->min_stiffness(), fitter_->max_stiffness()};
}

const BandFit& FittedNets::fit(const Topology& bands, const Eigen::VectorXd& start) {
  // Return a known fit.
  const auto found = tried_.find(bands);
  if (found != tried_.end()) return found->second.fit;
  // Fit from the given start, then from the usual ones until it carries the loads.
  FittedNet net{bands, fitter_->fit(topology_presences(bands), start)};
  for (const Eigen::VectorXd& usual : usual_starts())
    if (!net.fit.holds) net.fit = fitter_->fit(topology_presences(bands), usual);
  return tried_.emplace(bands, std::move(net)).first->second.fit;
}

void FittedNets::settle(const Topology& bands, const Eigen::VectorXd& start) {
  (void)fit(bands, start);
  FittedNet& net = tried_.at(bands);
  if (net.settled) return;
  net.settled = true;
  // Fit from all starts and keep the best.
  std::vector<Eigen::VectorXd> starts = usual_starts();
  starts.push_back(start);
  for (const Eigen::VectorXd& from : starts) {
    BandFit again = fitter_->fit(topology_presences(bands), from);
    const bool better = !net.fit.holds || again.misfit < net.fit.misfit;
    if (again.holds && better) net.fit = std::move(again);
  }
}

const FittedNet* FittedNets::best(double price) const {
  const FittedNet* best = nullptr;
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && (!best || score(net, price) < score(*best, price))) best = &net;
  return best;
}

const FittedNet* FittedNets::best_where(int band, bool present) const {
  const FittedNet* best = nullptr;
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && bands[band] == present && (!best || net.fit.misfit < best->fit.misfit))
      best = &net;
  return best;
}

double FittedNets::min_misfit(int band, bool present) const {
  const FittedNet* best = best_where(band, present);
  return best ? best->fit.misfit : kInfinity;
}

std::vector<FittedNet> FittedNets::nets_within(double doubt) const {
  const FittedNet* first = best();
  std::vector<FittedNet> nets;
  // Collect every net that carries the loads and fits as well.
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && net.fit.misfit <= first->fit.misfit + doubt) nets.push_back(net);
  std::sort(nets.begin(), nets.end(),
            [](const FittedNet& a, const FittedNet& b) { return a.fit.misfit < b.fit.misfit; });
  return nets;
}

bool noise_explains(const BandFit& fit) {
  const auto rows = static_cast<double>(fit.r.size());
  return fit.holds && fit.misfit < rows + 6 * std::sqrt(2 * rows);
}

double score(const FittedNet& net, double price) {
  if (!net.fit.holds) return kInfinity;
  return net.fit.misfit + price * std::count(net.bands.begin(), net.bands.end(), true);
}

std::vector<FittedNet> best_by_score(std::vector<FittedNet> nets, double price, std::size_t most) {
  std::sort(nets.begin(), nets.end(), [&](const FittedNet& a, const FittedNet& b) {
    return score(a, price) < score(b, price);
  });
  nets.resize(std::min(nets.size(), most));
  return nets;
}

Topology flipped(Topology bands, int band) {
  bands[band] = !bands[band];
  return bands;
}

Topology descend(FittedNets& tried, const Topology& from, const Eigen::VectorXd& start,
                 double price) {
  FittedNet here{from, tried.fit(from, start)};
  for (;;) {
    if (!here.fit.holds) return here.bands;
    // Find the best single change.
    const std::vector<int> order = change_singly(tried, here, price);
    const Topology nearest = flipped(here.bands, order[0]);
    FittedNet next{nearest, tried.fit(nearest, here.fit.s)};
    // Change two at once where no single change helps and noise does not explain the misfit.
    if (!(score(next, price) < score(here, price)) && !noise_explains(here.fit)) {
      change_in_pairs(tried, here, order, price);
      next = *tried.best(price);
    }
    if (!(score(next, price) < score(here, price))) return here.bands;
    here = std::move(next);
  }
}

}  // namespace thenar
