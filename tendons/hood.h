#pragma once

/// Extensor hood as fixed force fractions, on any scalar.

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"

namespace thenar {

/// Share of a muscle's tension that enters the hood, and its distribution there.
template <typename T>
struct HoodShare {
  int muscle = 0;  // column of the strand matrix
  HoodSide side;   // lateral band(s) fed by the muscle
  T into_hood;     // fraction of the tension that enters the hood [1]
  T to_central;    // fraction of the hood's share in the central slip, at kHoodAngle [1]
  T slope;  // change of the logit of the central fraction per metacarpophalangeal angle [1/rad]
};

/// Metacarpophalangeal flexion at which `to_central` is stated [rad]: the mean of the four postures
/// measured in [Synek2019], 40, 55, -20 and 0 degrees. In the middle of its data a fitted share
/// depends least on the fitted slope. With a slope of 0 its value does not matter.
inline constexpr double kHoodAngle = 0.33;

/// Shifts a fraction c by u on the logit scale:  logistic(logit(c) + u), exact at c = 0 and 1.
template <typename T>
[[nodiscard]] T shift_fraction(const T& c, const T& u) {
  using std::exp;
  const T odds = c * exp(u);
  return odds / (T(1) - c + odds);
}

/// Rows of the strand matrix for the slips of the hood.
struct HoodRows {
  int central_slip = 0, radial_band = 0, ulnar_band = 0, terminal_slip = 0;
};

/// Adds the hood to S, the matrix (strands, muscles) of strand tension per muscle tension:
///   central  += h c t,   lateral += h (1 - c) t,   terminal = radial + ulnar,
/// with h = into_hood and c = to_central shifted by  slope (angle - kHoodAngle)  on the logit
/// scale, since the slips share tension differently in different postures. A muscle of both sides
/// feeds each lateral band half. Source: [Synek2019] supplement, where slope = 0.
/// @param angle  flexion of the metacarpophalangeal joint [rad]
template <typename T>
void add_hood(const HoodRows& rows, const std::vector<HoodShare<T>>& shares, const T& angle,
              Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>& S) {
  for (const HoodShare<T>& share : shares) {
    const T central = shift_fraction(share.to_central, T(share.slope * (angle - T(kHoodAngle))));
    const T lateral = share.into_hood * (T(1) - central);
    const T radial = share.side == HoodSide::kRadial  ? lateral
                     : share.side == HoodSide::kUlnar ? T(0)
                                                      : T(0.5) * lateral;
    S(rows.central_slip, share.muscle) += share.into_hood * central;
    S(rows.radial_band, share.muscle) += radial;
    S(rows.ulnar_band, share.muscle) += lateral - radial;
    S(rows.terminal_slip, share.muscle) += lateral;
  }
}

}  // namespace thenar
