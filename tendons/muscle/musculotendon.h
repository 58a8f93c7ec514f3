#pragma once

/// One muscle with its tendon: numbers, and Hill's model with a rigid and with an elastic tendon.
///
/// The fibre lies at an angle to the tendon and keeps its height over it, optimal sin(pennation);
/// its other leg, along the tendon, is its projected_fibre. The tendon goes on from there:
///   length = tendon + projected_fibre.
/// Forces balance along the tendon:
///   tension = F0 (a fl(l) fv(v) + fp(l) + beta v) cos(angle),   l = fibre / optimal,
/// v = rate of the fibre / (max_velocity optimal). The damper beta keeps v finite where a fl = 0.
/// Source: [Millard2013] for the model, [DeGroote2016] for the curves (hill_curves.h).

#include <string>

#include "tendons/muscle/hill_curves.h"

namespace thenar {

/// Constants of one muscle.
struct Musculotendon {
  std::string name;
  double F0 = 0;         // largest tension [N]
  double optimal = 0;    // length of the fibre [m]
  double slack = 0;      // length of the tendon without force [m]
  double pennation = 0;  // angle of the fibre at its optimal length [rad]
};

/// What all muscles have in common.
struct HillOptions {
  double max_velocity = 10;              // of shortening [optimal lengths/s]; [DeGroote2016]
  double damping = 0.1;                  // beta [1]; [Millard2013]
  double tendon_strain = kTendonStrain;  // at F0 [1]
};

/// Length of muscle and tendon where the fibre is optimal and the tendon just slack [m].
[[nodiscard]] double optimal_length(const Musculotendon& muscle);

/// Length of a fibre of this projected_fibre over its optimal length [1].
[[nodiscard]] double fibre_length(const Musculotendon& muscle, double projected_fibre);

/// Tension with a tendon that is always `slack` long; 0 where the fibre would push, or where muscle
/// and tendon are shorter than the tendon.
/// @param activation  0..1 [1]
/// @param length      of muscle and tendon [m]
/// @param velocity    its rate [m/s]
/// @return [N]
[[nodiscard]] double rigid_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                                          double activation, double length, double velocity);

/// Slopes of a tension; 0 where it is cut off.
struct TensionDerivatives {
  double by_activation = 0;  // [N]
  double by_length = 0;      // [N/m]
  double by_velocity = 0;    // [N s/m]
  double by_fibre = 0;       // [N/m]
};

/// Of rigid_tendon_tension(), whose arguments they are.
[[nodiscard]] TensionDerivatives rigid_tendon_derivatives(const Musculotendon& muscle,
                                                          const HillOptions& options,
                                                          double activation, double length,
                                                          double velocity);

/// Tension of an elastic tendon beside a fibre of this projected_fibre [m].
/// @return [N]
[[nodiscard]] double elastic_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                                            double length, double projected_fibre);

/// Of elastic_tendon_tension(), whose arguments they are.
[[nodiscard]] TensionDerivatives elastic_tendon_derivatives(const Musculotendon& muscle,
                                                            const HillOptions& options,
                                                            double length, double projected_fibre);

/// Rate of the projected_fibre at which forces balance: the root of an increasing function, so
/// there is one. Shortening fades out where the projected_fibre falls below a tenth of the optimal
/// length: fibres beside a slack tendon would go on to nothing, and there a fl is below 0.004.
/// @return [m/s]
[[nodiscard]] double projected_fibre_rate(const Musculotendon& muscle, const HillOptions& options,
                                          double activation, double length, double projected_fibre);

/// Slopes of a rate of the projected_fibre.
struct FibreRateDerivatives {
  double by_activation = 0;  // [m/s]
  double by_length = 0;      // [1/s]
  double by_fibre = 0;       // [1/s]
};

/// Of projected_fibre_rate(), whose arguments they are; by the implicit function theorem.
[[nodiscard]] FibreRateDerivatives fibre_rate_derivatives(const Musculotendon& muscle,
                                                          const HillOptions& options,
                                                          double activation, double length,
                                                          double projected_fibre);

/// The projected_fibre at which forces balance at rest; with a slack tendon, that at which it is
/// just taut, or a twentieth of the optimal length if even this is too long [m].
[[nodiscard]] double projected_fibre_at_rest(const Musculotendon& muscle,
                                             const HillOptions& options, double activation,
                                             double length);

// How fast a muscle follows its excitation.

/// Time constants of activation, of young adults. Source: [Thelen2003].
struct ActivationTimes {
  double rise = 0.015;  // [s]
  double fall = 0.050;  // [s]
};

/// Rate of activation a under excitation e:
///   a' = (e - a) / (rise (0.5 + 1.5 a))   where e > a,
///   a' = (e - a) (0.5 + 1.5 a) / fall     elsewhere.
/// Keeps a within the range of e, so within 0..1. Source: [Thelen2003].
/// @return [1/s]
[[nodiscard]] double activation_rate(double excitation, double activation,
                                     const ActivationTimes& times);

/// d activation_rate / d activation [1/s]; at a = e, where it has a corner, that of falling.
[[nodiscard]] double activation_rate_derivative(double excitation, double activation,
                                                const ActivationTimes& times);

}  // namespace thenar
