#include "pad_laws/point_laws.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Returns the tangential stiffness of a sticking circle on an incompressible half space, nu = 1/2
/// [N/m].
double shear_of(double modulus, double radius) { return 16.0 / 3 * modulus * radius; }

void check_powers(double force, double depth_exponent, double patch, double patch_exponent,
                  double torsion, double shear) {
  require(shear >= 0 && std::isfinite(shear), "the shear of a law must be 0 or more, got {} Pa",
          shear);
  require(force > 0 && depth_exponent > 0 && std::isfinite(force + depth_exponent),
          "a law of force needs a force and an exponent above 0, got {} N and {}", force,
          depth_exponent);
  require(patch >= 0 && patch_exponent >= 0 && std::isfinite(patch + patch_exponent),
          "a law of a patch needs a radius and an exponent of 0 and more, got {} m and {}", patch,
          patch_exponent);
  require(torsion >= 0 && torsion <= 1, "the share of torsion must be in [0, 1], got {}", torsion);
}

}  // namespace

LawContact HardPoint::at_depth(const RelativeCurvatures& gap, double depth, double friction) const {
  (void)internal::checked_gap(gap, depth, 0, friction);
  // A rigid point has no force up to depth 0, infinite stiffness there, and infinite force beyond.
  LawContact contact = internal::no_contact(depth);
  if (depth >= 0) contact.stiffness = contact.shear = kInfinity;
  if (depth > 0) contact.force = kInfinity;
  return contact;
}

LawContact HardPoint::at_force(const RelativeCurvatures& gap, double force, double friction) const {
  (void)internal::checked_gap(gap, 0, force, friction);
  LawContact contact;
  contact.force = force;
  contact.stiffness = contact.shear = kInfinity;
  return contact;
}

PowerLaw::PowerLaw(const PowerLawConstants& constants, std::vector<ExponentialTerm> terms)
    : c_(constants), terms_(std::move(terms)) {
  check_powers(c_.force, c_.depth_exponent, c_.patch, c_.patch_exponent, c_.torsion, c_.shear);
  require(c_.patch_exponent <= 1.0 / 3, "gamma must be in [0, 1/3], got {}", c_.patch_exponent);
  check_exponential_terms(terms_, "a power law");
}

LawContact PowerLaw::answer(double depth, double force, double friction) const {
  LawContact contact;
  // Stiffness dF / d depth = n F / depth.
  contact.force = force;
  contact.stiffness = depth > 0 ? c_.depth_exponent * force / depth : 0;
  // Compute the circular patch a = c F^gamma, whose radius determines torsion and shear.
  contact.patch.a = contact.patch.b = c_.patch * std::pow(force, c_.patch_exponent);
  contact.patch.depth = depth;
  contact.patch.torsion = c_.torsion * friction * contact.patch.a;
  contact.area = kPi * contact.patch.a * contact.patch.a;
  contact.shear = shear_of(c_.shear, contact.patch.a);
  return contact;
}

LawContact PowerLaw::at_depth(const RelativeCurvatures& gap, double depth, double friction) const {
  (void)internal::checked_gap(gap, depth, 0, friction);
  if (depth <= 0) return internal::no_contact(depth);
  return answer(depth, c_.force * std::pow(depth / kLawDepth, c_.depth_exponent), friction);
}

LawContact PowerLaw::at_force(const RelativeCurvatures& gap, double force, double friction) const {
  (void)internal::checked_gap(gap, 0, force, friction);
  if (force == 0) return {};
  return answer(kLawDepth * std::pow(force / c_.force, 1 / c_.depth_exponent), force, friction);
}

SoftFinger::SoftFinger(const SoftFingerConstants& constants, std::vector<ExponentialTerm> terms)
    : c_(constants), terms_(std::move(terms)) {
  check_powers(c_.force, c_.depth_exponent, c_.patch, c_.patch_exponent, c_.torsion, c_.shear);
  require(std::isfinite(c_.radius_exponent + c_.patch_radius + c_.aspect),
          "exponents of a soft finger must be finite, got {}, {} and {}", c_.radius_exponent,
          c_.patch_radius, c_.aspect);
  check_exponential_terms(terms_, "a soft finger");
}

LawContact SoftFinger::answer(const internal::GapRadius& gap, double depth, double force,
                              double friction) const {
  LawContact contact;
  // Stiffness dF / d depth = n F / depth.
  contact.force = force;
  contact.stiffness = depth > 0 ? c_.depth_exponent * force / depth : 0;
  // Compute the mean radius sqrt(a b) from force and radius of the gap, and a / b = (k1 / k2)^e.
  const double mean = c_.patch * std::pow(force, c_.patch_exponent) *
                      std::pow(gap.radius / kLawRadius, c_.patch_radius);
  const double stretch = std::pow(gap.ratio, c_.aspect / 2);
  contact.patch = {mean * stretch, mean / stretch, depth, 0};
  // Compute torsion and shear of this ellipse.
  contact.patch.torsion = c_.torsion * friction * mean_radius(contact.patch.a, contact.patch.b);
  contact.area = kPi * mean * mean;
  contact.shear = shear_of(c_.shear, mean);
  return contact;
}

LawContact SoftFinger::at_depth(const RelativeCurvatures& gap, double depth,
                                double friction) const {
  const internal::GapRadius shape = internal::checked_gap(gap, depth, 0, friction);
  if (depth <= 0) return internal::no_contact(depth);
  const double force = c_.force * std::pow(depth / kLawDepth, c_.depth_exponent) *
                       std::pow(shape.radius / kLawRadius, c_.radius_exponent);
  return answer(shape, depth, force, friction);
}

LawContact SoftFinger::at_force(const RelativeCurvatures& gap, double force,
                                double friction) const {
  const internal::GapRadius shape = internal::checked_gap(gap, 0, force, friction);
  if (force == 0) return {};
  // Compute the force at 1 mm for this radius, then invert the power of depth.
  const double at_1mm = c_.force * std::pow(shape.radius / kLawRadius, c_.radius_exponent);
  return answer(shape, kLawDepth * std::pow(force / at_1mm, 1 / c_.depth_exponent), force,
                friction);
}

}  // namespace thenar
