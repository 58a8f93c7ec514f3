#include "tendons/muscle/joint_resistance.h"

#include <algorithm>

#include "hand/passive_moment.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// Computes the excess of an angle over its limits, negative below the lower one, 0 within [rad].
double excess_angle(const CoordinateLimits& limits, double angle) {
  return angle - std::clamp(angle, limits.lower, limits.upper);
}

double limit_energy(const JointResistance& stop, double d) {
  const double toe = stop.toe, size = std::abs(d);
  if (size < toe) return stop.stiffness * size * size * size / (6 * toe);
  return stop.stiffness * (toe * toe / 6 + (size * size - size * toe) / 2);
}

}  // namespace

double stop_torque(const JointResistance& resistance, const CoordinateLimits& limits,
                   double angle) {
  const double d = excess_angle(limits, angle), size = std::abs(d);
  const double torque = size < resistance.toe
                            ? resistance.stiffness * size * size / (2 * resistance.toe)
                            : resistance.stiffness * (size - resistance.toe / 2);
  return d > 0 ? -torque : torque;
}

double stop_derivative(const JointResistance& resistance, const CoordinateLimits& limits,
                       double angle) {
  const double size = std::abs(excess_angle(limits, angle));
  return -resistance.stiffness * std::min(size / resistance.toe, 1.0);
}

VectorXd resistance_torque(const Skeleton& skeleton, const JointResistance& resistance,
                           const VectorXd& q) {
  VectorXd tau = passive_torque(skeleton, q);
  for (Eigen::Index i = 0; i < q.size(); ++i)
    tau[i] += stop_torque(resistance, skeleton.limits[i], q[i]);
  return tau;
}

VectorXd resistance_derivative(const Skeleton& skeleton, const JointResistance& resistance,
                               const VectorXd& q) {
  return VectorXd::NullaryExpr(q.size(), [&](Eigen::Index i) {
    const CoordinateLimits& limits = skeleton.limits[i];
    return passive_moment_slope(limits, q[i]) + stop_derivative(resistance, limits, q[i]);
  });
}

double resistance_energy(const Skeleton& skeleton, const JointResistance& resistance,
                         const VectorXd& q) {
  double energy = 0;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const CoordinateLimits& limits = skeleton.limits[i];
    energy += passive_energy(limits, q[i]) + limit_energy(resistance, excess_angle(limits, q[i]));
  }
  return energy;
}

VectorXd joint_damping(const Skeleton& skeleton, const JointResistance& resistance) {
  return VectorXd::NullaryExpr(skeleton.coordinates(), [&](Eigen::Index i) {
    const double own = skeleton.limits[i].damping;
    return own > 0 ? own : resistance.damping;
  });
}

}  // namespace thenar
