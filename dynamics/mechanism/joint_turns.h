#pragma once

/// Sines and cosines of all joint angles, computed in SIMD pairs.

#include <cmath>
#include <type_traits>
#include <vector>

#include "base/simd.h"

namespace thenar::internal {

/// Values of joints with their sines and cosines. Doubles are computed in pairs by sin_cos(), which
/// agrees with the C library to one or two units in the last place.
template <typename T>
class JointTurns {
 public:
  explicit JointTurns(std::size_t joints)
      : value_(joints + joints % 2, T(0)), sine_(value_), cosine_(value_) {}

  /// Sets the value of joint i [rad].
  void set(std::size_t i, const T& value) { value_[i] = value; }

  /// Computes the sines and cosines of all values.
  void compute() {
    using std::cos;
    using std::sin;
    if constexpr (std::is_same_v<T, double>) {
      if (compute_in_pairs()) return;
    }
    for (std::size_t i = 0; i < value_.size(); ++i) {
      sine_[i] = sin(value_[i]);
      cosine_[i] = cos(value_[i]);
    }
  }

  [[nodiscard]] const T& value(std::size_t i) const { return value_[i]; }
  [[nodiscard]] const T& sine(std::size_t i) const { return sine_[i]; }
  [[nodiscard]] const T& cosine(std::size_t i) const { return cosine_[i]; }

 private:
  /// Computes all sines and cosines in pairs. @return false if an angle exceeds kSinCosBound
  bool compute_in_pairs() {
    bool all_small = true;
    for (std::size_t i = 0; i < value_.size(); i += 2) {
      const Double2 angle{value_[i], value_[i + 1]};
      for (int k = 0; k < 2; ++k) all_small = all_small && std::abs(angle[k]) <= kSinCosBound;
      const SinCos<Double2> turn = sin_cos(angle);
      sine_[i] = turn.sine[0], sine_[i + 1] = turn.sine[1];
      cosine_[i] = turn.cosine[0], cosine_[i + 1] = turn.cosine[1];
    }
    return all_small;
  }

  std::vector<T> value_, sine_, cosine_;  // (joints, rounded up to an even number)
};

}  // namespace thenar::internal
