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

double elastic_tendon_tension(const Musculotendon& muscle, const HillOptions& options,
                              double length, double reach) {
  return muscle.F0 * tendon_force((length - reach) / muscle.slack, options.tendon_strain);
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
