#pragma once

/// Counter-based random numbers, which depend only on where they are used.

#include <array>
#include <cstdint>

namespace thenar {

/// Computes the counter-based generator Philox4x32-10: 128 random bits for every counter and key.
/// Source: [Salmon2011].
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// Random numbers of one step of one chain: a function of (seed, chain, step, purpose) alone,
/// independent of threads, ranks and interruptions.
class RandomStream {
 public:
  /// @param purpose  distinguishes streams of the same step (start, step, swap, ...)
  RandomStream(std::uint64_t seed, std::uint32_t chain, std::uint32_t step,
               std::uint32_t purpose = 0);

  double uniform();  // uniform in the open interval (0, 1)
  double normal();   // standard normal
  int index(int n);  // 0 .. n - 1, uniform
  /// Draws a chi-square number with `nu` > 0 degrees of freedom. Source: [Marsaglia2000].
  double chi_square(double nu);

 private:
  std::uint64_t bits();

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;  // block, step, chain, purpose
  std::array<std::uint32_t, 4> block_{};
  int left_ = 0;      // unused words of block_
  double spare_ = 0;  // second normal of a pair
  bool has_spare_ = false;
};

}  // namespace thenar
