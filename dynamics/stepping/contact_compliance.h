#pragma once

/// Parameters of compliant contacts: springs and dampers in place of constraints.

#include <array>

#include "base/enum_names.h"

namespace thenar {

/// Regularised Coulomb friction: force over mu times the normal force at a slip speed u, with
/// s = u / transition. Such contacts creep instead of sticking.
enum class FrictionRamp {
  kQuintic,  // 10 s^3 - 15 s^4 + 6 s^5 up to s = 1, then 1: as Simbody [Sherman2011]
  kLinear    // s up to s = 1, then 1
};
inline constexpr std::array kFrictionRampNames{EnumName{FrictionRamp::kQuintic, "quintic"},
                                               EnumName{FrictionRamp::kLinear, "linear"}};

/// Laws of compliant contact: normal force at the penetration d of two bodies and its rate d',
///   balls on balls and on boxes  (4/3) modulus sqrt(R) d^1.5 (1 + 1.5 dissipation d')
///   every point of other shapes  stiffness d (1 + dissipation d')
/// with R the radius of the ball, or r1 r2 / (r1 + r2) of two balls. Forces never attract. The
/// first law is Hertz's, [Johnson1985] section 4.2, the factors of d' are from [HuntCrossley1975];
/// the coefficient of restitution is  1 - dissipation * speed  for slow impacts.
struct ContactCompliance {
  double modulus = 1e8;      // effective modulus (1/E1' + 1/E2')^-1 in plane strain; 0: balls obey
                             // the second law, too [Pa]
  double stiffness = 1e6;    // stiffness of a contact point of other shapes [N/m]
  double dissipation = 1;    // dissipation coefficient of both laws [s/m]
  double layer = 5e-3;       // elastic layer of Simbody's meshes: pressure = modulus d / layer [m]
  double transition = 1e-3;  // slip speed from which friction is Coulomb's [m/s]; for the dry
                             // friction of hinges [rad/s]
  double stop = 1e4;         // stiffness of joint limits, by the second law [N m/rad] or [N/m]
  FrictionRamp ramp = FrictionRamp::kQuintic;
};

}  // namespace thenar
