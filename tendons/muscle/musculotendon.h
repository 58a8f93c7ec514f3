#pragma once

/// Hill's model of one muscle with its tendon, rigid or elastic.
///
/// The muscle has constant thickness: a fibre at an angle to the tendon keeps its height above it,
///   fibre sin(angle) = optimal_fibre_length sin(pennation),   projected_fibre = fibre cos(angle).
/// Muscle and tendon together, the musculotendon unit, have the length
///   length = tendon + projected_fibre.
/// Forces balance along the tendon:
///   tension = F0 (a fl(l) fv(v) + fp(l) + beta v) cos(angle),
///   l = fibre / optimal_fibre_length,
///   v = (d fibre / d time) / (max_velocity optimal_fibre_length), positive as the fibre lengthens.
/// The damper beta keeps v finite where a fl = 0.
/// Source: [Millard2013] for the model, [DeGroote2016] for the curves (hill_curves.h).

#include <string>

#include "tendons/muscle/hill_curves.h"

namespace thenar {

/// Constants of one muscle.
struct Musculotendon {
  std::string name;
  double F0 = 0;  // maximum isometric force along the fibres, fully active at optimal length [N]
  double optimal_fibre_length = 0;  // [m]
  double slack = 0;                 // slack length: length of the tendon without force [m]
  double pennation = 0;             // angle of the fibre at its optimal length [rad]
};

/// Constants that all muscles share.
struct HillOptions {
  /// Largest speed of shortening [optimal fibre lengths/s]; [DeGroote2016].
  double max_velocity = 10;
  double damping = 0.1;                  // damper beta [1]; [Millard2013]
  double tendon_strain = kTendonStrain;  // strain of a tendon that carries F0 [1]
};

/// Computes the length of muscle and tendon at which the fibre has its optimal length and the
/// tendon its slack length [m].
[[nodiscard]] double musculotendon_length_at_optimum(const Musculotendon& muscle);

/// Computes fibre length over optimal fibre length [1].
/// @param projected_fibre  length of the fibre along the tendon [m]
[[nodiscard]] double normalised_fibre_length(const Musculotendon& muscle, double projected_fibre);

/// Computes the tension with a rigid tendon, whose length is `slack`; 0 where the fibre would push,
/// or where muscle and tendon are shorter than the tendon.
/// @param activation  0..1 [1]
/// @param length      length of muscle and tendon [m]
/// @param velocity    rate of `length`, lengthening positive [m/s]
/// @return [N]
[[nodiscard]] double rigid_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                                          double activation, double length, double velocity);

/// Partial derivatives of a tension; 0 where the tension is cut off at 0.
struct TensionDerivatives {
  double by_activation = 0;       // [N]
  double by_length = 0;           // [N/m]
  double by_velocity = 0;         // [N s/m]
  double by_projected_fibre = 0;  // [N/m]
};

/// Computes the partial derivatives of rigid_tendon_tension(), with the same arguments;
/// by_projected_fibre is 0.
[[nodiscard]] TensionDerivatives rigid_tendon_derivatives(const Musculotendon& muscle,
                                                          const HillOptions& options,
                                                          double activation, double length,
                                                          double velocity);

/// Computes the tension of an elastic tendon of length  length - projected_fibre.
/// @param length           length of muscle and tendon [m]
/// @param projected_fibre  length of the fibre along the tendon [m]
/// @return [N]
[[nodiscard]] double elastic_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                                            double length, double projected_fibre);

/// Computes the partial derivatives of elastic_tendon_tension(), with the same arguments.
[[nodiscard]] TensionDerivatives elastic_tendon_derivatives(const Musculotendon& muscle,
                                                            const HillOptions& options,
                                                            double length, double projected_fibre);

/// Computes the rate of projected_fibre at which the forces of fibre and tendon balance: the unique
/// root of an increasing function. Shortening fades out where projected_fibre falls below a tenth
/// of the optimal fibre length, since fibres with a slack tendon would shorten to zero length;
/// without pennation the factor fl of the active force is below 0.004 there.
/// @return [m/s]
[[nodiscard]] double projected_fibre_rate(const Musculotendon& muscle, const HillOptions& options,
                                          double activation, double length, double projected_fibre);

/// Partial derivatives of projected_fibre_rate().
struct FibreRateDerivatives {
  double by_activation = 0;       // [m/s]
  double by_length = 0;           // [1/s]
  double by_projected_fibre = 0;  // [1/s]
};

/// Computes the partial derivatives of projected_fibre_rate(), with the same arguments, by the
/// implicit function theorem.
[[nodiscard]] FibreRateDerivatives fibre_rate_derivatives(const Musculotendon& muscle,
                                                          const HillOptions& options,
                                                          double activation, double length,
                                                          double projected_fibre);

/// Computes the projected_fibre at which the forces of fibre and tendon balance at zero velocity,
/// at any activation. If the tendon is slack: the one at which it is just taut, or a twentieth of
/// the optimal fibre length if even this is too long [m].
[[nodiscard]] double isometric_projected_fibre(const Musculotendon& muscle,
                                               const HillOptions& options, double activation,
                                               double length);

// Activation dynamics.

/// Time constants of activation, of young adults. Source: [Thelen2003].
struct ActivationTimes {
  double rise = 0.015;  // time constant of rising activation [s]
  double fall = 0.050;  // time constant of falling activation [s]
};

/// Rate of activation with its derivative.
struct ActivationRate {
  double rate = 0;           // [1/s]
  double by_activation = 0;  // [1/s]; at a = e, where the rate has a corner, of the branch of
                             // falling activation
};
/// Computes the rate of activation a under excitation e:
///   a' = (e - a) / (rise (0.5 + 1.5 a))   where e > a,
///   a' = (e - a) (0.5 + 1.5 a) / fall     elsewhere.
/// Keeps a within the range of e, so within 0..1. Source: [Thelen2003].
[[nodiscard]] ActivationRate activation_rate(double excitation, double activation,
                                             const ActivationTimes& times);

}  // namespace thenar
