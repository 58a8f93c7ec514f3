#pragma once

/// Two doubles as one scalar, for templates that run on two postures at once.
///
/// Every x86-64 works on two doubles in the time of one. Comparisons are absent on purpose: the
/// halves could disagree. Angles must stay below internal::kSinCosBound.

#include <cmath>

#include <Eigen/Core>

#include "hand/lanes.h"

namespace thenar {

/// (first, second); every operation acts on both.
struct Pair {
  internal::Half v;

  Pair() = default;
  THENAR_INLINE Pair(double both) : v{both, both} {}  // NOLINT(google-explicit-constructor)
  THENAR_INLINE Pair(double first, double second) : v{first, second} {}
  THENAR_INLINE explicit Pair(const internal::Half& half) : v(half) {}

  /// 0: the first; 1: the second.
  [[nodiscard]] double operator[](int i) const { return v[i]; }

  THENAR_INLINE Pair& operator+=(const Pair& b) { return v += b.v, *this; }
  THENAR_INLINE Pair& operator-=(const Pair& b) { return v -= b.v, *this; }
  THENAR_INLINE Pair& operator*=(const Pair& b) { return v *= b.v, *this; }
  THENAR_INLINE Pair& operator/=(const Pair& b) { return v /= b.v, *this; }
  friend THENAR_INLINE Pair operator+(Pair a, const Pair& b) { return a += b; }
  friend THENAR_INLINE Pair operator-(Pair a, const Pair& b) { return a -= b; }
  friend THENAR_INLINE Pair operator*(Pair a, const Pair& b) { return a *= b; }
  friend THENAR_INLINE Pair operator/(Pair a, const Pair& b) { return a /= b; }
  friend THENAR_INLINE Pair operator-(const Pair& a) { return Pair(-a.v); }
};

THENAR_INLINE Pair sin(const Pair& a) { return Pair(internal::sin_cos(a.v).sine); }
THENAR_INLINE Pair cos(const Pair& a) { return Pair(internal::sin_cos(a.v).cosine); }
THENAR_INLINE Pair sqrt(const Pair& a) { return {std::sqrt(a.v[0]), std::sqrt(a.v[1])}; }

}  // namespace thenar

template <>
struct Eigen::NumTraits<thenar::Pair> : Eigen::GenericNumTraits<thenar::Pair> {
  using Real = thenar::Pair;
  using NonInteger = thenar::Pair;
  using Nested = thenar::Pair;
  using Literal = thenar::Pair;
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
