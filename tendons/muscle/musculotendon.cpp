#include "tendons/muscle/musculotendon.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr double kLeastProjection = 0.05,
                 kFadingProjection = 0.10;  // projected_fibre / optimal [1]

/// Cosine of the fibre's angle to the tendon.
double cosine(const Musculotendon& muscle, double projected_fibre) {
  return projected_fibre /
         std::hypot(projected_fibre, muscle.optimal_fibre_length * std::sin(muscle.pennation));
}

/// d cosine / d projected_fibre [1/m].
double cosine_slope(const Musculotendon& muscle, double projected_fibre) {
  const double height = muscle.optimal_fibre_length * std::sin(muscle.pennation);
  const double fibre = std::hypot(projected_fibre, height);
  return height * height / (fibre * fibre * fibre);
}

/// The v of  strength fv(v) + beta v = force.
double balancing_velocity(double strength, double beta, double force) {
  // At 0 or force / beta the left side is too large, at -1 or force / beta too small.
  double low = std::min(-1.0, force / beta), high = std::max(0.0, force / beta), v = 0;
  // Newton's step, or bisection where it leaves the bracket.
  for (int i = 0; i < 100 && high - low > 1e-15 * (1 + high - low); ++i) {
    const double excess = strength * force_velocity(v) + beta * v - force;
    (excess > 0 ? high : low) = v;
    const double newton = v - excess / (strength * force_velocity_derivative(v) + beta);
    if (newton == v) break;
    v = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return v;
}

}  // namespace

double musculotendon_length_at_optimum(const Musculotendon& muscle) {
  return muscle.slack + muscle.optimal_fibre_length * std::cos(muscle.pennation);
}

double normalised_fibre_length(const Musculotendon& muscle, double projected_fibre) {
  return std::hypot(projected_fibre / muscle.optimal_fibre_length, std::sin(muscle.pennation));
}

double rigid_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                            double activation, double length, double velocity) {
  // The fibre is as long as the tendon leaves it.
  const double projected_fibre = length - muscle.slack;
  if (projected_fibre <= 0) return 0;
  // Angle and speed of the fibre.
  const double l = normalised_fibre_length(muscle, projected_fibre),
               along = cosine(muscle, projected_fibre);
  const double v = velocity * along / (options.max_velocity * muscle.optimal_fibre_length);
  const double force = activation * active_force(l) * force_velocity(v) + passive_force(l);
  return std::max(0.0, muscle.F0 * (force + options.damping * v) * along);
}

TensionDerivatives rigid_tendon_derivatives(const Musculotendon& muscle, const HillOptions& options,
                                            double activation, double length, double velocity) {
  // No derivatives where the tension is cut off.
  if (rigid_tendon_tension(muscle, options, activation, length, velocity) <= 0) return {};
  // The fibre, its angle and its speed, with their derivatives.
  const double projected_fibre = length - muscle.slack;
  const double l = normalised_fibre_length(muscle, projected_fibre),
               along = cosine(muscle, projected_fibre);
  const double turn = cosine_slope(muscle, projected_fibre),
               top = options.max_velocity * muscle.optimal_fibre_length;
  const double v = velocity * along / top, fl = active_force(l), fv = force_velocity(v);

  // force is F0 f cos;  l grows by cos / optimal a projected_fibre, v by velocity cos' / top
  const double f = activation * fl * fv + passive_force(l) + options.damping * v;
  const double f_l = activation * active_force_derivative(l) * fv + passive_force_derivative(l);
  const double f_v = activation * fl * force_velocity_derivative(v) + options.damping;
  const double by_length =
      (f_l * along / muscle.optimal_fibre_length + f_v * velocity * turn / top) * along + f * turn;
  return {muscle.F0 * fl * fv * along, muscle.F0 * by_length, muscle.F0 * f_v * along * along / top,
          0};
}

double elastic_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                              double length, double projected_fibre) {
  return muscle.F0 * tendon_force((length - projected_fibre) / muscle.slack, options.tendon_strain);
}

TensionDerivatives elastic_tendon_derivatives(const Musculotendon& muscle,
                                              const HillOptions& options, double length,
                                              double projected_fibre) {
  const double stiffness =
      muscle.F0 / muscle.slack *
      tendon_force_derivative((length - projected_fibre) / muscle.slack, options.tendon_strain);
  return {0, stiffness, 0, -stiffness};
}

double projected_fibre_rate(const Musculotendon& muscle, const HillOptions& options,
                            double activation, double length, double projected_fibre) {
  // Fibre of at least the shortest length, and the tendon's force on it.
  const double r = std::max(projected_fibre, kLeastProjection * muscle.optimal_fibre_length);
  const double l = normalised_fibre_length(muscle, r), along = cosine(muscle, r);
  const double pull =
      tendon_force((length - projected_fibre) / muscle.slack, options.tendon_strain);
  // Velocity that balances fibre and tendon.
  const double v = balancing_velocity(activation * active_force(l), options.damping,
                                      pull / along - passive_force(l));
  const double rate = v * options.max_velocity * muscle.optimal_fibre_length / along;
  // Shortening fades out near the shortest length.
  const double fade = (projected_fibre / muscle.optimal_fibre_length - kLeastProjection) /
                      (kFadingProjection - kLeastProjection);
  return rate < 0 ? rate * std::clamp(fade, 0.0, 1.0) : rate;
}

FibreRateDerivatives fibre_rate_derivatives(const Musculotendon& muscle, const HillOptions& options,
                                            double activation, double length,
                                            double projected_fibre) {
  // Fibre, tendon and velocity, as in projected_fibre_rate().
  const double shortest = kLeastProjection * muscle.optimal_fibre_length,
               r = std::max(projected_fibre, shortest);
  const double moves = projected_fibre > shortest ? 1 : 0;  // of r with the projected_fibre
  const double l = normalised_fibre_length(muscle, r), along = cosine(muscle, r);
  const double turn = moves * cosine_slope(muscle, r),
               stretch = moves * along / muscle.optimal_fibre_length;
  const double tendon = (length - projected_fibre) / muscle.slack, fl = active_force(l);
  const double pull = tendon_force(tendon, options.tendon_strain);
  const double stiffness = tendon_force_derivative(tendon, options.tendon_strain) / muscle.slack;
  const double v =
      balancing_velocity(activation * fl, options.damping, pull / along - passive_force(l));

  // activation fl fv(v) + beta v = pull / along - fp  differentiated
  const double fv = force_velocity(v);
  const double grip = activation * fl * force_velocity_derivative(v) + options.damping;
  const double v_a = -fl * fv / grip, v_length = stiffness / along / grip;
  const double v_reach =
      (-stiffness / along - pull * turn / (along * along) -
       (passive_force_derivative(l) + activation * active_force_derivative(l) * fv) * stretch) /
      grip;

  // rate = v top / along, faded where it shortens
  const double top = options.max_velocity * muscle.optimal_fibre_length / along;
  const double ramp = (projected_fibre / muscle.optimal_fibre_length - kLeastProjection) /
                      (kFadingProjection - kLeastProjection);
  const bool fades = v < 0 && ramp < 1;
  const double fade = v < 0 ? std::clamp(ramp, 0.0, 1.0) : 1;
  const double thins =
      fades && ramp > 0 ? 1 / (muscle.optimal_fibre_length * (kFadingProjection - kLeastProjection))
                        : 0;
  return {fade * top * v_a, fade * top * v_length,
          fade * top * (v_reach - v * turn / along) + thins * top * v};
}

double isometric_projected_fibre(const Musculotendon& muscle, const HillOptions& options,
                                 double activation, double length) {
  // Force of the tendon above that of the fibre.
  const auto excess = [&](double projected_fibre) {
    const double l = normalised_fibre_length(muscle, projected_fibre);
    return tendon_force((length - projected_fibre) / muscle.slack, options.tendon_strain) -
           cosine(muscle, projected_fibre) * (activation * active_force(l) + passive_force(l));
  };
  // Bracket between the shortest fibre and a slack tendon; then bisection.
  double low = kLeastProjection * muscle.optimal_fibre_length;
  double high = length - taut_tendon(options.tendon_strain) * muscle.slack;
  if (high <= low || excess(low) < 0) return low;
  while (high - low > 1e-14 * muscle.optimal_fibre_length) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (excess(middle) >= 0 ? low : high) = middle;
  }
  return low;
}

ActivationRate activation_rate_with_slope(double excitation, double activation,
                                          const ActivationTimes& times) {
  const double wanted = excitation - activation, speed = 0.5 + 1.5 * activation;
  if (wanted > 0) {
    const double inverse = 1 / (times.rise * speed), rate = wanted * inverse;
    return {rate, -(1 + 1.5 * times.rise * rate) * inverse};
  }
  return {wanted * speed / times.fall, (1.5 * wanted - speed) / times.fall};
}

double activation_rate(double excitation, double activation, const ActivationTimes& times) {
  return activation_rate_with_slope(excitation, activation, times).rate;
}

double activation_rate_derivative(double excitation, double activation,
                                  const ActivationTimes& times) {
  return activation_rate_with_slope(excitation, activation, times).by_activation;
}

}  // namespace thenar
