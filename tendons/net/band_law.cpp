#include "tendons/net/band_law.h"

namespace thenar {
namespace {

/// Values of T(p), dT/dp and the integral of T over e, up to a constant, all over EA.
struct Law {
  double tension, slope, energy;
};

/// Evaluates the law. @param q  (blend / 2)^2, so that de = (1 + q / p^2) dp
Law law(double p, double toe, double q) {
  const auto in_toe = [&](double at) {
    return Law{at * at / (2 * toe), at / toe, (at * at * at / 3 + q * at) / (2 * toe)};
  };
  if (p < toe) return in_toe(p);
  const auto beyond = [&](double at) {
    return at * at / 2 - toe * at / 2 + q * (std::log(at) + toe / (2 * at));
  };
  // Match the energies of both branches at the end of the toe.
  const double before = toe > 0 ? in_toe(toe).energy - beyond(toe) : 0;
  return {p - toe / 2, 1, beyond(p) + before};
}

}  // namespace

BandResponse smoothed_response(double length, double slack, double EA, double toe, double blend) {
  // Compute the smoothed strain, in a form without cancellation for slack bands.
  const double e = (length - slack) / slack, q = blend * blend / 4;
  const double root = std::hypot(e, blend), root_0 = std::hypot(1, blend);
  const double p = e > 0 ? (e + root) / 2 : 2 * q / (root - e), p_0 = 2 * q / (root_0 + 1);
  // Evaluate the law at this strain, less that at zero length.
  const Law at = law(p, toe, q), none = law(p_0, toe, q);
  const double energy = at.energy - none.energy - none.tension * length / slack;
  return {EA * slack * energy, EA * (at.tension - none.tension),
          EA * at.slope * p / (root * slack)};
}

}  // namespace thenar
