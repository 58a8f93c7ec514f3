#pragma once

/// Pseudo-inverse P of the loads L and its adjoint: least squares if the constraint carries fewer
/// loads than there are joints, the inverse if as many, minimum norm if more.

#include "kinematics_fit/kernel/tape.h"

namespace thenar::kernel {
namespace {

/// Squared sine of the angle between a column and the span of the previous columns below which it
/// counts as dependent: no digit of a force would be correct [1].
inline constexpr double kSingularSquare = 1e-24;

/// Solves  U X = D^-1 Q'  by back substitution.
/// @param inverse  1 / |q|^2 of each column of Q (columns)
inline void substitute_back(const V* Q, const V* U, const V* inverse, int rows, int columns, V* X) {
  for (int k = columns - 1; k >= 0; --k)
    for (int j = 0; j < rows; ++j) {
      V x = inverse[k] * Q[k * rows + j];
      for (int l = k + 1; l < columns; ++l) x -= U[k * columns + l] * X[l * rows + j];
      X[k * rows + j] = x;
    }
}

/// Computes X = A^+ (columns, rows) of A (rows, columns), column-major, rows >= columns, NaN if
/// singular. A = Q U by modified Gram-Schmidt with reorthogonalisation, so that Q is orthogonal to
/// rounding; then U X = D^-1 Q'.
/// @param work  workspace (rows columns + columns columns + columns)
/// Source: [Bjorck1996], methods based on Gram-Schmidt.
inline void pseudo_inverse(const V* A, int rows, int columns, V* X, V* work) {
  V *Q = work, *U = Q + rows * columns, *inverse = U + columns * columns;
  const auto product = [&](int a, int b) {
    V sum = Q[a * rows] * Q[b * rows];
    for (int j = 1; j < rows; ++j) sum += Q[a * rows + j] * Q[b * rows + j];
    return sum;
  };
  // Orthogonalise by Gram-Schmidt, column by column, with two passes.
  for (int i = 0; i < rows * columns; ++i) Q[i] = A[i];
  for (int k = 0; k < columns; ++k) {
    const V whole = product(k, k);
    for (int l = 0; l < k; ++l) U[l * columns + k] = V{};
    for (int pass = 0; pass < 2; ++pass)
      for (int l = 0; l < k; ++l) {
        const V u = product(l, k) * inverse[l];
        U[l * columns + k] += u;
        for (int j = 0; j < rows; ++j) Q[k * rows + j] -= u * Q[l * rows + j];
      }
    // Detect a column in the span of the previous ones.
    const V rest = product(k, k);
    inverse[k] = rest > kSingularSquare * whole ? 1.0 / rest : splat(kNaN);
  }
  substitute_back(Q, U, inverse, rows, columns, X);
}

/// Computes P (c, n) row-major of L (n, c) row-major.
/// @param work  workspace (n c + (n + c + 1) max(n, c) + n c)
inline void invert_loads(const V* L, int n, int c, V* P, V* work) {
  if (n < c) {  // least norm: L' is tall, and stored column by column
    V* X = work + n * c + n * n + n;
    pseudo_inverse(L, c, n, X, work);
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < c; ++k) P[k * n + j] = X[j * c + k];
  } else {
    V* A = work + n * c + c * c + c;
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < c; ++k) A[k * n + j] = L[j * c + k];
    pseudo_inverse(A, n, c, P, work);
  }
}

/// Computes Z = P P_bar' (c, F), with F the number of rows of P that are forces; other columns are
/// zero.
template <int F>
inline void product_with(const V* P, const V* P_bar, int n, int c, V* Z) {
  for (int a = 0; a < c; ++a)
    for (int b = 0; b < F; ++b) {
      V sum = P[a * n] * P_bar[b * n];
      for (int j = 1; j < n; ++j) sum += P[a * n + j] * P_bar[b * n + j];
      Z[a * F + b] = sum;
    }
}

/// Computes L_bar = -P' Z'.
template <int F>
inline void adjoint_square(const V* P, const V* Z, int n, int c, V* L_bar) {
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < c; ++k) {
      V sum = -(P[j] * Z[k * F]);
      for (int b = 1; b < F; ++b) sum -= P[b * n + j] * Z[k * F + b];
      L_bar[j * c + k] = sum;
    }
}

/// Computes N, the first F rows of  I - P L  (F, c).
template <int F>
inline void null_projector(const V* L, const V* P, int n, int c, V* N) {
  for (int b = 0; b < F; ++b)
    for (int k = 0; k < c; ++k) {
      V sum = splat(b == k ? 1 : 0);
      for (int j = 0; j < n; ++j) sum -= P[b * n + j] * L[j * c + k];
      N[b * c + k] = sum;
    }
}

// NOLINTBEGIN(readability-function-size): factors, adjoints and their sizes are pointers and ints

/// Computes L_bar += (P_bar' - L Z) P P'.
template <int F>
inline void adjoint_residual(const V* L, const V* P, const V* P_bar, const V* Z, int n, int c,
                             V* L_bar, V* G) {
  // Compute the first rows of P P'.
  for (int b = 0; b < F; ++b)
    for (int k = 0; k < c; ++k) {
      V sum = P[b * n] * P[k * n];
      for (int j = 1; j < n; ++j) sum += P[b * n + j] * P[k * n + j];
      G[b * c + k] = sum;
    }
  // Multiply row j of the bracket by these rows.
  for (int j = 0; j < n; ++j) {
    V left[F];
    for (int b = 0; b < F; ++b) {
      left[b] = P_bar[b * n + j];
      for (int a = 0; a < c; ++a) left[b] -= L[j * c + a] * Z[a * F + b];
    }
    for (int k = 0; k < c; ++k) {
      V sum = left[0] * G[k];
      for (int b = 1; b < F; ++b) sum += left[b] * G[b * c + k];
      L_bar[j * c + k] += sum;
    }
  }
}

/// Computes L_bar = P' (Z (I - P L) - Z').
template <int F>
inline void adjoint_least_norm(const V* L, const V* P, const V* Z, int n, int c, V* L_bar,
                               V* work) {
  V *N = work, *W = N + F * c;
  null_projector<F>(L, P, n, c, N);
  // Compute  W = Z (I - P L) - Z',  where only F columns of Z are nonzero.
  for (int a = 0; a < c; ++a)
    for (int k = 0; k < c; ++k) {
      V sum = a < F ? -Z[k * F + a] : V{};
      for (int b = 0; b < F; ++b) sum += Z[a * F + b] * N[b * c + k];
      W[a * c + k] = sum;
    }
  // Compute  L_bar = P' W.
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < c; ++k) {
      V sum = P[j] * W[k];
      for (int a = 1; a < c; ++a) sum += P[a * n + j] * W[a * c + k];
      L_bar[j * c + k] = sum;
    }
}

/// Computes the adjoint, where only the first F rows of P matter: those of the forces. With Z = P
/// P_bar',
///   n >= c:  L_bar = (P_bar' - L Z) P P' - P' Z'      (nothing in brackets where n = c)
///   n < c:   L_bar = P' (Z (I - P L) - Z').
/// @param P_bar  (F, n) row-major     @param work  workspace (6 c + c c)
/// Source: [Golub1973] for the derivative, dP = -P dL P + P P' dL' (I - L P) + (I - P L) dL' P' P.
template <int F>
inline void adjoint_inverse_of(const V* L, const V* P, const V* P_bar, int n, int c, V* L_bar,
                               V* work) {
  V* Z = work;
  product_with<F>(P, P_bar, n, c, Z);
  if (n < c) {
    adjoint_least_norm<F>(L, P, Z, n, c, L_bar, Z + F * c);
  } else {
    adjoint_square<F>(P, Z, n, c, L_bar);
    if (n > c) adjoint_residual<F>(L, P, P_bar, Z, n, c, L_bar, Z + F * c);
  }
}

/// Computes the adjoint for two or three rows of forces.
inline void adjoint_pseudo_inverse(const V* L, const V* P, const V* P_bar, int n, int c, int forces,
                                   V* L_bar, V* work) {
  if (forces == 3)
    adjoint_inverse_of<3>(L, P, P_bar, n, c, L_bar, work);
  else
    adjoint_inverse_of<2>(L, P, P_bar, n, c, L_bar, work);
}

// NOLINTEND(readability-function-size)

}  // namespace
}  // namespace thenar::kernel
