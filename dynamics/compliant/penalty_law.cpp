#include "dynamics/compliant/penalty_law.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {

NormalLoad linear_normal_load(double stiffness, double dissipation, double depth, double rate) {
  if (!(depth > 0)) return {};
  const double spring = stiffness * depth;
  return {std::max(0.0, spring * (1 + dissipation * rate)), 0.5 * spring * depth};
}

NormalLoad hertz_normal_load(double modulus, double radius, double dissipation, double depth,
                             double rate) {
  if (!(depth > 0)) return {};
  const double spring = 4.0 / 3 * modulus * std::sqrt(radius * depth) * depth;
  return {std::max(0.0, spring * (1 + 1.5 * dissipation * rate)), 0.4 * spring * depth};
}

double friction_ratio(FrictionRamp ramp, double s) {
  if (s >= 1) return 1;
  return ramp == FrictionRamp::kLinear ? s : s * s * s * (10 + s * (6 * s - 15));
}

TangentialLoad friction_load(const ContactCompliance& compliance, const PairFriction& pair,
                             double normal_force, const Eigen::Vector3d& slip, double spin) {
  const double spin_speed = pair.torsion_radius * spin;
  const double speed = std::hypot(slip.norm(), spin_speed);
  const double max_friction = pair.coefficient * normal_force;
  if (!(speed > 0) || !(max_friction > 0)) return {};
  const double scale =
      -max_friction * friction_ratio(compliance.ramp, speed / compliance.transition) / speed;
  return {scale * slip, scale * spin_speed * pair.torsion_radius};
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
