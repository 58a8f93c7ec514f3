#include "tendons/net/net_descent.h"

#include <algorithm>
#include <limits>

// In which direction the nodes of a net go down, by Newton.

namespace thenar::internal {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// H - sum force curvature, turned so that pressed normals come first, and these pinned.
void NetDescent::reduce() {
  for (int k = 0; k < rows(); ++k) {
    const NodeContact& c = contact_[k];
    Matrix3d& D = reduced_.diagonal[k];
    D = c.Q * (at_.H.diagonal[k] - c.bend) * c.Q.transpose();
    double scale = at_.H.diagonal[k].trace();
    if (scale <= 0) scale = 1, D.setIdentity();  // nothing holds it: it stays
    for (int r = 0; r < c.pinned; ++r) {
      D.row(r).setZero();
      D.col(r).setZero();
      D(r, r) = scale;
    }
  }
  for (int s = 0; s < plan_.pattern.blocks(); ++s) {
    const auto [i, j] = plan_.pattern.rows_of(s);
    Matrix3d& B = reduced_.off[s];
    B = contact_[i].Q * at_.H.off[s] * contact_[j].Q.transpose();
    B.topRows(contact_[i].pinned).setZero();
    B.leftCols(contact_[j].pinned).setZero();
  }
}

/// Solves for the step. @return the longest move of a node [m]
double NetDescent::solve_step() {
  for (int k = 0; k < rows(); ++k) {
    step_[k] = -(contact_[k].Q * at_.g[k]);
    step_[k].head(contact_[k].pinned).setZero();
  }
  factor_.solve(step_);
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = contact_[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  return longest;
}

/// Newton's step, shifted where the stiffness is not positive definite or the step leaves the
/// radius within which the last steps were good.
bool NetDescent::direction() {
  reduce();
  definite_ = factor_.factorise(reduced_, 0);
  longest_ = std::numeric_limits<double>::infinity();
  if (definite_ || factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9))
    longest_ = solve_step();
  for (double shift = 0.1 * residual_ / radius_; longest_ > radius_; shift *= 4) {
    if (!(shift < 1e30)) return false;
    if (factor_.factorise(reduced_, shift)) longest_ = solve_step();
  }
  return true;
}

/// After a step too long: bands that it stretches get the stiffness that they show over it, slack
/// ones too, so that the next direction knows them. @return whether there were any
bool NetDescent::look_ahead() {
  bool any = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    const double more = next_.tension[b] - at_.tension[b], dL = next_.length[b] - at_.length[b];
    if (scene_.pull[b] >= 0 || !(more > 0) || !(dL > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
    const double k = more / dL - now.pull.stiffness;
    if (!(k > 1e-3 * now.pull.stiffness)) continue;
    const Vector3d ua = now.chord.slope.head<3>(), ub = now.chord.slope.tail<3>();
    if (at.ka >= 0) at_.H.diagonal[at.ka] += k * ua * ua.transpose();
    if (at.kb >= 0) at_.H.diagonal[at.kb] += k * ub * ub.transpose();
    if (at.slot >= 0)
      at_.H.off[at.slot] += at.flip ? k * ub * ua.transpose() : k * ua * ub.transpose();
    any = true;
  }
  return any;
}

}  // namespace thenar::internal
