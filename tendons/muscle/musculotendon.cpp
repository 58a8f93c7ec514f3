#include "tendons/muscle/musculotendon.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr double kMinProjection = 0.05,
                 kFadingProjection = 0.10;  // projected_fibre / optimal length: smallest, and where
                                            // shortening starts to fade [1]

/// Computes the cosine of the fibre's angle to the tendon.
double cosine(const Musculotendon& muscle, double projected_fibre) {
  return projected_fibre /
         std::hypot(projected_fibre, muscle.optimal_fibre_length * std::sin(muscle.pennation));
}

/// Computes d cosine / d projected_fibre [1/m].
double cosine_slope(const Musculotendon& muscle, double projected_fibre) {
  const double height = muscle.optimal_fibre_length * std::sin(muscle.pennation);
  const double fibre = std::hypot(projected_fibre, height);
  return height * height / (fibre * fibre * fibre);
}

/// Solves  strength fv(v) + beta v = force  for v.
double balancing_velocity(double strength, double beta, double force) {
  // Bracket the root: the left side is too large at 0 or force / beta, too small at -1 or force /
  // beta.
  double low = std::min(-1.0, force / beta), high = std::max(0.0, force / beta), v = 0;
  // Take Newton's step, or bisect where it leaves the bracket.
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
  // Compute the length that the tendon leaves to the fibre.
  const double projected_fibre = length - muscle.slack;
  if (projected_fibre <= 0) return 0;
  // Compute angle and speed of the fibre.
  const double l = normalised_fibre_length(muscle, projected_fibre),
               along = cosine(muscle, projected_fibre);
  const double v = velocity * along / (options.max_velocity * muscle.optimal_fibre_length);
  const double force = activation * active_force(l) * force_velocity(v) + passive_force(l);
  return std::max(0.0, muscle.F0 * (force + options.damping * v) * along);
}

TensionDerivatives rigid_tendon_derivatives(const Musculotendon& muscle, const HillOptions& options,
                                            double activation, double length, double velocity) {
  // Return zero where the tension is cut off.
  if (rigid_tendon_tension(muscle, options, activation, length, velocity) <= 0) return {};
  // Compute the fibre, its angle and its speed, with their derivatives.
  const double projected_fibre = length - muscle.slack;
  const double l = normalised_fibre_length(muscle, projected_fibre),
               along = cosine(muscle, projected_fibre);
  const double turn = cosine_slope(muscle, projected_fibre),
               top = options.max_velocity * muscle.optimal_fibre_length;
  const double v = velocity * along / top, fl = active_force(l), fv = force_velocity(v);

  // Differentiate F0 f cos:  dl = cos / optimal,  dv = velocity cos' / top  per projected_fibre.
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
  // Compute the fibre, of at least the smallest length, and the tendon's force on it.
  const double r = std::max(projected_fibre, kMinProjection * muscle.optimal_fibre_length);
  const double l = normalised_fibre_length(muscle, r), along = cosine(muscle, r);
  const double pull =
      tendon_force((length - projected_fibre) / muscle.slack, options.tendon_strain);
  // Solve for the velocity that balances fibre and tendon.
  const double v = balancing_velocity(activation * active_force(l), options.damping,
                                      pull / along - passive_force(l));
  const double rate = v * options.max_velocity * muscle.optimal_fibre_length / along;
  // Fade out shortening near the smallest length.
  const double fade = (projected_fibre / muscle.optimal_fibre_length - kMinProjection) /
                      (kFadingProjection - kMinProjection);
  return rate < 0 ? rate * std::clamp(fade, 0.0, 1.0) : rate;
}

FibreRateDerivatives fibre_rate_derivatives(const Musculotendon& muscle, const HillOptions& options,
                                            double activation, double length,
                                            double projected_fibre) {
  // Compute fibre, tendon and velocity as in projected_fibre_rate().
  const double shortest = kMinProjection * muscle.optimal_fibre_length,
               r = std::max(projected_fibre, shortest);
  const double moves = projected_fibre > shortest ? 1 : 0;  // dr / d projected_fibre
  const double l = normalised_fibre_length(muscle, r), along = cosine(muscle, r);
  const double turn = moves * cosine_slope(muscle, r),
               stretch = moves * along / muscle.optimal_fibre_length;
  const double tendon = (length - projected_fibre) / muscle.slack, fl = active_force(l);
  const double pull = tendon_force(tendon, options.tendon_strain);
  const double stiffness = tendon_force_derivative(tendon, options.tendon_strain) / muscle.slack;
  const double v =
      balancing_velocity(activation * fl, options.damping, pull / along - passive_force(l));

  // Differentiate  activation fl fv(v) + beta v = pull / along - fp.
  const double fv = force_velocity(v);
  const double resistance = activation * fl * force_velocity_derivative(v) + options.damping;
  const double v_a = -fl * fv / resistance, v_length = stiffness / along / resistance;
  const double v_reach =
      (-stiffness / along - pull * turn / (along * along) -
       (passive_force_derivative(l) + activation * active_force_derivative(l) * fv) * stretch) /
      resistance;

  // Differentiate  rate = v top / along,  faded where it shortens.
  const double top = options.max_velocity * muscle.optimal_fibre_length / along;
  const double ramp = (projected_fibre / muscle.optimal_fibre_length - kMinProjection) /
                      (kFadingProjection - kMinProjection);
  const bool fades = v < 0 && ramp < 1;
  const double fade = v < 0 ? std::clamp(ramp, 0.0, 1.0) : 1;
  const double fade_slope =
      fades && ramp > 0 ? 1 / (muscle.optimal_fibre_length * (kFadingProjection - kMinProjection))
                        : 0;
  return {fade * top * v_a, fade * top * v_length,
          fade * top * (v_reach - v * turn / along) + fade_slope * top * v};
}

double isometric_projected_fibre(const Musculotendon& muscle, const HillOptions& options,
                                 double activation, double length) {
  // Define the excess of the tendon's force over the fibre's.
  const auto excess = [&](double projected_fibre) {
    const double l = normalised_fibre_length(muscle, projected_fibre);
    return tendon_force((length - projected_fibre) / muscle.slack, options.tendon_strain) -
           cosine(muscle, projected_fibre) * (activation * active_force(l) + passive_force(l));
  };
  // Bracket the root between the shortest fibre and a slack tendon, then bisect.
  double low = kMinProjection * muscle.optimal_fibre_length;
  double high = length - taut_tendon(options.tendon_strain) * muscle.slack;
  if (high <= low || excess(low) < 0) return low;
  while (high - low > 1e-14 * muscle.optimal_fibre_length) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (excess(middle) >= 0 ? low : high) = middle;
  }
  return low;
}

ActivationRate activation_rate(double excitation, double activation, const ActivationTimes& times) {
  const double wanted = excitation - activation, speed = 0.5 + 1.5 * activation;
  if (wanted > 0) {
    const double inverse = 1 / (times.rise * speed), rate = wanted * inverse;
    return {rate, -(1 + 1.5 * times.rise * rate) * inverse};
  }
  return {wanted * speed / times.fall, (1.5 * wanted - speed) / times.fall};
}

}  // namespace thenar
