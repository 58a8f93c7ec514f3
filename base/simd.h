#pragma once

/// Vectors of doubles on any processor (GCC and Clang vector extensions). Internal: every function
/// is forced inline, so that it is compiled for the target of its caller.

#include <cstdint>
#include <cstring>

#define THENAR_INLINE inline __attribute__((always_inline))

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // inlined functions have no calling convention

namespace thenar::internal {

/// Four doubles in one register of a processor with AVX.
using Double4 = double __attribute__((vector_size(32)));
using Bits4 = std::int64_t __attribute__((vector_size(32)));

/// Two doubles in one register of any x86-64.
using Double2 = double __attribute__((vector_size(16)));
using Bits2 = std::int64_t __attribute__((vector_size(16)));

/// Four doubles in two registers of any x86-64. The compiler's own splitting of Double4 is slower.
struct Double4Sse {
  Double2 low, high;

  friend THENAR_INLINE Double4Sse operator+(const Double4Sse& a, const Double4Sse& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend THENAR_INLINE Double4Sse operator-(const Double4Sse& a, const Double4Sse& b) {
    return {a.low - b.low, a.high - b.high};
  }
  friend THENAR_INLINE Double4Sse operator*(const Double4Sse& a, const Double4Sse& b) {
    return {a.low * b.low, a.high * b.high};
  }
  friend THENAR_INLINE Double4Sse operator*(const Double4Sse& a, double s) {
    return {a.low * s, a.high * s};
  }
  friend THENAR_INLINE Double4Sse operator*(double s, const Double4Sse& a) { return a * s; }
};

template <typename V>
THENAR_INLINE V load(const double* x) {
  V v;
  std::memcpy(&v, __builtin_assume_aligned(x, 32), sizeof v);
  return v;
}

template <typename V>
THENAR_INLINE void store(double* x, const V& v) {
  std::memcpy(__builtin_assume_aligned(x, 32), &v, sizeof v);
}

/// Eight doubles in one register of a processor with AVX-512.
using Double8 = double __attribute__((vector_size(64)));
using Bits8 = std::int64_t __attribute__((vector_size(64)));

THENAR_INLINE Bits8 bits(const Double8& v) { return reinterpret_cast<const Bits8&>(v); }
THENAR_INLINE Double8 lanes(const Bits8& b) { return reinterpret_cast<const Double8&>(b); }

/// Scalar versions.
THENAR_INLINE std::uint64_t bits(double v) {
  std::uint64_t b;
  std::memcpy(&b, &v, sizeof b);
  return b;
}
THENAR_INLINE double lanes(std::uint64_t b) {
  double v;
  std::memcpy(&v, &b, sizeof v);
  return v;
}

THENAR_INLINE Bits4 bits(const Double4& v) { return reinterpret_cast<const Bits4&>(v); }
THENAR_INLINE Bits2 bits(const Double2& v) { return reinterpret_cast<const Bits2&>(v); }

THENAR_INLINE Double4 lanes(const Bits4& b) { return reinterpret_cast<const Double4&>(b); }
THENAR_INLINE Double2 lanes(const Bits2& b) { return reinterpret_cast<const Double2&>(b); }

/// Returns (y, z, x) of a vector in the first three lanes; the fourth is unchanged.
THENAR_INLINE Double4 rotated(const Double4& v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}
THENAR_INLINE Double4Sse rotated(const Double4Sse& v) {
  return {__builtin_shufflevector(v.low, v.high, 1, 2),
          __builtin_shufflevector(v.low, v.high, 0, 3)};
}

/// Returns the cross product in the first three lanes; the fourth is undefined.
template <typename V>
THENAR_INLINE V cross(const V& a, const V& b) {
  return rotated(a * rotated(b) - rotated(a) * b);
}

template <typename V>
struct SinCos {
  V sine, cosine;
};

inline constexpr double kSinCosBound = 1e5;  // Largest |angle| for sin_cos() [rad]

/// Computes sine and cosine to 1e-16, for |angle| <= kSinCosBound. V is any of the types above.
///
/// The angle is reduced to |r| <= pi/4 by subtracting n pi/2 in three parts whose products with n
/// are exact; then polynomials of degree 13 and 14 are evaluated. Source: [Sun1993] fdlibm,
/// k_sin.c, k_cos.c and e_rem_pio2.c.
template <typename V>
THENAR_INLINE SinCos<V> sin_cos(const V& angle) {
  const double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const V shifted = angle * 6.36619772367581382433e-01 + kRound;
  // Reduce by quarter turns; pi / 2 in three parts keeps the remainder exact.
  const auto n = bits(shifted);
  const V turns = shifted - kRound;
  const V r = ((angle - turns * 1.57079632673412561417e+00) - turns * 6.07710050630396597660e-11) -
              turns * 2.02226624879595063154e-21;

  // Polynomials of sine and cosine on [-pi / 4, pi / 4].
  const V z = r * r;
  const V s =
      r + r * z *
              (-1.66666666666666324348e-01 +
               z * (8.33333333332248946124e-03 +
                    z * (-1.98412698298579493134e-04 +
                         z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 +
                                                                z * 1.58969099521155010221e-10)))));
  const V half = 0.5 * z, head = 1.0 - half;
  const V c =
      head +
      (((1.0 - head) - half) +
       z * z *
           (4.16666666666666019037e-02 +
            z * (-1.38888888888741095749e-03 +
                 z * (2.48015872894767294178e-05 +
                      z * (-2.75573143513906633035e-07 +
                           z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))))));

  // Swap sine and cosine at odd quarter turns; bit 1 of n, or of n + 1, is the sign.
  const auto swap = -(n & 1), sine_sign = (n & 2) << 62, cosine_sign = ((n + 1) & 2) << 62;
  const auto sine = (bits(c) & swap) | (bits(s) & ~swap);
  const auto cosine = (bits(s) & swap) | (bits(c) & ~swap);
  return {lanes(sine ^ sine_sign), lanes(cosine ^ cosine_sign)};
}

}  // namespace thenar::internal

#pragma GCC diagnostic pop
