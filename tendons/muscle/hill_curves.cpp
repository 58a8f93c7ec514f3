#include "tendons/muscle/hill_curves.h"

#include <algorithm>
#include <cmath>

#include "tendons/muscle/exponentials.h"

namespace thenar {
namespace {

/// Bell curve  height exp(-(l - center)^2 / (2 (width + widening l)^2)).
struct Bell {
  double height, center, width, widening;
};
// Supplement of [DeGroote2016], table of the active curve; the height of the first follows from
// active_force(1) = 1.
constexpr Bell kBell1{1, 1.055, 0.162, 0.063};
constexpr Bell kBell2{0.433, 0.717, -0.030, 0.200};
constexpr Bell kBell3{0.100, 1.000, 0.354, 0.000};
// Length up to which the second bell is 0; its width vanishes there [1]
constexpr double kSecondBellStart = 0.15;

// Length above which the passive force may overflow, while exponentials() stay finite [1]
constexpr double kOverflowLength = 100;

/// Computes the exponent of a bell, and its derivative by length.
void set_exponent(double l, const Bell& bell, double& exponent, double& slope) {
  const double inverse = 1 / (bell.width + bell.widening * l), x = (l - bell.center) * inverse;
  exponent = -x * x / 2;
  slope = -x * (1 - bell.widening * x) * inverse;
}

double value_of(double l, const Bell& bell) {
  const double x = (l - bell.center) / (bell.width + bell.widening * l);
  return bell.height * std::exp(-x * x / 2);
}

double slope_of(double l, const Bell& bell) {
  const double spread = bell.width + bell.widening * l, x = (l - bell.center) / spread;
  return bell.height * (-x * (1 - bell.widening * x) / spread * std::exp(-x * x / 2));
}
const double kB11 = (1 - value_of(1, kBell2) - value_of(1, kBell3)) / value_of(1, kBell1);
constexpr double kPassiveSteepness = 4 / 0.6;  // Steepness of the passive force [1]
const double kPassive = std::expm1(4.0), kPerPassive = 1 / kPassive;

// d1 and d4 from force_velocity(-1) = 0 and force_velocity(0) = 1.
constexpr double kD2 = -8.149, kD3 = -0.374;
const double kD1 = 1 / (std::asinh(kD3) - std::asinh(kD3 - kD2));
const double kD4 = 1 - kD1 * std::asinh(kD3);

}  // namespace

double active_force(double length) {
  const double second = length > kSecondBellStart ? value_of(length, kBell2) : 0;
  return kB11 * value_of(length, kBell1) + second + value_of(length, kBell3);
}

double active_force_derivative(double length) {
  const double second = length > kSecondBellStart ? slope_of(length, kBell2) : 0;
  return kB11 * slope_of(length, kBell1) + second + slope_of(length, kBell3);
}

double force_velocity(double velocity) { return kD1 * std::asinh(kD2 * velocity + kD3) + kD4; }

double force_velocity_derivative(double velocity) {
  return kD1 * kD2 / std::hypot(kD2 * velocity + kD3, 1);
}

double passive_force(double length) {
  return std::max(0.0, std::expm1(4 * (length - 1) / 0.6) / kPassive);
}

double passive_force_derivative(double length) {
  if (length < 1) return 0;
  return 4 / 0.6 * std::exp(4 * (length - 1) / 0.6) / kPassive;
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

double tendon_energy(double length, double strain) {
  const double more = length - taut_tendon(strain), steep = 35 * kTendonStrain / strain;
  return more > 0 ? 0.25 * (std::expm1(steep * more) / steep - more) : 0;
}

double taut_tendon(double strain) {
  return 1 + (std::log(0.25 / 0.2) / 35 - 0.005) * strain / kTendonStrain;
}

void set_length_forces(const Eigen::VectorXd& length, LengthForces& out) {
  const Eigen::Index n = length.size();
  for (Eigen::VectorXd* each : {&out.active, &out.active_slope, &out.passive, &out.passive_slope})
    each->resize(n);
  // Compute exponents of the three bells and of the passive force, and slopes of the former.
  out.workspace.resize(7 * n);
  double* const e1 = out.workspace.data();
  double *const e2 = e1 + n, *const e3 = e2 + n, *const e4 = e3 + n;
  double *const g1 = e4 + n, *const g2 = g1 + n, *const g3 = g2 + n;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double l = length[i];
    set_exponent(l, kBell1, e1[i], g1[i]);
    set_exponent(l, kBell2, e2[i], g2[i]);
    set_exponent(l, kBell3, e3[i], g3[i]);
    e4[i] = kPassiveSteepness * (l - 1);
  }
  exponentials(out.workspace.head(4 * n));
  // Evaluate the curves as in the functions above.
  for (Eigen::Index i = 0; i < n; ++i) {
    const double l = length[i];
    const double b1 = kB11 * e1[i], b2 = l > kSecondBellStart ? kBell2.height * e2[i] : 0,
                 b3 = kBell3.height * e3[i];
    out.active[i] = b1 + b2 + b3;
    out.active_slope[i] = g1[i] * b1 + (l > kSecondBellStart ? g2[i] * b2 : 0) + g3[i] * b3;
    out.passive[i] = std::max(0.0, (e4[i] - 1) * kPerPassive);
    out.passive_slope[i] = l < 1 ? 0 : kPassiveSteepness * kPerPassive * e4[i];
    if (l < kOverflowLength) continue;
    out.passive[i] = passive_force(l);
    out.passive_slope[i] = passive_force_derivative(l);
  }
}

void set_speed_forces(const Eigen::VectorXd& velocity, SpeedForces& out) {
  const Eigen::Index n = velocity.size();
  out.force.resize(n);
  out.slope.resize(n);
  // Evaluate asinh(x) = log(|x| + hypot(x, 1)) with the sign of x.
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = kD2 * velocity[i] + kD3, root = std::sqrt(x * x + 1);
    out.force[i] = kD1 * std::copysign(std::log(std::abs(x) + root), x) + kD4;
    out.slope[i] = kD1 * kD2 / root;
  }
}

}  // namespace thenar
