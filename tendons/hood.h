#pragma once

/// The extensor hood as fixed force fractions, on any scalar.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"

namespace thenar {

/// Share of a muscle's tension that enters the hood, and where it goes.
template <typename T>
struct HoodShare {
  int muscle;     // column of the strand matrix
  HoodSide side;  // lateral band(s) that it feeds
  T into_hood;    // fraction of the tension that enters the hood [1]
  T to_central;   // fraction of that in the central slip [1]
};

/// Rows of the strand matrix that belong to the hood.
struct HoodRows {
  int central_slip, radial_band, ulnar_band, terminal_slip;
};

/// Adds the hood to S, the matrix (strands, muscles) of strand tension per muscle tension:
///   central  += h c t,   lateral += h (1 - c) t,   terminal = radial + ulnar,
/// with h = into_hood, c = to_central; a muscle of both sides feeds each band half.
/// Source: [Synek2019] supplement; fractions of [Chao1989] as the special case c = 1/2.
template <typename T>
void add_hood(const HoodRows& rows, const std::vector<HoodShare<T>>& shares,
              Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>& S) {
  for (const HoodShare<T>& share : shares) {
    const T lateral = share.into_hood * (T(1) - share.to_central);
    const T radial = share.side == HoodSide::kRadial  ? lateral
                     : share.side == HoodSide::kUlnar ? T(0)
                                                      : T(0.5) * lateral;
    S(rows.central_slip, share.muscle) += share.into_hood * share.to_central;
    S(rows.radial_band, share.muscle) += radial;
    S(rows.ulnar_band, share.muscle) += lateral - radial;
    S(rows.terminal_slip, share.muscle) += lateral;
  }
}

}  // namespace thenar
