#pragma once

/// Compliance of contacts that are springs rather than constraints.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"

namespace thenar {

/// Share of Coulomb's largest force that a contact gives at a slip speed u, s = u / transition:
/// friction that is never at rest.
enum class FrictionRamp {
  kQuintic,  // 10 s^3 - 15 s^4 + 6 s^5, then 1: that of Simbody [Sherman2011]
  kLinear    // s, then 1
};
inline constexpr std::array kFrictionRampNames{EnumName{FrictionRamp::kQuintic, "quintic"},
                                               EnumName{FrictionRamp::kLinear, "linear"}};

/// Laws of compliant contact, in terms of a depth d of two bodies and its rate d':
///   balls on balls and on boxes  (4/3) modulus sqrt(R) d^1.5 (1 + 1.5 dissipation d')
///   every point of other shapes  stiffness d (1 + dissipation d')
/// with R the radius of the ball, or r1 r2 / (r1 + r2) of two. Nothing pulls. The first is Hertz's,
/// [Johnson1985] section 4.2, the factors of d' are [HuntCrossley1975]'s; the coefficient of
/// restitution is  1 - dissipation * speed  for slow impacts.
struct ContactCompliance {
  double modulus = 1e8;      // effective, (1/E1' + 1/E2')^-1 of plane strain; 0: balls obey the
                             // second law, too [Pa]
  double stiffness = 1e6;    // of a point of contact of other shapes [N/m]
  double dissipation = 1;    // [s/m]
  double layer = 5e-3;       // Simbody's triangle meshes: pressure = modulus d / layer [m]
  double transition = 1e-3;  // slip speed from which friction is Coulomb's [m/s]; of the dry
                             // friction of hinges [rad/s]
  double stop = 1e4;         // stiffness of joint limits, by the second law [N m/rad] or [N/m]
  FrictionRamp ramp = FrictionRamp::kQuintic;
};

}  // namespace thenar
