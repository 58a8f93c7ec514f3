#pragma once

/// Creep of a contact whose friction rises over a range of speeds, for closed forms of motions.

#include <algorithm>

#include "dynamics/compliant/penalty_law.h"

namespace thenar::closed_form {

/// Returns the creep speed of a contact under a given friction, over the transition speed [1]: the
/// inverse of friction_ratio().
/// @param ratio  friction over its largest value, 0..1
inline double creep_speed(FrictionRamp ramp, double ratio) {
  if (ramp == FrictionRamp::kLinear) return std::clamp(ratio, 0.0, 1.0);
  // Invert the increasing quintic by bisection.
  constexpr int kBisections = 60;  // enough for the precision of a double
  double low = 0, high = 1;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (friction_ratio(ramp, middle) < ratio ? low : high) = middle;
  }
  return high;
}

}  // namespace thenar::closed_form
