#include "tendons/topology/tried_nets.h"

#include <algorithm>
#include <limits>

namespace thenar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Stiffnesses of a neighbour: what is new starts with its typical EA.
Eigen::VectorXd start_of(const Topology& bands, Eigen::VectorXd s) {
  for (Eigen::Index c = 0; c < s.size(); ++c)
    if (bands[c] && s(c) <= 0) s(c) = 1;
  return s;
}

/// Best of the topologies that differ from `here` by one band.
Topology best_neighbour(TriedNets& tried, const Topology& here, const Eigen::VectorXd& s,
                        double price) {
  Topology best = here;
  double least = kInfinity;
  for (int c = 0; c < static_cast<int>(here.size()); ++c) {
    const Topology next = flipped(here, c);
    const double got = score({next, tried.fit(next, s)}, price);
    if (got < least) least = got, best = next;
  }
  return best;
}

}  // namespace

const BandFit& TriedNets::fit(const Topology& bands, const Eigen::VectorXd& start) {
  auto found = tried_.find(bands);
  if (found == tried_.end()) {
    BandFit fit = fitter_->fit(presences_of(bands), start_of(bands, start));
    found = tried_.emplace(bands, TriedNet{bands, std::move(fit)}).first;
  }
  return found->second.fit;
}

const TriedNet* TriedNets::best(double price) const {
  const TriedNet* best = nullptr;
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && (!best || score(net, price) < score(*best, price))) best = &net;
  return best;
}

double TriedNets::least_misfit(int band, bool present) const {
  double least = kInfinity;
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && bands[band] == present) least = std::min(least, net.fit.misfit);
  return least;
}

std::vector<TriedNet> TriedNets::alike(double doubt) const {
  const TriedNet* first = best();
  std::vector<TriedNet> nets;
  for (const auto& [bands, net] : tried_)
    if (net.fit.holds && net.fit.misfit <= first->fit.misfit + doubt) nets.push_back(net);
  std::sort(nets.begin(), nets.end(),
            [](const TriedNet& a, const TriedNet& b) { return a.fit.misfit < b.fit.misfit; });
  return nets;
}

double score(const TriedNet& net, double price) {
  if (!net.fit.holds) return kInfinity;
  return net.fit.misfit + price * std::count(net.bands.begin(), net.bands.end(), true);
}

Topology flipped(Topology bands, int band) {
  bands[band] = !bands[band];
  return bands;
}

Topology descend(TriedNets& tried, const Topology& from, const Eigen::VectorXd& start,
                 double price) {
  TriedNet here{from, tried.fit(from, start)};
  for (;;) {
    const Eigen::VectorXd s = here.fit.holds ? here.fit.s : start;
    const Topology next = best_neighbour(tried, here.bands, s, price);
    TriedNet there{next, tried.fit(next, s)};
    if (!(score(there, price) < score(here, price))) return here.bands;
    here = std::move(there);
  }
}

}  // namespace thenar
