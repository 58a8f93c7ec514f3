#pragma once

/// Constants near those of the default pad, for tests of pads in motion.

#include <vector>

#include "pad_laws/exponential_memory.h"
#include "pad_laws/foundation_bed.h"
#include "pad_laws/point_laws.h"

namespace thenar::sample {

/// Three relaxation times of published size.
inline const std::vector<ExponentialTerm> kTerms{{0.3, 0.004}, {0.25, 0.07}, {0.2, 1.4}};

inline SoftFingerConstants soft_finger_constants() {
  return {0.36, 1.79, 0.82, 5.7e-3, 0.32, 0.29, 0.61, 0.54, 8e3};
}

inline FoundationConstants foundation_constants() {
  FoundationConstants c;
  c.modulus = 37e3;
  c.exponent = 0.98;
  c.stiffening = 2.6;
  c.surround = 0.58;
  c.spread = 1.25;
  c.thickness = 5.5e-3;
  c.shear = 12e3;
  return c;
}

}  // namespace thenar::sample
