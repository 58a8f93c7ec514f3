#pragma once

/// Least squares A x = B by orthogonal columns, on any scalar: errors grow with the condition of A,
/// not its square, and derivatives come along without a square root.

#include <numeric>
#include <utility>
#include <vector>

#include "base/spatial.h"

namespace thenar {

/// A P = Q U: modified Gram-Schmidt that takes the longest remaining column first.
template <typename T>
struct OrthogonalColumns {
  MatrixX<T> Q;            // columns orthogonal, not of unit length (rows, n)
  MatrixX<T> U;            // unit upper triangular; below the diagonal never read (n, n)
  VectorX<T> inverse;      // 1 / squared length of each column of Q (n)
  std::vector<int> order;  // column of A that became each column of Q (n)
};

/// @param A  as many rows as columns or more, of full rank; else the result is not finite
template <typename T>
[[nodiscard]] OrthogonalColumns<T> orthogonal_columns(MatrixX<T> A) {
  const Eigen::Index n = A.cols();
  OrthogonalColumns<T> out{std::move(A), MatrixX<T>(n, n), VectorX<T>(n), std::vector<int>(n)};
  std::iota(out.order.begin(), out.order.end(), 0);
  for (Eigen::Index k = 0; k < n; ++k) {
    // Pivot: the longest remaining column.
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
    // Take its part out of the others.
    out.inverse[k] = T(1) / square;
    for (Eigen::Index l = k + 1; l < n; ++l) {
      out.U(k, l) = out.Q.col(k).dot(out.Q.col(l)) * out.inverse[k];
      out.Q.col(l) -= out.U(k, l) * out.Q.col(k);
    }
  }
  return out;
}

/// Least |A x - B|. B is orthogonalised like one more column of A, which keeps the method stable.
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
      y(k, m) = a.Q.col(k).dot(B.col(m)) * a.inverse[k];
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

/// Least |x| with A x = B.
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
    // What the columns of Q lack of being orthogonal is made good from the last to the first.
    for (Eigen::Index k = n - 1; k >= 0; --k)
      x.col(m) += ((c[k] - a.Q.col(k).dot(x.col(m))) * a.inverse[k]) * a.Q.col(k);
  }
  return x;
}

}  // namespace thenar
