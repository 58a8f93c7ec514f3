#pragma once

/// Random numbers that depend on nothing except where they are used.

#include <array>
#include <cstdint>

namespace thenar {

/// Returns the block cipher Philox4x32-10: 128 random bits for every counter and key.
/// Source: [Salmon2011].
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// The random numbers of one step of one chain: a function of (seed, chain, step, purpose) alone,
/// however the work is spread over threads, ranks and interrupted runs.
class RandomStream {
 public:
  /// @param purpose  tells streams of the same step apart (start, step, swap, ...)
  RandomStream(std::uint64_t seed, std::uint32_t chain, std::uint32_t step,
               std::uint32_t purpose = 0);

  double uniform();  // uniform in the open interval (0, 1)
  double normal();   // standard normal
  int index(int n);  // 0 .. n - 1, uniform
  /// Chi-square of `nu` > 0 degrees of freedom. Source: [Marsaglia2000].
  double chi_square(double nu);

 private:
  std::uint64_t bits();

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;  // block, step, chain, purpose
  std::array<std::uint32_t, 4> block_{};
  int left_ = 0;      // words of block_ not used yet
  double spare_ = 0;  // second normal of a pair
  bool has_spare_ = false;
};

}  // namespace thenar
