#include "pad_laws/soft_patch.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/spatial.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Returns the factor c of patch_torsion(),  int p(s) s^2 ds / int p(s) s ds  [1].
double share_of(PatchPressure pressure) {
  if (pressure == PatchPressure::kUniform) return 2.0 / 3;
  return pressure == PatchPressure::kHertz ? 3 * kPi / 16 : 8.0 / 15;
}

void require_load(double force, double friction) {
  require(force >= 0 && friction >= 0 && std::isfinite(force + friction),
          "force and friction must be finite and >= 0, got {} N and {}", force, friction);
}

}  // namespace

double mean_radius(double a, double b) {
  require(a >= 0 && b >= 0 && std::isfinite(a + b), "semi-axes must be finite and >= 0, got {}, {}",
          a, b);
  const double longer = std::max(a, b), shorter = std::min(a, b);
  if (longer == 0) return 0;
  // Compute the perimeter over 2 pi, with e^2 = 1 - ratio^2 written without cancellation.
  const double ratio = shorter / longer;
  return 2 / kPi * longer * std::comp_ellint_2(std::sqrt((1 - ratio) * (1 + ratio)));
}

double patch_torsion(double a, double b, PatchPressure pressure, double friction) {
  require_load(0, friction);
  return share_of(pressure) * friction * mean_radius(a, b);
}

SoftPatch winkler_patch(double force, double young, double thickness, double R1, double R2,
                        double friction) {
  require_load(force, friction);
  require(
      young > 0 && thickness > 0 && R1 > 0 && R2 > 0 && std::isfinite(young + thickness + R1 + R2),
      "a soft layer must have positive modulus, thickness and radii, got {} Pa, {}, {} and {} m",
      young, thickness, R1, R2);
  // Compute the depth at which the paraboloid of pressure balances the force.
  SoftPatch patch;
  patch.depth = std::sqrt(force * thickness / (young * kPi * std::sqrt(R1 * R2)));
  patch.a = std::sqrt(2 * patch.depth * R1);
  patch.b = std::sqrt(2 * patch.depth * R2);
  patch.torsion = patch_torsion(patch.a, patch.b, PatchPressure::kParaboloid, friction);
  return patch;
}

SoftPatch hertz_patch(double force, double modulus, double radius, double friction) {
  require_load(force, friction);
  require(modulus > 0 && radius > 0 && std::isfinite(modulus + radius),
          "modulus and radius must be positive and finite, got {} Pa and {} m", modulus, radius);
  SoftPatch patch;
  patch.a = patch.b = std::cbrt(3 * force * radius / (4 * modulus));
  patch.depth = patch.a * patch.a / radius;
  patch.torsion = patch_torsion(patch.a, patch.b, PatchPressure::kHertz, friction);
  return patch;
}

double contact_modulus(double E_a, double nu_a, double E_b, double nu_b) {
  require(E_a > 0 && E_b > 0 && std::isfinite(std::min(E_a, E_b)),
          "Young's moduli must be positive and one finite, got {} and {} Pa", E_a, E_b);
  require(std::min(nu_a, nu_b) >= 0 && std::max(nu_a, nu_b) <= 0.5,
          "Poisson's ratios must be in [0, 1/2], got {} and {}", nu_a, nu_b);
  return 1 / ((1 - nu_a * nu_a) / E_a + (1 - nu_b * nu_b) / E_b);
}

double confined_modulus(double young, double nu) {
  require(young > 0 && std::isfinite(young), "Young's modulus must be positive, got {} Pa", young);
  require(nu >= 0 && nu < 0.5, "Poisson's ratio of a confined layer must be in [0, 1/2), got {}",
          nu);
  return young * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
}

SoftPatch power_law_patch(double force, double c, double gamma, double friction) {
  require_load(force, friction);
  require(c >= 0 && std::isfinite(c), "c must be finite and >= 0, got {} m", c);
  require(gamma >= 0 && gamma <= 1.0 / 3, "gamma must be in [0, 1/3], got {}", gamma);
  SoftPatch patch;
  patch.a = patch.b = c * std::pow(force, gamma);
  patch.torsion = patch_torsion(patch.a, patch.b, PatchPressure::kHertz, friction);
  return patch;
}

PressureMoments pressure_moments(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& forces,
                                 const Eigen::Vector3d& normal) {
  PressureMoments out;
  out.force = forces.sum();
  if (!(out.force > 0)) return out;
  out.centre = points * forces / out.force;
  // Sum the mean arm and the second moments of the forces perpendicular to the direction.
  const Tangents t = tangents(normal);
  double xx = 0, xy = 0, yy = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d from = points.col(i) - out.centre;
    const double x = t.e1.dot(from), y = t.e2.dot(from), f = forces[i];
    out.arm += f * std::sqrt(x * x + y * y);
    xx += f * x * x;
    xy += f * x * y;
    yy += f * y * y;
  }
  out.arm /= out.force;
  // Compute the principal second moments; the aspect of a line or a point stays 1.
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  if (mean - half > 1e-12 * mean) out.aspect = std::sqrt((mean + half) / (mean - half));
  return out;
}

}  // namespace thenar
