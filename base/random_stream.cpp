#include "base/random_stream.h"

#include <cmath>

#include "base/units.h"

namespace thenar {
namespace {

struct Product {
  std::uint32_t high, low;
};

Product multiply(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t product = std::uint64_t{a} * b;
  return {static_cast<std::uint32_t>(product >> 32), static_cast<std::uint32_t>(product)};
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  // Ten rounds of Philox 4x32, with multipliers and Weyl constants of [Salmon2011].
  for (int round = 0; round < 10; ++round) {
    const Product a = multiply(0xD2511F53, counter[0]), b = multiply(0xCD9E8D57, counter[2]);
    counter = {b.high ^ counter[1] ^ key[0], b.low, a.high ^ counter[3] ^ key[1], a.low};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t chain, std::uint32_t step,
                           std::uint32_t purpose)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, step, chain, purpose} {}

std::uint64_t RandomStream::bits() {
  if (left_ == 0) {
    block_ = philox(counter_, key_);
    ++counter_[0];
    left_ = 4;
  }
  left_ -= 2;
  return std::uint64_t{block_[left_]} << 32 | block_[left_ + 1];
}

double RandomStream::uniform() {
  // 52 bits and a half step: 2^-53 .. 1 - 2^-53.
  return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52;
}

double RandomStream::normal() {
  // Source: [BoxMuller1958].
  has_spare_ = !has_spare_;
  if (!has_spare_) return spare_;
  const double radius = std::sqrt(-2 * std::log(uniform())), turn = 2 * kPi * uniform();
  spare_ = radius * std::sin(turn);
  return radius * std::cos(turn);
}

int RandomStream::index(int n) {
  // The bias of n / 2^52 is far below what any run could see.
  return static_cast<int>(uniform() * n);
}

// NOLINTNEXTLINE(misc-no-recursion): once, as nu + 2 > 2
double RandomStream::chi_square(double nu) {
  // Of a shape below 1: that of a larger one, times a power of a uniform number.
  const double shape = nu / 2;
  if (shape < 1) return chi_square(nu + 2) * std::pow(uniform(), 1 / shape);
  // Marsaglia and Tsang's rejection from the cube of a normal number.
  const double d = shape - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  while (true) {
    const double z = normal(), v = std::pow(1 + c * z, 3);
    if (v > 0 && std::log(uniform()) < z * z / 2 + d - d * v + d * std::log(v)) return 2 * d * v;
  }
}

}  // namespace thenar
