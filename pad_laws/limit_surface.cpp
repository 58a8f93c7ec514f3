#include "pad_laws/limit_surface.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

// Rings of a patch, and points of each ring, over which friction is summed
constexpr int kPatchRings = 128, kPatchRays = 256;

double pressure_at(PatchPressure pressure, double cosine) {
  switch (pressure) {
    case PatchPressure::kUniform:
      return 1;
    case PatchPressure::kHertz:
      return cosine;
    case PatchPressure::kParaboloid:
      break;
  }
  return cosine * cosine;
}

/// Load over its limit [1]; infinite if there is a load and no limit.
double share(double load, double most) {
  if (load == 0) return 0;
  return most > 0 ? load / most : std::numeric_limits<double>::infinity();
}

}  // namespace

double limit_ellipsoid(const PatchFriction& load, double friction, double torsion) {
  require(friction >= 0 && torsion >= 0 && std::isfinite(friction + torsion),
          "friction and torsion must be finite and >= 0, got {} and {} m", friction, torsion);
  return std::hypot(share(load.f.norm(), friction), share(load.torque, torsion));
}

PatchFriction slip_friction(double a, double b, PatchPressure pressure, double friction,
                            const Eigen::Vector2d& centre) {
  require(a > 0 && b > 0 && friction >= 0 && std::isfinite(a + b + friction) && centre.allFinite(),
          "a patch must have positive semi-axes and friction >= 0, got {}, {} m and {}", a, b,
          friction);
  // s = sin(phi) makes the integrand smooth at the rim whatever the pressure.
  PatchFriction sum;
  double normal = 0;
  for (int i = 0; i < kPatchRings; ++i) {
    // Weight of a ring: its pressure times its area.
    const double phi = kPi / 2 * (i + 0.5) / kPatchRings, s = std::sin(phi);
    const double weight = pressure_at(pressure, std::cos(phi)) * s * std::cos(phi);
    normal += weight * kPatchRays;
    for (int k = 0; k < kPatchRays; ++k) {
      const double theta = 2 * kPi * (k + 0.5) / kPatchRays;
      const Eigen::Vector2d x(a * s * std::cos(theta), b * s * std::sin(theta));
      // Unit velocity of the point in a rotation about the centre; friction follows it.
      const Eigen::Vector2d r = x - centre;
      const double distance = r.norm();
      if (distance == 0) continue;
      const Eigen::Vector2d v(-r.y() / distance, r.x() / distance);
      sum.f += weight * v;
      sum.torque += weight * (x.x() * v.y() - x.y() * v.x());
    }
  }
  // Divide by the normal force.
  sum.f *= friction / normal;
  sum.torque *= friction / normal;
  return sum;
}

}  // namespace thenar
