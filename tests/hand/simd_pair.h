#pragma once

/// Two doubles as one scalar, for templates that run on two postures at once.
///
/// Every x86-64 works on two doubles in the time of one. Comparisons are absent on purpose: the
/// halves could disagree. Angles must stay below internal::kSinCosBound.

#include <cmath>

#include <Eigen/Core>

#include "base/simd.h"

namespace thenar {

/// (first, second); every operation acts on both.
struct SimdPair {
  internal::Double2 v;

  SimdPair() = default;
  THENAR_INLINE SimdPair(double both) : v{both, both} {}  // NOLINT(google-explicit-constructor)
  THENAR_INLINE SimdPair(double first, double second) : v{first, second} {}
  THENAR_INLINE explicit SimdPair(const internal::Double2& half) : v(half) {}

  /// 0: the first; 1: the second.
  [[nodiscard]] double operator[](int i) const { return v[i]; }

  THENAR_INLINE SimdPair& operator+=(const SimdPair& b) { return v += b.v, *this; }
  THENAR_INLINE SimdPair& operator-=(const SimdPair& b) { return v -= b.v, *this; }
  THENAR_INLINE SimdPair& operator*=(const SimdPair& b) { return v *= b.v, *this; }
  THENAR_INLINE SimdPair& operator/=(const SimdPair& b) { return v /= b.v, *this; }
  friend THENAR_INLINE SimdPair operator+(SimdPair a, const SimdPair& b) { return a += b; }
  friend THENAR_INLINE SimdPair operator-(SimdPair a, const SimdPair& b) { return a -= b; }
  friend THENAR_INLINE SimdPair operator*(SimdPair a, const SimdPair& b) { return a *= b; }
  friend THENAR_INLINE SimdPair operator/(SimdPair a, const SimdPair& b) { return a /= b; }
  friend THENAR_INLINE SimdPair operator-(const SimdPair& a) { return SimdPair(-a.v); }
};

THENAR_INLINE SimdPair sin(const SimdPair& a) { return SimdPair(internal::sin_cos(a.v).sine); }
THENAR_INLINE SimdPair cos(const SimdPair& a) { return SimdPair(internal::sin_cos(a.v).cosine); }
THENAR_INLINE SimdPair sqrt(const SimdPair& a) { return {std::sqrt(a.v[0]), std::sqrt(a.v[1])}; }

}  // namespace thenar

template <>
struct Eigen::NumTraits<thenar::SimdPair> : Eigen::GenericNumTraits<thenar::SimdPair> {
  using Real = thenar::SimdPair;
  using NonInteger = thenar::SimdPair;
  using Nested = thenar::SimdPair;
  using Literal = thenar::SimdPair;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
