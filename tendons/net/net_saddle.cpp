#include "tendons/net/net_descent.h"

#include <algorithm>

// Telling a minimum from a saddle, and leaving it.

namespace thenar::internal {

/// Whether no small move lowers E: positive curvature, but for rounding, in all free directions.
bool NetDescent::steady() {
  if (definite_ && longest_ < 1e-6) return true;
  reduce();
  return factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9);
}

/// Leaves a saddle along a direction of negative curvature.
bool NetDescent::escape() {
  if (!factor_.negative_direction(step_)) return false;
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = contact_[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  const double noise = 1e-14 * at_.size;
  for (double size = 1e-3; size > 1e-7; size *= 0.3)
    for (double way : {size, -size}) {
      double slope = 0;
      if (!try_step(way / longest, slope) || next_.energy > at_.energy - noise) continue;
      accept();
      return true;
    }
  return false;
}

/// Steps on a ridge shrink as they near a saddle: leaves it before. @return whether it did
bool NetDescent::leave_ridge() {
  if (definite_ || iterations_ == 0 || longest_ > 1e-6 || residual_ <= options_.tolerance)
    return false;
  reduce();
  if (factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9) || !escape()) return false;
  definite_ = true;
  return true;
}

}  // namespace thenar::internal
