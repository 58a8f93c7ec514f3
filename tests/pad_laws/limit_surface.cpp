#include "tests/pad_laws/limit_surface.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"

namespace thenar {
namespace {

// Number of rings of a patch, and of points of each ring, over which friction is summed
constexpr int kPatchRings = 128, kPatchRays = 256;

double pressure_at(PatchPressure pressure, double cosine) {
  if (pressure == PatchPressure::kUniform) return 1;
  return pressure == PatchPressure::kHertz ? cosine : cosine * cosine;
}

/// Returns a load over its limit [1]; infinite for a load with a limit of 0.
double load_share(double load, double limit) {
  if (load == 0) return 0;
  return limit > 0 ? load / limit : kInfinity;
}

}  // namespace

double limit_ellipsoid(const PatchFriction& load, double friction, double torsion) {
  require(friction >= 0 && torsion >= 0 && std::isfinite(friction + torsion),
          "friction and torsion must be finite and >= 0, got {} and {} m", friction, torsion);
  return std::hypot(load_share(load.f.norm(), friction), load_share(load.torque, torsion));
}

PatchFriction slip_friction(double a, double b, PatchPressure pressure, double friction,
                            const Eigen::Vector2d& centre) {
  require(a > 0 && b > 0 && friction >= 0 && std::isfinite(a + b + friction) && centre.allFinite(),
          "a patch must have positive semi-axes and friction >= 0, got {}, {} m and {}", a, b,
          friction);
  // Integrate in s = sin(phi), which makes the integrand smooth at the rim for any pressure.
  PatchFriction sum;
  double normal = 0;
  for (int i = 0; i < kPatchRings; ++i) {
    // Weight the ring by its pressure and area.
    const double phi = kPi / 2 * (i + 0.5) / kPatchRings, s = std::sin(phi);
    const double weight = pressure_at(pressure, std::cos(phi)) * s * std::cos(phi);
    normal += weight * kPatchRays;
    for (int k = 0; k < kPatchRays; ++k) {
      const double theta = 2 * kPi * (k + 0.5) / kPatchRays;
      const Eigen::Vector2d x(a * s * std::cos(theta), b * s * std::sin(theta));
      // Add friction along the unit velocity of the point in the rotation about the centre.
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
