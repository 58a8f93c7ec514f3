#include "tendons/net/net_descent.h"

#include <algorithm>

// Nodes that a muscle draws into its exit.

namespace thenar::internal {

using Eigen::Vector3d;

/// Puts the free end of a band of constant pull into its exit, if the other end is fixed and the
/// exit is outside of bones. @return whether it did
bool NetDescent::draw_in(int b) {
  const BandPlan& at = plan_.bands[b];
  const NetBand& band = plan_.net.bands[b];
  if ((at.ka >= 0) == (at.kb >= 0) || draws_[b] > 2) return false;
  const int k = std::max(at.ka, at.kb), i = plan_.node[k];
  const Vector3d exit = x_[at.ka >= 0 ? band.b : band.a];
  for (int s : plan_.net.nodes[i].surfaces)
    if (gap_world(plan_.net, scene_, s, exit).gap < 0) return false;
  x_[i] = exit;
  contact_[k].drawn += scene_.pull[b];
  contact_[k].touching = contact_[k].pressed = 0;
  scene_.drawn[b] = true;
  ++draws_[b];
  return true;
}

/// Lets go of nodes that more than their pull drags out of an exit. @return whether there were any
bool NetDescent::let_out() {
  bool any = false;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    if (!scene_.drawn[b]) continue;
    NodeContact& c = contact_[std::max(plan_.bands[b].ka, plan_.bands[b].kb)];
    if (c.left.norm() <= options_.tolerance) continue;
    scene_.drawn[b] = false;
    any = true;
  }
  for (std::size_t b = 0; any && b < plan_.bands.size(); ++b) {
    const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
    if (k < 0) continue;  // between two bones
    NodeContact& c = contact_[k];
    if (c.drawn > 0 && !scene_.drawn[b] && c.left.norm() > options_.tolerance) c.drawn = 0;
  }
  return any;
}

/// Notes the force of bands of constant pull that have no length. @return whether one changed
bool NetDescent::grip() {
  bool changed = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    const NetBand& band = plan_.net.bands[b];
    const Vector3d d = x_[band.a] - x_[band.b];
    if (scene_.drawn[b] || !gripped(scene_, b, d.norm())) continue;
    Vector3d p = scene_.hold[b] + scene_.grip[b] * d;
    const double excess = p.norm() / scene_.pull[b];
    if (excess < 1 && draw_in(b)) {
      changed = true;
      continue;
    }
    if (excess > 1) p /= excess;
    if (excess > 1 && d.norm() * scene_.grip[b] > scene_.pull[b]) p.setZero();
    if ((p - scene_.hold[b]).norm() < 0.1 * options_.tolerance) continue;
    scene_.hold[b] = p;
    changed = true;
  }
  return changed;
}

}  // namespace thenar::internal
