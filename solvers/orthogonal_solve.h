#pragma once

/// Least squares A x = B by orthogonalisation for any scalar type. Errors grow with the condition
/// number of A, not with its square, and derivatives are propagated without a square root.

#include <numeric>
#include <utility>
#include <vector>

#include "base/spatial.h"

namespace thenar {

/// Decomposition A P = Q U by modified Gram-Schmidt with column pivoting.
template <typename T>
struct OrthogonalColumns {
  MatrixX<T> Q;                // orthogonal columns, not normalised (rows, n)
  MatrixX<T> U;                // unit upper triangular; entries below the diagonal are unset (n, n)
  VectorX<T> inverse_squares;  // 1 / squared length of each column of Q (n)
  std::vector<int> order;      // column of A from which each column of Q was made (n)
};

/// Decomposes a matrix.
/// @param A  full column rank (rows, n), rows >= n; otherwise the result is not finite
template <typename T>
[[nodiscard]] OrthogonalColumns<T> orthogonal_columns(MatrixX<T> A) {
  const Eigen::Index n = A.cols();
  OrthogonalColumns<T> out{std::move(A), MatrixX<T>(n, n), VectorX<T>(n), std::vector<int>(n)};
  std::iota(out.order.begin(), out.order.end(), 0);
  for (Eigen::Index k = 0; k < n; ++k) {
    // Select the longest remaining column as pivot.
    Eigen::Index longest = k;
    T square = out.Q.col(k).squaredNorm();
    for (Eigen::Index l = k + 1; l < n; ++l) {
      const T other = out.Q.col(l).squaredNorm();
      if (other > square) {
        square = other;
        longest = l;
      }
    }
    if (longest != k) {
      out.Q.col(k).swap(out.Q.col(longest));
      out.U.col(k).head(k).swap(out.U.col(longest).head(k));
      std::swap(out.order[k], out.order[longest]);
    }
    // Remove its component from the remaining columns.
    out.inverse_squares[k] = T(1) / square;
    for (Eigen::Index l = k + 1; l < n; ++l) {
      out.U(k, l) = out.Q.col(k).dot(out.Q.col(l)) * out.inverse_squares[k];
      out.Q.col(l) -= out.U(k, l) * out.Q.col(k);
    }
  }
  return out;
}

/// Minimises |A x - B|. B is orthogonalised like another column of A, which keeps the method
/// stable.
/// @param A  (rows, n), rows >= n      @param B  (rows, m)      @return x (n, m)
/// Source: [Bjorck1996], methods based on Gram-Schmidt.
template <typename T>
[[nodiscard]] MatrixX<T> solve_least_squares(const MatrixX<T>& A, MatrixX<T> B) {
  const OrthogonalColumns<T> a = orthogonal_columns(A);
  const Eigen::Index n = A.cols();
  MatrixX<T> y(n, B.cols()), x(n, B.cols());
  for (Eigen::Index m = 0; m < B.cols(); ++m) {
    // Components along the columns of Q.
    for (Eigen::Index k = 0; k < n; ++k) {
      y(k, m) = a.Q.col(k).dot(B.col(m)) * a.inverse_squares[k];
      B.col(m) -= y(k, m) * a.Q.col(k);
    }
    // Back substitution.
    for (Eigen::Index k = n - 1; k >= 0; --k) {
      for (Eigen::Index l = k + 1; l < n; ++l) y(k, m) -= a.U(k, l) * y(l, m);
      x(a.order[k], m) = y(k, m);
    }
  }
  return x;
}

/// Finds the x of minimum norm with A x = B.
/// @param A  (n, columns), n <= columns      @param B  (n, m)      @return x (columns, m)
/// Source: [Bjorck1996], methods based on Gram-Schmidt.
template <typename T>
[[nodiscard]] MatrixX<T> solve_least_norm(const MatrixX<T>& A, const MatrixX<T>& B) {
  const OrthogonalColumns<T> a = orthogonal_columns(MatrixX<T>(A.transpose()));
  const Eigen::Index n = A.rows();
  MatrixX<T> x = MatrixX<T>::Zero(A.cols(), B.cols());
  VectorX<T> c(n);  // Q' x
  for (Eigen::Index m = 0; m < B.cols(); ++m) {
    // Forward substitution.
    for (Eigen::Index k = 0; k < n; ++k) {
      c[k] = B(a.order[k], m);
      for (Eigen::Index l = 0; l < k; ++l) c[k] -= a.U(l, k) * c[l];
    }
    // Add the columns from last to first, correcting for their loss of orthogonality.
    for (Eigen::Index k = n - 1; k >= 0; --k)
      x.col(m) += ((c[k] - a.Q.col(k).dot(x.col(m))) * a.inverse_squares[k]) * a.Q.col(k);
  }
  return x;
}

}  // namespace thenar
