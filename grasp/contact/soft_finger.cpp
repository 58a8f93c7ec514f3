#include "grasp/contact/soft_finger.h"

#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace thenar {

SoftPatch winkler_patch(double force, double young, double thickness, double R1, double R2,
                        double friction) {
  require(force >= 0 && friction >= 0 && std::isfinite(force + friction),
          "force and friction must be finite and >= 0, got {} N and {}", force, friction);
  require(
      young > 0 && thickness > 0 && R1 > 0 && R2 > 0 && std::isfinite(young + thickness + R1 + R2),
      "a soft layer must have positive modulus, thickness and radii, got {} Pa, {}, {} and {} m",
      young, thickness, R1, R2);
  SoftPatch patch;
  patch.depth = std::sqrt(force * thickness / (young * kPi * std::sqrt(R1 * R2)));
  patch.a = std::sqrt(2 * patch.depth * R1);
  patch.b = std::sqrt(2 * patch.depth * R2);
  patch.torsion = 8.0 / 15 * friction * std::sqrt(patch.a * patch.b);
  return patch;
}

SoftPatch power_law_patch(double force, double c, double gamma, double friction) {
  require(force >= 0 && friction >= 0 && c >= 0 && std::isfinite(force + friction + c),
          "force, friction and c must be finite and >= 0, got {} N, {} and {} m", force, friction,
          c);
  require(gamma >= 0 && gamma <= 1.0 / 3, "gamma must be in [0, 1/3], got {}", gamma);
  SoftPatch patch;
  patch.a = patch.b = c * std::pow(force, gamma);
  patch.torsion = 3 * kPi / 16 * friction * patch.a;
  return patch;
}

}  // namespace thenar
