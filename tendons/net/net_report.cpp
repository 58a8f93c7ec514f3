#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>

// What is said of a net at rest.

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kCut = 1e-6;    // angle from the half-plane opposite to a band's side [rad]
constexpr double kDrawn = 1e-9;  // length at which a pull has drawn its node in [m]

}  // namespace

/// Bands over cylinders with an end on the half-plane opposite to their side, where their length
/// jumps.
std::vector<int> NetDescent::wound() const {
  std::vector<int> found;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    const RoundBone& bone = scene_.bone[b];
    if (plan_.net.bands[b].over < 0 || bone.sphere) continue;
    const auto beyond = [&](int node) {
      const Vector3d p = x_[node] - bone.center;
      const double along = bone.e1.dot(p), across = bone.e2.dot(p);
      return plan_.net.nodes[node].free && along < 0 && std::abs(across) < -kCut * along;
    };
    if (beyond(plan_.net.bands[b].a) || beyond(plan_.net.bands[b].b))
      found.push_back(static_cast<int>(b));
  }
  return found;
}

/// Length and tension of a band, and what it holds where it has no length.
void NetDescent::report_band(int b, NetEquilibrium& out) const {
  const NetBand& band = plan_.net.bands[static_cast<std::size_t>(b)];
  if (scene_.drawn[b]) {
    const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
    // Several pulls that meet in one exit share what they hold.
    const double sign = plan_.bands[b].ka >= 0 ? -1 : 1;
    const Vector3d force = sign * scene_.pull[b] / contact_[k].drawn * at_.g[k];
    out.drawn.push_back({b, -force});
    out.length(b) = 0;
    out.tension(b) = force.norm();
    return;
  }
  out.length(b) = at_.length[b];
  out.tension(b) = at_.tension[b];
  const double length = (x_[band.a] - x_[band.b]).norm();
  if (length > kDrawn || !gripped(scene_, b, length)) return;
  const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
  if (now.chord.bent) return;
  out.drawn.push_back({b, -now.pull.tension * now.chord.slope.head<3>()});
  out.tension(b) = out.drawn.back().force.norm();
}

/// Floating nodes that no band holds.
std::vector<int> NetDescent::loose(const NetEquilibrium& at) const {
  std::vector<bool> held(x_.size(), false);
  const auto hold = [&](int band) {
    const NetBand& holds = plan_.net.bands[static_cast<std::size_t>(band)];
    held[holds.a] = held[holds.b] = true;
  };
  for (int b = 0; b < at.tension.size(); ++b)
    if (at.tension(b) > 0) hold(b);
  for (const NetDrawnBand& drawn : at.drawn) hold(drawn.band);
  std::vector<int> found;
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (plan_.row[i] >= 0 && !held[i]) found.push_back(static_cast<int>(i));
  return found;
}

NetEquilibrium NetDescent::report(NetStatus status) const {
  NetEquilibrium out;
  out.status = status;
  out.residual = residual_;
  out.iterations = iterations_;
  out.energy = at_.energy;
  out.pushed_out = pushed_out_;
  if (status == NetStatus::kStalled) out.wound = wound();
  if (!out.wound.empty()) out.status = NetStatus::kWoundRound;
  out.x.resize(3, static_cast<Eigen::Index>(x_.size()));
  for (Eigen::Index i = 0; i < out.x.cols(); ++i) out.x.col(i) = x_[static_cast<std::size_t>(i)];
  const int bands = static_cast<int>(plan_.bands.size());
  out.length.resize(bands);
  out.tension.resize(bands);
  for (int b = 0; b < bands; ++b) report_band(b, out);
  if (status == NetStatus::kBalanced && !out.drawn.empty()) out.status = NetStatus::kDrawnIn;
  for (int k = 0; k < rows(); ++k)
    for (int c = 0; c < contact_[k].pressed; ++c)
      out.contacts.push_back(
          {plan_.node[k], contact_[k].surface[c],
           contact_[k].force[c] - stray(k, contact_[k].surface[c], contact_[k].normal[c]),
           contact_[k].normal[c]});
  out.loose = loose(out);
  return out;
}

}  // namespace thenar::internal
