#pragma once

/// Tension law of a band that can pull but not push.

#include <cmath>

#include "tendons/tension_law.h"

namespace thenar {

/// Computes the response at strain  e = (length - slack) / slack;  its tension is
///   0                    for e <= 0
///   EA e^2 / (2 toe)     for e <= toe
///   EA (e - toe / 2)     beyond
/// @param length, slack  present length and length without tension, > 0 [m]
/// @param EA             axial stiffness: tension per strain beyond the toe [N]
/// @param toe            strain at which the law becomes linear, >= 0 [1]
[[nodiscard]] inline BandResponse band_response(double length, double slack, double EA,
                                                double toe) {
  const double e = (length - slack) / slack;
  if (e <= 0) return {0, 0, 0};
  if (e < toe)
    return {EA * slack * e * e * e / (6 * toe), EA * e * e / (2 * toe), EA * e / (toe * slack)};
  const double past = e - 0.5 * toe;
  return {EA * slack * (0.5 * past * past + toe * toe / 24), EA * past, EA / slack};
}

/// Computes the law T of band_response() at a smoothed strain p that is never negative:
///   p = (e + sqrt(e^2 + blend^2)) / 2,    tension = T(p(e)) - T(p(-1)).
/// The tension is smooth, above 0 at any length above 0, and 0 at length 0. The energy is its
/// integral over the length, by e = p - blend^2 / (4 p).
///
/// To first order, where |e| is much larger than blend: p = e + blend^2 / (4 e) if taut (e > 0) and
/// p = blend^2 / (4 |e|) if slack (e < 0). Without a toe the tension is then
///   EA (e + blend^2 / (4 e))  taut,    EA blend^2 (1 / |e| - 1) / 4  slack;
/// with a toe the slack tension is far smaller, about EA p^2 / (2 toe).
/// @param blend  strain over which the band changes from slack to taut, > 0 [1]; others as above
[[nodiscard]] BandResponse smoothed_response(double length, double slack, double EA, double toe,
                                             double blend);

}  // namespace thenar
