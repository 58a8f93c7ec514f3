#pragma once

/// Chains that anybody can make again in any language.

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "base/random_stream.h"

namespace thenar::sample {

/// 4 chains of 500: s = chain + 1, then s = 48271 s mod (2^31 - 1), u = s / (2^31 - 1),
/// z = ln(u / (1 - u)), p = phi p + z from p = 0, x = p; the last chain is shifted.
inline Eigen::MatrixXd reference_chains(double phi, double shift_of_last) {
  constexpr std::int64_t kModulus = 2147483647;
  Eigen::MatrixXd x(500, 4);
  for (int chain = 0; chain < 4; ++chain) {
    std::int64_t s = chain + 1;
    double p = 0;
    for (int i = 0; i < 500; ++i) {
      s = 48271 * s % kModulus;
      const double u = double(s) / double(kModulus);
      p = phi * p + std::log(u / (1 - u));
      x(i, chain) = p + (chain == 3 ? shift_of_last : 0);
    }
  }
  return x;
}

/// Autoregressive chains  x_i = phi x_{i-1} + e_i  of mean 0 and sd 1, e normal.
inline Eigen::MatrixXd autoregressive(double phi, int draws, int chains, unsigned seed = 1) {
  Eigen::MatrixXd x(draws, chains);
  for (int chain = 0; chain < chains; ++chain) {
    RandomStream random(seed, chain, 0);
    x(0, chain) = random.normal();
    for (int i = 1; i < draws; ++i)
      x(i, chain) = phi * x(i - 1, chain) + std::sqrt(1 - phi * phi) * random.normal();
  }
  return x;
}

}  // namespace thenar::sample
