#include <algorithm>
#include <cmath>
#include <utility>

#include "tendons/net/net_descent.h"

// Nodes that a muscle draws into its exit.

namespace thenar::internal {

using Eigen::Vector3d;

/// Moves the free end of a band of constant pull into its exit, if the other end is fixed and the
/// exit is outside bones. @return whether it did
bool NetDescent::collapse_to_exit(int b) {
  const BandPlan& at = plan_.bands[b];
  const NetBand& band = plan_.net.bands[b];
  // Require one fixed end, and not too many collapses.
  if ((at.ka >= 0) == (at.kb >= 0) || collapse_counts_[b] > 2) return false;
  const int k = std::max(at.ka, at.kb), i = plan_.node[k];
  // Require that the exit is outside the node's bones.
  const Vector3d exit = here_.x[at.ka >= 0 ? band.b : band.a];
  for (int s : plan_.net.nodes[i].surfaces)
    if (gap_world(plan_.net, scene_, s, exit).gap < 0) return false;
  // Fix the node in the exit.
  here_.x[i] = exit;
  here_.contact[k].collapsed += scene_.pull[b];
  here_.contact[k].touching = here_.contact[k].pressed = 0;
  scene_.collapsed[b] = true;
  ++collapse_counts_[b];
  return true;
}

/// Releases nodes that are pulled out of an exit by more than their muscle's pull. @return whether
/// there were any
bool NetDescent::release_from_exit() {
  bool any = false;
  // Release bands whose node has a residual above the tolerance.
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    if (!scene_.collapsed[b]) continue;
    NodeContact& c = here_.contact[std::max(plan_.bands[b].ka, plan_.bands[b].kb)];
    if (c.residual.norm() <= options_.tolerance) continue;
    scene_.collapsed[b] = false;
    any = true;
  }
  // Release the contact state of such nodes.
  for (std::size_t b = 0; any && b < plan_.bands.size(); ++b) {
    const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
    if (k < 0) continue;  // between two bones
    NodeContact& c = here_.contact[k];
    if (c.collapsed > 0 && !scene_.collapsed[b] && c.residual.norm() > options_.tolerance)
      c.collapsed = 0;
  }
  return any;
}

/// Updates the multipliers of bands of constant pull and zero length. @return whether one changed
bool NetDescent::update_multipliers() {
  bool changed = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    // Select short bands of constant pull.
    const NetBand& band = plan_.net.bands[b];
    const Vector3d d = here_.x[band.a] - here_.x[band.b];
    if (scene_.collapsed[b] || !is_regularised(scene_, b, d.norm())) continue;
    // Compute the force of the augmented Lagrangian.
    Vector3d p = scene_.multiplier[b] + scene_.penalty[b] * d;
    const double excess = p.norm() / scene_.pull[b];
    // Collapse the node into the exit if the force is below the pull.
    if (excess < 1 && collapse_to_exit(b)) {
      changed = true;
      continue;
    }
    // Limit a larger force to the pull; drop it if the band is no longer short.
    if (excess > 1) p /= excess;
    if (excess > 1 && d.norm() * scene_.penalty[b] > scene_.pull[b]) p.setZero();
    // Store that force as the next multiplier.
    if ((p - scene_.multiplier[b]).norm() < 0.1 * options_.tolerance) continue;
    scene_.multiplier[b] = p;
    changed = true;
  }
  return changed;
}

// Distinction of minima from saddles, and escape from saddles.

/// Returns whether the node positions are a minimum: positive curvature, up to rounding, in all
/// free directions.
bool NetDescent::is_minimum() {
  if (definite_ && largest_move_ < 1e-6) return true;
  reduce();
  return factor_.factorise(reduced_, options_.tolerance / kStiffnessDistance, 1e-9);
}

/// Leaves a saddle along a direction of negative curvature.
bool NetDescent::leave_saddle() {
  // Compute a direction of negative curvature, in world axes.
  if (!factor_.negative_direction(step_)) return false;
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = here_.contact[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  // Take the first step in either sense that lowers the energy.
  const double noise = 1e-14 * here_.E.size;
  for (double size = 1e-3; size > 1e-7; size *= 0.3)
    for (double way : {size, -size}) {
      if (!try_step(way / longest) || next_.E.energy > here_.E.energy - noise) continue;
      std::swap(here_, next_);
      return true;
    }
  return false;
}

/// Leaves a saddle before it is reached, since steps on a ridge shrink near it. @return whether it
/// did
bool NetDescent::leave_saddle_early() {
  if (definite_ || iterations_ == 0 || largest_move_ > 1e-6 || residual_ <= options_.tolerance)
    return false;
  reduce();
  if (factor_.factorise(reduced_, options_.tolerance / kStiffnessDistance, 1e-9) || !leave_saddle())
    return false;
  definite_ = true;
  return true;
}

// Report of an equilibrium.

namespace {

// Half angle about the half plane opposite to a band's side [rad]
constexpr double kCutAngle = 1e-6;
constexpr double kDrawnLength = 1e-9;  // length below which a pull has drawn its node in [m]

}  // namespace

/// Returns bands over cylinders with an end on the half plane opposite to their side, where their
/// length jumps.
std::vector<int> NetDescent::far_side_bands() const {
  std::vector<int> found;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    // Select cylinders: a sphere has no side.
    const RoundBone& bone = scene_.bone[b];
    if (plan_.net.bands[b].over < 0 || bone.sphere) continue;
    // Test for a free end behind the axis, near the half plane.
    const auto beyond = [&](int node) {
      const Vector3d p = here_.x[node] - bone.center;
      const double along = bone.e1.dot(p), across = bone.e2.dot(p);
      return plan_.net.nodes[node].free && along < 0 && std::abs(across) < -kCutAngle * along;
    };
    if (beyond(plan_.net.bands[b].a) || beyond(plan_.net.bands[b].b))
      found.push_back(static_cast<int>(b));
  }
  return found;
}

/// Reports length and tension of a band, and its force if its length is zero.
void NetDescent::report_band(int b, NetEquilibrium& out) const {
  const NetBand& band = plan_.net.bands[b];
  if (scene_.collapsed[b]) {
    const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
    // Divide the force among several pulls that meet in one exit.
    const double sign = plan_.bands[b].ka >= 0 ? -1 : 1;
    const Vector3d force = sign * scene_.pull[b] / here_.contact[k].collapsed * here_.E.g[k];
    out.collapsed.push_back({b, -force});
    out.length(b) = 0;
    out.tension(b) = force.norm();
    return;
  }
  // Report length and tension of an ordinary band.
  out.length(b) = here_.E.length[b];
  out.tension(b) = here_.E.tension[b];
  // Report the force of a short band of constant pull on its node.
  const double length = (here_.x[band.a] - here_.x[band.b]).norm();
  if (length > kDrawnLength || !is_regularised(scene_, b, length)) return;
  const BandState now = band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]);
  if (now.chord.bent) return;
  out.collapsed.push_back({b, -now.pull.tension * now.chord.slope.head<3>()});
  out.tension(b) = out.collapsed.back().force.norm();
}

/// Returns the floating nodes that no band determines. The residual leaves tensions of its own size
/// in bands among them.
std::vector<int> NetDescent::undetermined(const NetEquilibrium& at) const {
  // Residual over the tolerance of a chain of nodes, which accumulates their residuals [1]
  constexpr double kChainResidualRatio = 10;
  // Mark nodes held by a taut band, or in an exit.
  std::vector<bool> held(here_.x.size(), false);
  const auto hold = [&](int band) {
    const NetBand& holds = plan_.net.bands[band];
    held[holds.a] = held[holds.b] = true;
  };
  for (int b = 0; b < at.tension.size(); ++b)
    if (at.tension(b) > kChainResidualRatio * options_.tolerance) hold(b);
  for (const CollapsedBand& collapsed : at.collapsed) hold(collapsed.band);
  // Collect the remaining floating nodes.
  std::vector<int> found;
  for (std::size_t i = 0; i < here_.x.size(); ++i)
    if (plan_.row[i] >= 0 && !held[i]) found.push_back(static_cast<int>(i));
  return found;
}

NetEquilibrium NetDescent::report(NetStatus status) const {
  // Report the end of the search.
  NetEquilibrium out;
  out.status = status;
  out.residual = residual_;
  out.iterations = iterations_;
  out.evaluations = evaluations_;
  out.energy = here_.E.energy;
  out.pushed_out = pushed_out_;
  if (status == NetStatus::kStalled) out.far_side_bands = far_side_bands();
  if (!out.far_side_bands.empty()) out.status = NetStatus::kFarSideWrap;
  // Report nodes and bands.
  out.x.resize(3, static_cast<Eigen::Index>(here_.x.size()));
  for (Eigen::Index i = 0; i < out.x.cols(); ++i)
    out.x.col(i) = here_.x[static_cast<std::size_t>(i)];
  const int bands = static_cast<int>(plan_.bands.size());
  out.length.resize(bands);
  out.tension.resize(bands);
  for (int b = 0; b < bands; ++b) report_band(b, out);
  // Report a balance that depends on a collapsed node.
  if (status == NetStatus::kBalanced && !out.collapsed.empty())
    out.status = NetStatus::kNodeCollapsed;
  // Report contacts, without the rounding of bands that bend over the bone.
  for (int k = 0; k < rows(); ++k)
    for (int c = 0; c < here_.contact[k].pressed; ++c)
      out.contacts.push_back(
          {plan_.node[k], here_.contact[k].surface[c],
           here_.contact[k].force[c] -
               normal_rounding(k, here_.contact[k].surface[c], here_.contact[k].normal[c]),
           here_.contact[k].normal[c]});
  out.undetermined = undetermined(out);
  return out;
}

}  // namespace thenar::internal
