#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>

#include "tendons/net/world_surface.h"

// How far they go.

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kNear = 1e-3;   // lift over radius below which clasping bands go as its root [1]
constexpr double kKinks = 1e-4;  // steps below which slack bands that become taut decide [m]

}  // namespace

/// Where bands clasp a node, its lift h is pulled at as sqrt(h): Newton's step dh is taken in
/// sqrt(h), which makes it  h (1 + dh / 2h)^2  and exact.
void NetDescent::lift(int k, Vector3d& there) const {
  const NodeContact& c = contact_[k];
  const Vector3d& x = x_[plan_.node[k]];
  int before = -1;
  for (int b : plan_.clasps[k]) {
    const int s = plan_.net.bands[b].over;
    const int* last = c.surface.data() + c.pressed;
    if (s == before || std::find(c.surface.data(), last, s) != last) continue;
    before = s;
    const double radius = plan_.net.surfaces[s].size[0];
    const SurfaceGap at = gap_world(plan_.net, scene_, s, x);
    if (at.gap > kNear * radius) continue;
    const double h = std::max(at.gap, 0.5e-14 * radius), dh = at.normal.dot(there - x);
    if (dh <= -2 * h) continue;
    const double more = dh * dh / (4 * h), most = kNear * radius;
    if (h + dh + more <= most)
      there += more * at.normal;
    else if (h + dh < most)
      there += (most - h - dh) * at.normal;
  }
}

/// Moves along the step by `part`, staying outside bones; `slope` is that of E along it [J].
bool NetDescent::try_step(double part, double& slope) {
  slope = 0;
  for (int k = 0; k < rows(); ++k) {
    const int i = plan_.node[k];
    contact_next_[k] = contact_[k];
    x_next_[i] = x_[i] + part * step_[k];
    const double straight = part * at_.g[k].dot(step_[k]);
    if (contact_[k].drawn > 0 || plan_.net.nodes[i].surfaces.empty()) {
      slope += straight;
      continue;
    }
    if (!plan_.clasps[k].empty()) lift(k, x_next_[i]);
    if (!settle_node(plan_.net, scene_, plan_.net.nodes[i], x_next_[i], contact_next_[k]))
      return false;
    const bool hit = contact_next_[k].touching > contact_[k].pressed;
    slope += hit ? at_.g[k].dot(x_next_[i] - x_[i]) : straight;
  }
  evaluate(plan_, scene_, x_next_, next_);
  return true;
}

/// Part of the step at which the first band of constant pull passes its exit; 1 if none does.
double NetDescent::part_at_exit() const {
  double part = 1;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    if (!(scene_.pull[b] > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    Vector3d move = Vector3d::Zero();
    if (at.ka >= 0) move += step_[at.ka];
    if (at.kb >= 0) move -= step_[at.kb];
    const Vector3d d = x_[band.a] - x_[band.b];
    if (gripped(scene_, static_cast<int>(b), d.norm())) continue;  // it is there
    const double way = -d.dot(move), whole = move.squaredNorm();
    if (way > 0 && way < whole && whole > 0.1 * d.squaredNorm()) part = std::min(part, way / whole);
  }
  return part;
}

/// What rounding of places may change E by: tension times the last digits of places [J].
double NetDescent::rounding() const {
  double reach = 0, sum = 0;
  for (const Vector3d& x : x_) reach = std::max(reach, x.norm());
  for (double T : at_.tension) sum += T;
  return 2e-16 * reach * sum + 1e-15 * at_.size;
}

/// Shortens the step until E falls. @return whether it did
bool NetDescent::search() {
  const double noise = rounding();
  const double exit = part_at_exit();
  double part = exit > 1e-3 && exit < 0.9 ? exit : 1;
  bool at_exit = part < 1;
  int looks = iterations_ % 2 == 0 ? 5 : 0;  // every other time: either way alone may creep
  for (int tries = 0; tries < 60; ++tries) {
    double slope = 0;
    const bool possible = try_step(part, slope);
    if (possible && next_.energy <= at_.energy + 1e-4 * std::min(slope, 0.0) + noise) {
      accept();
      if (part < 0.3)
        radius_ = std::max({2 * part * longest_, 0.1 * std::min(longest_, radius_), 1e-7});
      else
        radius_ = std::min(std::max(radius_, 4 * longest_), kLongest);
      longest_ *= part;
      return true;
    }
    if (part == 1 && possible && longest_ < kKinks && looks-- > 0 && look_ahead()) {
      if (!direction()) return false;
      definite_ = false;  // of what it was made to be
      continue;
    }
    part = at_exit ? 1 : 0.5 * part;
    at_exit = false;
  }
  return false;
}

}  // namespace thenar::internal
