#include "tendons/muscle/hill_curves.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

double bell(double l, double center, double width, double widening) {
  const double x = (l - center) / (width + widening * l);
  return std::exp(-x * x / 2);
}

/// d bell / d length.
double bell_slope(double l, double center, double width, double widening) {
  const double spread = width + widening * l, x = (l - center) / spread;
  return -x * (1 - widening * x) / spread * std::exp(-x * x / 2);
}

// Supplement of [DeGroote2016], table of the active curve; b11 from active_force(1) = 1.
double bell_1(double l) { return bell(l, 1.055, 0.162, 0.063); }
double bell_2(double l) { return 0.433 * bell(l, 0.717, -0.030, 0.200); }
double bell_3(double l) { return 0.100 * bell(l, 1.000, 0.354, 0.000); }
double slope_1(double l) { return bell_slope(l, 1.055, 0.162, 0.063); }
double slope_2(double l) { return 0.433 * bell_slope(l, 0.717, -0.030, 0.200); }
double slope_3(double l) { return 0.100 * bell_slope(l, 1.000, 0.354, 0.000); }
const double kB11 = (1 - bell_2(1) - bell_3(1)) / bell_1(1);

// d1 and d4 from force_velocity(-1) = 0 and force_velocity(0) = 1.
constexpr double kD2 = -8.149, kD3 = -0.374;
const double kD1 = 1 / (std::asinh(kD3) - std::asinh(kD3 - kD2));
const double kD4 = 1 - kD1 * std::asinh(kD3);

}  // namespace

double active_force(double length) {
  // The second bell has no width at 0.15: it is 0 up to there.
  const double second = length > 0.15 ? bell_2(length) : 0;
  return kB11 * bell_1(length) + second + bell_3(length);
}

double active_force_derivative(double length) {
  const double second = length > 0.15 ? slope_2(length) : 0;
  return kB11 * slope_1(length) + second + slope_3(length);
}

double force_velocity(double velocity) { return kD1 * std::asinh(kD2 * velocity + kD3) + kD4; }

double force_velocity_derivative(double velocity) {
  return kD1 * kD2 / std::hypot(kD2 * velocity + kD3, 1);
}

double passive_force(double length) {
  return std::max(0.0, std::expm1(4 * (length - 1) / 0.6) / std::expm1(4.0));
}

double passive_force_derivative(double length) {
  if (length < 1) return 0;
  return 4 / 0.6 * std::exp(4 * (length - 1) / 0.6) / std::expm1(4.0);
}

double tendon_force(double length, double strain) {
  const double published = (length - 1) * kTendonStrain / strain;
  return std::max(0.0, 0.2 * std::exp(35 * (published + 0.005)) - 0.25);
}

double tendon_force_derivative(double length, double strain) {
  if (length < taut_tendon(strain)) return 0;
  const double published = (length - 1) * kTendonStrain / strain;
  return 7 * kTendonStrain / strain * std::exp(35 * (published + 0.005));
}

double taut_tendon(double strain) {
  return 1 + (std::log(0.25 / 0.2) / 35 - 0.005) * strain / kTendonStrain;
}

}  // namespace thenar
