#pragma once

/// Vector arithmetic on THENAR_LANES points at a time. Only simd_backend_*.cpp include it; they
/// define THENAR_LANES.
///
/// Every backend computes the same sums in the same order, without fused multiplications
/// (-ffp-contract=off), so that all give the same bits. Everything is in an anonymous namespace:
/// each backend is compiled for its own processor and must not share functions with others.

#include <cstdint>

#if THENAR_LANES > 1
#include <immintrin.h>
#endif

#include "base/simd.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // nothing here is called from elsewhere

namespace thenar::kernel {
namespace {

inline constexpr int kLanes = THENAR_LANES;  // doubles in a register

#if THENAR_LANES == 1
using V = double;
inline double lane(V v, int) { return v; }
inline void set_lane(V& v, int, double x) { v = x; }
inline V square_root(V v) { return __builtin_sqrt(v); }
#else
using V = double __attribute__((vector_size(8 * THENAR_LANES)));
inline double lane(const V& v, int k) { return v[k]; }
inline void set_lane(V& v, int k, double x) { v[k] = x; }
#if THENAR_LANES == 2
inline V square_root(const V& v) { return _mm_sqrt_pd(v); }
#elif THENAR_LANES == 4
inline V square_root(const V& v) { return _mm256_sqrt_pd(v); }
#else
inline V square_root(const V& v) { return _mm512_sqrt_pd(v); }
#endif
#endif

inline V splat(double x) { return V{} + x; }

inline constexpr double kNaN = __builtin_nan("");

/// Returns sine and cosine; NaN for angles that are too large for internal::sin_cos().
inline internal::SinCos<V> sine_and_cosine(const V& angle) {
  const V bound = splat(internal::kSinCosBound);
  const V a = angle < bound ? (angle > -bound ? angle : splat(kNaN)) : splat(kNaN);
  return internal::sin_cos(a);
}

/// Computes exp(x) to 1e-16; x is clipped to |x| <= 700. x = n log 2 + r,  |r| <= log(2) / 2,
/// exp(r) by Remez' rational function.
/// Source: [Sun1993] fdlibm, e_exp.c.
inline V exponential(const V& x) {
  const V kTop = splat(700);
  const V y = x > kTop ? kTop : x < -kTop ? -kTop : x;
  const double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const V shifted = y * 1.44269504088896338700e+00 + kRound;
  const V n = shifted - kRound;
  // Compute the remainder in two parts, so that no digit is lost.
  const V high = y - n * 6.93147180369123816490e-01, low = n * 1.90821492927058770002e-10;
  const V r = high - low, t = r * r;
  // Evaluate a rational approximation of exp(r).
  const V c =
      r - t * (1.66666666666666019037e-01 +
               t * (-2.77777777770155933842e-03 +
                    t * (6.61375632143793436117e-05 +
                         t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
  const V e = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
  // Form 2^n from its exponent bits.
  const auto power = (internal::bits(shifted) << 52) + internal::bits(splat(1.0));
  return e * internal::lanes(power);
}

/// Three-dimensional vector in every lane.
struct Vec {
  V x, y, z;
};
inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(const V& s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline void operator+=(Vec& a, const Vec& b) { a = a + b; }
inline void operator-=(Vec& a, const Vec& b) { a = a - b; }
inline V dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Matrix (3, 3) in every lane, by columns.
struct Mat {
  Vec x, y, z;
};
inline Vec operator*(const Mat& A, const Vec& v) { return v.x * A.x + v.y * A.y + v.z * A.z; }
/// Returns A' v.
inline Vec turned_back(const Mat& A, const Vec& v) {
  return {dot(A.x, v), dot(A.y, v), dot(A.z, v)};
}
inline Mat operator*(const Mat& A, const Mat& B) { return {A * B.x, A * B.y, A * B.z}; }
inline Mat transposed(const Mat& A) {
  return {{A.x.x, A.y.x, A.z.x}, {A.x.y, A.y.y, A.z.y}, {A.x.z, A.y.z, A.z.z}};
}
/// Builds a matrix from nine numbers, column by column.
inline Mat constant_matrix(const double* c) {
  return {{splat(c[0]), splat(c[1]), splat(c[2])},
          {splat(c[3]), splat(c[4]), splat(c[5])},
          {splat(c[6]), splat(c[7]), splat(c[8])}};
}
inline constexpr double kIdentity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Returns three consecutive numbers as a vector.
inline Vec vector_at(const V* number) { return {number[0], number[1], number[2]}; }
/// Adds a vector to three consecutive numbers.
inline void add_vector(V* number, const Vec& v) {
  number[0] += v.x;
  number[1] += v.y;
  number[2] += v.z;
}

}  // namespace
}  // namespace thenar::kernel
