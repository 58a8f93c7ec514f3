#include "pad_laws/elastic_foundation.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Returns the mean distance over the mean radius of an ellipse under a pressure  (1 - s^2)^m:
///   int p s^2 ds / int p s ds = (m + 1) B(3/2, m + 1).
double arm_of_power(double m) {
  return (m + 1) * std::exp(std::lgamma(1.5) + std::lgamma(m + 1) - std::lgamma(m + 2.5));
}

}  // namespace

void check_foundation(const FoundationConstants& c) {
  require(c.modulus > 0 && c.exponent > 0 && std::isfinite(c.modulus + c.exponent),
          "a foundation needs a modulus and an exponent above 0, got {} Pa and {}", c.modulus,
          c.exponent);
  require(c.stiffening >= 0 && c.surround >= 0 && std::isfinite(c.stiffening + c.surround),
          "a foundation needs stiffening and surround of 0 or more, got {} and {}", c.stiffening,
          c.surround);
  require(c.spread >= 1 && std::isfinite(c.spread), "a foundation spreads by 1 or more, got {}",
          c.spread);
  require(c.thickness > 0 && c.shear >= 0 && std::isfinite(c.thickness + c.shear),
          "a foundation needs a thickness above 0 and shear of 0 or more, got {} m and {} Pa",
          c.thickness, c.shear);
}

SpringPressure spring_pressure(const FoundationConstants& c, double e) {
  if (e <= 0) return {};
  // Compute the pressure E e^m (1 + s e^2), its derivative and its integral over e.
  const double power = c.modulus * (c.exponent == 1 ? e : std::pow(e, c.exponent));
  const double stiff = c.stiffening * e * e, m = c.exponent;
  return {power * (1 + stiff), power / e * (m + (m + 2) * stiff),
          power * e * (1 / (m + 1) + stiff / (m + 3))};
}

ElasticFoundation::ElasticFoundation(const FoundationConstants& constants,
                                     std::vector<ExponentialTerm> terms)
    : c_(constants),
      share_(arm_of_power(constants.exponent)),
      share_stiff_(arm_of_power(constants.exponent + 2)),
      terms_(std::move(terms)) {
  check_foundation(c_);
  check_exponential_terms(terms_, "an elastic foundation");
}

LawContact ElasticFoundation::at_depth(const RelativeCurvatures& gap, double depth,
                                       double friction) const {
  const internal::GapRadius shape = internal::checked_gap(gap, depth, 0, friction);
  LawContact contact;
  contact.patch.depth = depth;
  if (depth <= 0) return contact;
  // Compute the area of the patch, which is proportional to depth: 2 pi R / spread times depth.
  const double e = depth / c_.thickness, ring = 2 * kPi * shape.radius / c_.spread;
  const SpringPressure spring = spring_pressure(c_, e);
  contact.area = ring * depth;
  const double mean = std::sqrt(contact.area / kPi), stretch = std::sqrt(std::sqrt(shape.ratio));
  // Add the share c h / r of the surrounding tissue, which decreases as the patch grows.
  const double around = c_.surround * c_.thickness / mean;
  const double plain = ring * c_.thickness * spring.energy;
  contact.force = plain * (1 + around);
  contact.stiffness = ring * spring.pressure * (1 + around) - plain * around / (2 * depth);
  // Compute the ellipse of this area with a / b = sqrt(k1 / k2).
  contact.patch.a = mean * stretch;
  contact.patch.b = mean / stretch;
  // Average the torsion shares of the powers m and m + 2, weighted by their parts of the force.
  const double m = c_.exponent;
  const double first = 1 / (m + 1), second = c_.stiffening * e * e / (m + 3);
  const double share = (share_ * first + share_stiff_ * second) / (first + second);
  contact.patch.torsion = share * friction * mean_radius(contact.patch.a, contact.patch.b);
  contact.shear = c_.shear * contact.area / c_.thickness;
  return contact;
}

LawContact ElasticFoundation::at_force(const RelativeCurvatures& gap, double force,
                                       double friction) const {
  const internal::GapRadius shape = internal::checked_gap(gap, 0, force, friction);
  if (force == 0) return {};
  // Solve log F as a function of x = log e by Newton's method, which decreases monotonically to the
  // root from a start above, because the function is convex.
  const double m = c_.exponent, ring = 2 * shape.radius * c_.thickness / c_.spread;
  const double unit = kPi * ring * c_.modulus;
  const double around = c_.surround * c_.thickness / std::sqrt(ring);  // at e = 1
  double x = std::log(force * (m + 1) / unit) / (m + 1);
  for (int k = 0; k < 100; ++k) {
    // Compute the error of log F and its slope at e = exp(x).
    const double root = std::exp(x / 2), part = around / root;
    const double stiff = c_.stiffening * root * root * root * root;
    const double sum = 1 / (m + 1) + stiff / (m + 3);
    const double wrong = std::log(unit / force * sum * (1 + part)) + (m + 1) * x;
    const double step = wrong / (m + 1 + 2 * stiff / (m + 3) / sum - 0.5 * part / (1 + part));
    x -= step;
    if (std::abs(step) < 1e-15 * (1 + std::abs(x))) break;
  }
  // Compute the contact at that depth, with exactly the requested force.
  LawContact contact = at_depth(gap, c_.thickness * std::exp(x), friction);
  contact.force = force;
  return contact;
}

}  // namespace thenar
