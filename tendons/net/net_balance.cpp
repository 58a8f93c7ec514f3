#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>

// What presses the nodes of a net on the bones, and what is left out of balance.

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kLift = 1e-11;   // lift from a bone that no number here can tell from none [m]
constexpr double kDigit = 1e-17;  // rounding of a lift [m]

}  // namespace

/// What bands that bend over a surface hold a node on it with, at the least lift that its place can
/// tell: their slope along the normal grows as  sqrt(2 lift / radius)  times their tension S, and
/// rounding of the lift by kDigit changes it by S kDigit / sqrt(2 lift radius).
double NetDescent::clasp(int k, int surface) const {
  double sum = 0;
  for (int b : plan_.clasps[k]) {
    const NetBand& band = plan_.net.bands[b];
    if (band.over != surface) continue;
    const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
    if (now.chord.bent) sum += now.pull.tension;
  }
  const double radius = plan_.net.surfaces[surface].size[0];
  return sum *
         std::max(std::sqrt(2 * kLift / radius), 4 * kDigit * sum / (options_.tolerance * radius));
}

/// The part along the normal of what bands that bend over a surface pull a node on it with: they
/// leave along the surface, so all of it is rounding of the node's lift, the same as in at_.g [N].
double NetDescent::stray(int k, int surface, const Vector3d& normal) const {
  double sum = 0;
  for (int b : plan_.clasps[k]) {
    const NetBand& band = plan_.net.bands[b];
    BandRun run;
    if (band.over != surface || scene_.drawn[b]) continue;
    const Bend bend = bend_over(scene_.bone[b], x_[band.a], x_[band.b], run);
    if (bend == Bend::kClear) continue;
    if (bend == Bend::kOdd) {
      const Chord chord = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]).chord;
      if (!chord.bent) continue;
      run.ua = chord.slope.head<3>(), run.ub = chord.slope.tail<3>();
    }
    sum += at_.tension[b] * normal.dot(plan_.bands[b].ka == k ? run.ua : run.ub);
  }
  return sum;
}

void NetDescent::balance() {
  residual_ = 0;
  for (int k = 0; k < rows(); ++k) {
    NodeContact& c = contact_[k];
    const Vector3d& x = x_[plan_.node[k]];
    std::array<double, 3> slop{};
    slop.fill(options_.tolerance);
    const int touching = c.touching;
    balance_node(plan_.net, scene_, x, at_.g[k], slop, c);
    if (c.pressed < touching && !plan_.clasps[k].empty()) {
      for (int i = 0; i < touching; ++i) slop[i] += clasp(k, c.surface[i]);
      balance_node(plan_.net, scene_, x, at_.g[k], slop, c);
    }
    residual_ = std::max(residual_, c.left.norm());
  }
}

}  // namespace thenar::internal
