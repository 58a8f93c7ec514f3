#pragma once

/// Sines and cosines of many angles at once.

#include <cmath>
#include <type_traits>
#include <vector>

#include "base/simd.h"

namespace thenar::internal {

/// Values of joints, and their sines and cosines. Doubles go two at a time through sin_cos(), which
/// is as exact as the C library's to the last digit or two.
template <typename T>
class JointTurns {
 public:
  explicit JointTurns(std::size_t joints)
      : value_(joints + joints % 2, T(0)), sine_(value_), cosine_(value_) {}

  void set(std::size_t i, const T& value) { value_[i] = value; }

  /// Sines and cosines of all values.
  void find() {
    using std::cos;
    using std::sin;
    if constexpr (std::is_same_v<T, double>) {
      if (find_in_pairs()) return;
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
  /// @return false where some angle is too large
  bool find_in_pairs() {
    bool all_small = true;
    // Take two angles at a time, and note any beyond the range of sin_cos().
    for (std::size_t i = 0; i < value_.size(); i += 2) {
      const Double2 angle{value_[i], value_[i + 1]};
      for (int k = 0; k < 2; ++k) all_small = all_small && std::abs(angle[k]) <= kSinCosBound;
      const SinCos<Double2> turn = sin_cos(angle);
      sine_[i] = turn.sine[0], sine_[i + 1] = turn.sine[1];
      cosine_[i] = turn.cosine[0], cosine_[i + 1] = turn.cosine[1];
    }
    return all_small;
  }

  std::vector<T> value_, sine_, cosine_;  // (joints, and one more if they are odd)
};

}  // namespace thenar::internal
