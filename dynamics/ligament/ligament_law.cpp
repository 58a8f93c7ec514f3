#include "dynamics/ligament/ligament_law.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {

LigamentForce capsule_force(const CapsuleLaw& law, double x) {
  const double k = law.stiffness, s = law.toe;
  if (!std::isfinite(s) || law.stiffening == 1) return {k * x, k, 0.5 * k * x * x};
  // Exponential part, up to the displacement where its stiffness is r k.
  const double end = s * std::acosh(law.stiffening), size = std::abs(x);
  const double inner = std::min(size, end), sinh = std::sinh(0.5 * inner / s);
  LigamentForce out;
  out.force = k * s * std::sinh(inner / s);
  out.slope = k * std::cosh(inner / s);
  out.energy = 2 * k * s * s * sinh * sinh;  // k s^2 (cosh(x / s) - 1), without cancellation
  // Linear part.
  const double beyond = size - inner;
  out.energy += beyond * (out.force + 0.5 * out.slope * beyond);
  out.force += out.slope * beyond;
  out.force = std::copysign(out.force, x);
  return out;
}

void check_law(const CapsuleLaw& law) {
  for (const double number : {law.stiffness, law.damping})
    require(number >= 0 && std::isfinite(number),
            "capsule: wanted stiffness and damping from 0 up, got {}", number);
  require(law.toe > 0, "capsule: wanted a toe region above 0, got {}", law.toe);
  require(law.stiffening >= 1 && std::isfinite(law.stiffening),
          "capsule: wanted a stiffening from 1 up, got {}", law.stiffening);
}

LigamentForce ligament_force(const LigamentLaw& law, double length) {
  const double e = (length - law.slack_length) / law.slack_length, toe = law.toe_strain;
  if (e <= 0) return {};
  // Toe region: force quadratic in strain.
  const double per_strain = law.stiffness / law.slack_length;
  if (e <= 2 * toe)
    return {law.stiffness * e * e / (4 * toe), per_strain * e / (2 * toe),
            law.stiffness * law.slack_length * e * e * e / (12 * toe)};
  // Linear part; at its beginning, e = 2 toe, the energy is  K L0 toe^2 2/3.
  const double straight = e - toe;
  return {law.stiffness * straight, per_strain,
          law.stiffness * law.slack_length *
              (2 * toe * toe / 3 + 0.5 * (straight * straight - toe * toe))};
}

void check_law(const LigamentLaw& law) {
  require(law.slack_length > 0 && std::isfinite(law.slack_length),
          "ligament: wanted a slack length above 0, got {} m", law.slack_length);
  require(law.toe_strain > 0 && std::isfinite(law.toe_strain),
          "ligament: wanted a toe strain above 0, got {}", law.toe_strain);
  for (const double number : {law.stiffness, law.damping})
    require(number >= 0 && std::isfinite(number),
            "ligament: wanted stiffness and damping from 0 up, got {}", number);
}

}  // namespace thenar
