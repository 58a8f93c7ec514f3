#include "tendons/muscle/musculotendon.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr double kShortest = 0.05, kFading = 0.10;  // reach / optimal [1]

/// Cosine of the fibre's angle to the tendon.
double cosine(const Musculotendon& muscle, double reach) {
  return reach / std::hypot(reach, muscle.optimal * std::sin(muscle.pennation));
}

/// d cosine / d reach [1/m].
double cosine_slope(const Musculotendon& muscle, double reach) {
  const double height = muscle.optimal * std::sin(muscle.pennation);
  const double fibre = std::hypot(reach, height);
  return height * height / (fibre * fibre * fibre);
}

/// The v of  strength fv(v) + beta v = force.
double balancing_velocity(double strength, double beta, double force) {
  // At 0 or force / beta the left side is too large, at -1 or force / beta too small.
  double low = std::min(-1.0, force / beta), high = std::max(0.0, force / beta), v = 0;
  for (int i = 0; i < 100 && high - low > 1e-15 * (1 + high - low); ++i) {
    const double excess = strength * force_velocity(v) + beta * v - force;
    (excess > 0 ? high : low) = v;
    const double newton = v - excess / (strength * force_velocity_slope(v) + beta);
    if (newton == v) break;
    v = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return v;
}

}  // namespace

double optimal_length(const Musculotendon& muscle) {
  return muscle.slack + muscle.optimal * std::cos(muscle.pennation);
}

double fibre_length(const Musculotendon& muscle, double reach) {
  return std::hypot(reach / muscle.optimal, std::sin(muscle.pennation));
}

double rigid_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                            double activation, double length, double velocity) {
  const double reach = length - muscle.slack;
  if (reach <= 0) return 0;
  const double l = fibre_length(muscle, reach), along = cosine(muscle, reach);
  const double v = velocity * along / (options.max_velocity * muscle.optimal);
  const double force = activation * active_force(l) * force_velocity(v) + passive_force(l);
  return std::max(0.0, muscle.F0 * (force + options.damping * v) * along);
}

TensionSlopes rigid_tendon_slopes(const Musculotendon& muscle, const HillOptions& options,
                                  double activation, double length, double velocity) {
  if (rigid_tendon_tension(muscle, options, activation, length, velocity) <= 0) return {};
  const double reach = length - muscle.slack;
  const double l = fibre_length(muscle, reach), along = cosine(muscle, reach);
  const double turn = cosine_slope(muscle, reach), top = options.max_velocity * muscle.optimal;
  const double v = velocity * along / top, fl = active_force(l), fv = force_velocity(v);

  // force is F0 f cos;  l grows by cos / optimal a reach, v by velocity cos' / top
  const double f = activation * fl * fv + passive_force(l) + options.damping * v;
  const double f_l = activation * active_force_slope(l) * fv + passive_force_slope(l);
  const double f_v = activation * fl * force_velocity_slope(v) + options.damping;
  const double by_length =
      (f_l * along / muscle.optimal + f_v * velocity * turn / top) * along + f * turn;
  return {muscle.F0 * fl * fv * along, muscle.F0 * by_length, muscle.F0 * f_v * along * along / top,
          0};
}

double elastic_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                              double length, double reach) {
  return muscle.F0 * tendon_force((length - reach) / muscle.slack, options.tendon_strain);
}

TensionSlopes elastic_tendon_slopes(const Musculotendon& muscle, const HillOptions& options,
                                    double length, double reach) {
  const double stiffness =
      muscle.F0 / muscle.slack *
      tendon_force_slope((length - reach) / muscle.slack, options.tendon_strain);
  return {0, stiffness, 0, -stiffness};
}

double reach_rate(const Musculotendon& muscle, const HillOptions& options, double activation,
                  double length, double reach) {
  const double r = std::max(reach, kShortest * muscle.optimal);
  const double l = fibre_length(muscle, r), along = cosine(muscle, r);
  const double pull = tendon_force((length - reach) / muscle.slack, options.tendon_strain);
  const double v = balancing_velocity(activation * active_force(l), options.damping,
                                      pull / along - passive_force(l));
  const double rate = v * options.max_velocity * muscle.optimal / along;
  const double fade = (reach / muscle.optimal - kShortest) / (kFading - kShortest);
  return rate < 0 ? rate * std::clamp(fade, 0.0, 1.0) : rate;
}

ReachRateSlopes reach_rate_slopes(const Musculotendon& muscle, const HillOptions& options,
                                  double activation, double length, double reach) {
  const double shortest = kShortest * muscle.optimal, r = std::max(reach, shortest);
  const double moves = reach > shortest ? 1 : 0;  // of r with the reach
  const double l = fibre_length(muscle, r), along = cosine(muscle, r);
  const double turn = moves * cosine_slope(muscle, r), stretch = moves * along / muscle.optimal;
  const double tendon = (length - reach) / muscle.slack, fl = active_force(l);
  const double pull = tendon_force(tendon, options.tendon_strain);
  const double stiffness = tendon_force_slope(tendon, options.tendon_strain) / muscle.slack;
  const double v =
      balancing_velocity(activation * fl, options.damping, pull / along - passive_force(l));

  // activation fl fv(v) + beta v = pull / along - fp  differentiated
  const double fv = force_velocity(v);
  const double grip = activation * fl * force_velocity_slope(v) + options.damping;
  const double v_a = -fl * fv / grip, v_length = stiffness / along / grip;
  const double v_reach =
      (-stiffness / along - pull * turn / (along * along) -
       (passive_force_slope(l) + activation * active_force_slope(l) * fv) * stretch) /
      grip;

  // rate = v top / along, faded where it shortens
  const double top = options.max_velocity * muscle.optimal / along;
  const double ramp = (reach / muscle.optimal - kShortest) / (kFading - kShortest);
  const bool fades = v < 0 && ramp < 1;
  const double fade = v < 0 ? std::clamp(ramp, 0.0, 1.0) : 1;
  const double thins = fades && ramp > 0 ? 1 / (muscle.optimal * (kFading - kShortest)) : 0;
  return {fade * top * v_a, fade * top * v_length,
          fade * top * (v_reach - v * turn / along) + thins * top * v};
}

double reach_at_rest(const Musculotendon& muscle, const HillOptions& options, double activation,
                     double length) {
  const auto excess = [&](double reach) {
    const double l = fibre_length(muscle, reach);
    return tendon_force((length - reach) / muscle.slack, options.tendon_strain) -
           cosine(muscle, reach) * (activation * active_force(l) + passive_force(l));
  };
  double low = kShortest * muscle.optimal;
  double high = length - taut_tendon(options.tendon_strain) * muscle.slack;
  if (high <= low || excess(low) < 0) return low;
  while (high - low > 1e-14 * muscle.optimal) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (excess(middle) >= 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace thenar
