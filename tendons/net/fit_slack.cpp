#include "tendons/net/fit_slack.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Computes the length of a band with both ends at their start.
double band_length(const Net& net, const TreeState<double>& state, const NetBand& band) {
  // Pose the ends.
  const NetNode &a = net.nodes[band.a], &b = net.nodes[band.b];
  const Vector3d p_a = moved(state, a.link, a.p), p_b = moved(state, b.link, b.p);
  if (band.over < 0) return (p_a - p_b).norm();
  // Wrap the string over its surface.
  const BoneSurface& surface = net.surfaces[band.over];
  const Pose<double> X = surface_pose(surface, state);
  const WrappedString chord = wrap_string(surface, X.inverse() * p_a, X.inverse() * p_b, band.side);
  require(chord.possible, "band '{}' of net '{}' starts inside surface '{}', over which it bends",
          band.name, net.name, surface.name);
  return chord.length;
}

}  // namespace

std::vector<double> start_lengths(const Net& net, const TreeState<double>& state) {
  return transformed(net.bands, [&](const NetBand& band) { return band_length(net, state, band); });
}

double fit_slack(Net& net, const TreeState<double>& state, const Eigen::VectorXd& load,
                 const std::vector<FittedBand>& bands, int rounds) {
  constexpr double kConvergedStrain = 1e-6;  // strain error below which the fit has converged [1]
  // Damping of corrections, since bands share load [1]
  constexpr double kDamping = 0.5;
  NetSolver solver(net);
  Eigen::Matrix3Xd start;
  double off = 0;
  for (int round = 0; round < rounds; ++round) {
    // Solve the equilibrium under the load, from the previous one.
    const NetEquilibrium rest = solver.solve(state, {load, {}}, round == 0 ? nullptr : &start);
    if (rest.status != NetStatus::kBalanced && rest.status != NetStatus::kOverstrained &&
        rest.status != NetStatus::kNodeCollapsed)
      return std::numeric_limits<double>::infinity();
    const auto strain = [&](int b) {
      const double slack = net.bands[b].slack;
      return (rest.length[b] - slack) / slack;
    };
    start = rest.x;
    off = 0;
    // Compute corrections towards the wanted strains.
    std::vector<double> slack;
    for (const FittedBand& fitted : bands) {
      const double own = strain(fitted.band);
      const double wanted =
          fitted.like < 0 ? std::max(own, 0.0) : std::max(strain(fitted.like), 0.0);
      off = std::max(off, std::abs(wanted - own));
      const double step = fitted.like < 0 ? 1 : kDamping;
      slack.push_back(net.bands[fitted.band].slack * (1 - step * (wanted - own)));
    }
    if (off < kConvergedStrain) break;
    // Apply the new slack lengths.
    for (std::size_t k = 0; k < bands.size(); ++k) net.bands[bands[k].band].slack = slack[k];
    solver = NetSolver(net);
  }
  return off;
}

}  // namespace thenar
