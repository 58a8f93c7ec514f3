#pragma once

/// Tension of a band that can pull but not push.

#include <cmath>

namespace thenar {

/// Response of a band at some length.
struct BandResponse {
  double energy;     // integral of the tension over the length [J]
  double tension;    // >= 0 [N]
  double stiffness;  // d tension / d length [N/m]
};

/// With  e = (length - slack) / slack:
///   0                    for e <= 0
///   EA e^2 / (2 toe)     for e <= toe
///   EA (e - toe / 2)     beyond
[[nodiscard]] inline BandResponse band_response(double length, double slack, double EA,
                                                double toe) {
  const double e = (length - slack) / slack;
  if (e <= 0) return {0, 0, 0};
  if (e < toe)
    return {EA * slack * e * e * e / (6 * toe), EA * e * e / (2 * toe), EA * e / (toe * slack)};
  const double past = e - 0.5 * toe;
  return {EA * slack * (0.5 * past * past + toe * toe / 24), EA * past, EA / slack};
}

/// The same law T of a strain that is never negative:
///   p = (e + sqrt(e^2 + blend^2)) / 2,    tension = T(p(e)) - T(p(-1)):
/// smooth, above 0 at any length above 0 and 0 at none. Taut, T(p) = EA e (1 + blend^2 / (2 e)^2);
/// slack, EA blend^2 (1 / |e| - 1) / 4. The energy is its integral, by e = p - blend^2 / (4 p).
[[nodiscard]] BandResponse smoothed_response(double length, double slack, double EA, double toe,
                                             double blend);

}  // namespace thenar
