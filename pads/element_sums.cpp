#include "pads/element_sums.h"

#include "base/for_all_processors.h"
#include "base/simd.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // functions of vectors are inlined

namespace thenar {
namespace {

using Lanes = internal::Double4;

THENAR_INLINE Lanes lanes_at(const double* x) {
  Lanes v;
  std::memcpy(&v, x, sizeof v);
  return v;
}
THENAR_INLINE void put(double* x, const Lanes& v) { std::memcpy(x, &v, sizeof v); }

THENAR_INLINE double sum_of(const Lanes& v) { return (v[0] + v[2]) + (v[1] + v[3]); }

/// Returns the sums of the entries of four vectors.
THENAR_INLINE Lanes sums_of(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab =
      __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd =
      __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// Computes F = 1 + sum u_a dN_a/dX of four points, its determinant and the spatial gradients.
template <int N>
THENAR_INLINE void kinematics(int points, const double* gradient, const double* u,
                              PointKinematics& out, int q) {
  // Sum the deformation gradient, column by column.
  Lanes F[9]{};
  for (int a = 0; a < N; ++a)
    for (int j = 0; j < 3; ++j) {
      const Lanes G = lanes_at(gradient + (3 * a + j) * points + q);
      for (int i = 0; i < 3; ++i) F[3 * j + i] += u[3 * a + i] * G;
    }
  for (int i = 0; i < 3; ++i) F[4 * i] += Lanes{} + 1;
  for (int k = 0; k < 9; ++k) put(out.F + k * points + q, F[k]);
  // Compute the cofactors, columns of F^-T times J.
  Lanes C[9];
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      C[3 * j + i] = F[3 * j1 + i1] * F[3 * j2 + i2] - F[3 * j1 + i2] * F[3 * j2 + i1];
    }
  // Compute the determinant, and F^-T from the cofactors.
  const Lanes J = F[0] * C[0] + F[1] * C[1] + F[2] * C[2];
  put(out.J + q, J);
  const Lanes reciprocal = 1.0 / J;
  for (Lanes& each : C) each *= reciprocal;
  // Compute the spatial gradients  g_a = F^-T dN_a/dX.
  for (int a = 0; a < N; ++a) {
    const Lanes x = lanes_at(gradient + (3 * a) * points + q),
                y = lanes_at(gradient + (3 * a + 1) * points + q),
                z = lanes_at(gradient + (3 * a + 2) * points + q);
    for (int i = 0; i < 3; ++i)
      put(out.g + (3 * a + i) * points + q, C[i] * x + C[3 + i] * y + C[6 + i] * z);
  }
}

template <int N>
THENAR_INLINE void forces(int points, const double* g, const PointStresses& at, double* force) {
  for (int a = 0; a < N; ++a) {
    // Sum tau g_a over the points.
    Lanes x{}, y{}, z{};
    for (int q = 0; q < points; q += 4) {
      const auto tau = [&](int p) __attribute__((always_inline)) {
        return lanes_at(at.tau + p * points + q);
      };
      const Lanes gx = lanes_at(g + 3 * a * points + q),
                  gy = lanes_at(g + (3 * a + 1) * points + q),
                  gz = lanes_at(g + (3 * a + 2) * points + q);
      x += gx * tau(0) + gy * tau(3) + gz * tau(5);
      y += gx * tau(3) + gy * tau(1) + gz * tau(4);
      z += gx * tau(5) + gy * tau(4) + gz * tau(2);
    }
    force[3 * a] += sum_of(x);
    force[3 * a + 1] += sum_of(y);
    force[3 * a + 2] += sum_of(z);
  }
}

/// c B_b (6, 3) and tau g_b (3) of a node, for four points.
struct NodeStress {
  Lanes t[3][6], s[3];
};

THENAR_INLINE NodeStress node_stress(int points, const double* g, const PointStresses& at, int b,
                                     int q) {
  NodeStress out;
  const Lanes x = lanes_at(g + 3 * b * points + q), y = lanes_at(g + (3 * b + 1) * points + q),
              z = lanes_at(g + (3 * b + 2) * points + q);
  const auto c = [&](int p, int r) __attribute__((always_inline)) {
    return lanes_at(at.c + (p < r ? tangent_entry(p, r) : tangent_entry(r, p)) * points + q);
  };
  // Compute the columns of c B_b.
  for (int p = 0; p < 6; ++p) {
    out.t[0][p] = c(p, 0) * x + c(p, 3) * y + c(p, 5) * z;
    out.t[1][p] = c(p, 1) * y + c(p, 3) * x + c(p, 4) * z;
    out.t[2][p] = c(p, 2) * z + c(p, 4) * y + c(p, 5) * x;
  }
  // Compute the stress along the gradient, tau g_b.
  const auto tau = [&](int p) __attribute__((always_inline)) {
    return lanes_at(at.tau + p * points + q);
  };
  out.s[0] = tau(0) * x + tau(3) * y + tau(5) * z;
  out.s[1] = tau(3) * x + tau(1) * y + tau(4) * z;
  out.s[2] = tau(5) * x + tau(4) * y + tau(2) * z;
  return out;
}

template <int N>
THENAR_INLINE void stiffness(int points, const double* g, const PointStresses& at, double* K) {
  NodeStress of[kMaxPoints / 4];
  for (int b = 0; b < N; ++b) {
    // Compute the factors of node b, which all blocks of its column share.
    for (int q = 0; q < points; q += 4) of[q / 4] = node_stress(points, g, at, b, q);
    for (int a = 0; a <= b; ++a) {
      // Sum the block of nodes a <= b, by columns:  B_a' c B_b  and, on its diagonal, g_a . tau
      // g_b.
      Lanes sum[9]{};
      for (int q = 0; q < points; q += 4) {
        const NodeStress& right = of[q / 4];
        const Lanes x = lanes_at(g + 3 * a * points + q),
                    y = lanes_at(g + (3 * a + 1) * points + q),
                    z = lanes_at(g + (3 * a + 2) * points + q);
        const Lanes geometric = x * right.s[0] + y * right.s[1] + z * right.s[2];
        for (int j = 0; j < 3; ++j) {
          const Lanes* t = right.t[j];
          sum[3 * j] += x * t[0] + y * t[3] + z * t[5];
          sum[3 * j + 1] += y * t[1] + x * t[3] + z * t[4];
          sum[3 * j + 2] += z * t[2] + y * t[4] + x * t[5];
          sum[4 * j] += geometric;
        }
      }
      // Add the sums over the four lanes to K.
      const Lanes first = sums_of(sum[0], sum[1], sum[2], sum[3]),
                  second = sums_of(sum[4], sum[5], sum[6], sum[7]);
      double* column = K + 3 * b * 3 * N + 3 * a;
      for (int i = 0; i < 3; ++i) column[i] += first[i];
      column += 3 * N;
      column[0] += first[3];
      column[1] += second[0];
      column[2] += second[1];
      column += 3 * N;
      column[0] += second[2];
      column[1] += second[3];
      column[2] += sum_of(sum[8]);
    }
  }
}

}  // namespace

THENAR_FOR_ALL_PROCESSORS
void point_kinematics(int nodes, int points, const double* gradient, const double* u,
                      PointKinematics& out) {
  for (int q = 0; q < points; q += 4)
    if (nodes == 8)
      kinematics<8>(points, gradient, u, out, q);
    else
      kinematics<27>(points, gradient, u, out, q);
}

THENAR_FOR_ALL_PROCESSORS
void add_forces(int nodes, int points, const double* g, const PointStresses& at, double* force) {
  if (nodes == 8)
    forces<8>(points, g, at, force);
  else
    forces<27>(points, g, at, force);
}

THENAR_FOR_ALL_PROCESSORS
void add_stiffness(int nodes, int points, const double* g, const PointStresses& at, double* K) {
  if (nodes == 8)
    stiffness<8>(points, g, at, K);
  else
    stiffness<27>(points, g, at, K);
}

}  // namespace thenar
