#include "dynamics/compliant/penalty_law.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {

NormalLoad linear_load(double stiffness, double dissipation, double depth, double rate) {
  if (!(depth > 0)) return {};
  const double spring = stiffness * depth;
  return {std::max(0.0, spring * (1 + dissipation * rate)), 0.5 * spring * depth};
}

NormalLoad hertz_load(double modulus, double radius, double dissipation, double depth,
                      double rate) {
  if (!(depth > 0)) return {};
  const double spring = 4.0 / 3 * modulus * std::sqrt(radius * depth) * depth;
  return {std::max(0.0, spring * (1 + 1.5 * dissipation * rate)), 0.4 * spring * depth};
}

double friction_share(FrictionRamp ramp, double s) {
  if (s >= 1) return 1;
  return ramp == FrictionRamp::kLinear ? s : s * s * s * (10 + s * (6 * s - 15));
}

double creep_speed(FrictionRamp ramp, double share) {
  if (ramp == FrictionRamp::kLinear) return std::clamp(share, 0.0, 1.0);
  // The quintic rises, so halving finds its inverse to rounding.
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (friction_share(ramp, middle) < share ? low : high) = middle;
  }
  return high;
}

TangentialLoad friction_load(const ContactCompliance& compliance, const PairFriction& pair,
                             double normal_force, const Eigen::Vector3d& slip, double spin) {
  // Share of  mu normal  by the ramp, against slip and spin together.
  const double turning = pair.torsion_radius * spin;
  const double speed = std::hypot(slip.norm(), turning);
  const double most = pair.coefficient * normal_force;
  if (!(speed > 0) || !(most > 0)) return {};
  const double scale =
      -most * friction_share(compliance.ramp, speed / compliance.transition) / speed;
  return {scale * slip, scale * turning * pair.torsion_radius};
}

void check_compliance(const ContactCompliance& compliance) {
  for (const double number : {compliance.modulus, compliance.dissipation})
    require(number >= 0 && std::isfinite(number),
            "wanted a modulus and a dissipation of contacts from 0 up, got {}", number);
  for (const double number :
       {compliance.stiffness, compliance.layer, compliance.transition, compliance.stop})
    require(number > 0 && std::isfinite(number),
            "wanted stiffness, layer, transition speed and stops of contacts above 0, got {}",
            number);
}

}  // namespace thenar
