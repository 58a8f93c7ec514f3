#include "pad_laws/contact_law.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {

LawContact relaxed_contact(const ContactLaw& law, const RelativeCurvatures& gap, double depth,
                           double friction, const MemoryStep& weights, ExponentialMemory& memory) {
  // Add the history of earlier steps to the instantaneous force of the law.
  LawContact contact = law.at_depth(gap, depth, friction);
  const double history = history_of(weights, memory);
  const double force = weights.now * contact.force + history;
  if (force <= 0) {
    // Without contact, the elastic force takes the value that cancels the history.
    remember(weights, std::max(0.0, -history / weights.now), memory);
    return internal::no_contact(depth);
  }
  // In contact, set the force and stiffness of the step.
  remember(weights, contact.force, memory);
  contact.force = force;
  contact.stiffness *= weights.now;
  return contact;
}

namespace internal {

GapRadius radius_of(const RelativeCurvatures& gap) {
  require(std::isfinite(gap.k1) && gap.k1 >= gap.k2 && std::isfinite(gap.k2),
          "curvatures of a gap must be finite, the larger first, got {} and {} /m", gap.k1, gap.k2);
  // Bound the curvatures from below, because the laws do not describe flat faces.
  const double k1 = std::max(kFlattestGap, gap.k1), k2 = std::max(kFlattestGap, gap.k2);
  return {1 / std::sqrt(k1 * k2), k1 / k2};
}

GapRadius checked_gap(const RelativeCurvatures& gap, double depth, double force, double friction) {
  const GapRadius radius = radius_of(gap);
  require(std::isfinite(depth), "the depth of a contact must be finite, got {} m", depth);
  require(force >= 0 && friction >= 0 && std::isfinite(force + friction),
          "force and friction must be finite and >= 0, got {} N and {}", force, friction);
  return radius;
}

LawContact no_contact(double depth) {
  LawContact apart;
  apart.patch.depth = depth;
  return apart;
}

}  // namespace internal

}  // namespace thenar
