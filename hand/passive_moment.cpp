#include "hand/passive_moment.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"

namespace thenar {
namespace {

/// Computes the moment of one end at a rotation x towards it [N m].
double end_moment(const PassiveEnd& end, double x) {
  const double s = x / end.width, curved = std::min(s, kMaxExponent);
  return end.moment * (std::expm1(curved) + std::exp(curved) * (s - curved));
}

/// Computes d end_moment / dx [N m/rad].
double end_slope(const PassiveEnd& end, double x) {
  return end.moment / end.width * std::exp(std::min(x / end.width, kMaxExponent));
}

/// Computes the integral of end_moment from 0 to x [J].
double end_energy(const PassiveEnd& end, double x) {
  const double s = x / end.width, curved = std::min(s, kMaxExponent), past = s - curved;
  return end.moment * end.width *
         (std::expm1(curved) - curved + past * (std::expm1(curved) + std::exp(curved) * past / 2));
}

}  // namespace

double passive_moment(const CoordinateLimits& limits, double q) {
  double moment = -limits.stiffness * (q - limits.rest);
  for (const PassiveHinge& hinge : limits.ends) {
    const double x = hinge.ratio * q + hinge.offset - hinge.rest;
    moment += hinge.ratio * (end_moment(hinge.extending, -x) - end_moment(hinge.flexing, x));
  }
  return moment;
}

double passive_moment_slope(const CoordinateLimits& limits, double q) {
  double slope = -limits.stiffness;
  for (const PassiveHinge& hinge : limits.ends) {
    const double x = hinge.ratio * q + hinge.offset - hinge.rest;
    slope -=
        hinge.ratio * hinge.ratio * (end_slope(hinge.extending, -x) + end_slope(hinge.flexing, x));
  }
  return slope;
}

double passive_energy(const CoordinateLimits& limits, double q) {
  const double stretch = q - limits.rest;
  double energy = limits.stiffness * stretch * stretch / 2;
  for (const PassiveHinge& hinge : limits.ends) {
    const double x = hinge.ratio * q + hinge.offset - hinge.rest;
    energy += end_energy(hinge.extending, -x) + end_energy(hinge.flexing, x);
  }
  return energy;
}

bool has_passive(const Skeleton& skeleton) {
  return any_of(skeleton.limits, [](const CoordinateLimits& each) {
    return each.stiffness > 0 || !each.ends.empty();
  });
}

}  // namespace thenar
