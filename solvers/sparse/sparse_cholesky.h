#pragma once

/// Sparse symmetric positive definite systems with a fixed pattern and changing values.

#include <memory>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Pattern of the lower triangle of a symmetric matrix in compressed columns; row indices ascend
/// within each column, starting with the diagonal.
struct SymmetricPattern {
  int size = 0;             // rows of the matrix
  std::vector<int> starts;  // position in `rows` where each column begins, and the end (size + 1)
  std::vector<int> rows;    // row index of each entry (entries)
};

/// Cholesky factorisation L L' of sparse matrices, by CHOLMOD. The symbolic analysis is done once.
/// Source: [Chen2008].
class SparseCholesky {
 public:
  /// @throws InputError if the pattern is not a lower triangle
  explicit SparseCholesky(SymmetricPattern pattern);
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;
  ~SparseCholesky();

  [[nodiscard]] const SymmetricPattern& pattern() const;
  /// Factorises a matrix.
  /// @param values  value of each entry of the pattern (entries)
  /// @return whether all values are finite and the matrix is positive definite to rounding;
  /// otherwise no factor is available
  [[nodiscard]] bool factor(const std::vector<double>& values);
  /// Solves A x = b (size, systems). The workspace is shared: call it from one thread at a time.
  /// @param b  right-hand sides (size, systems)
  /// @throws InputError without a factor, or if b has another size
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  /// Returns the number of entries of the factor.
  [[nodiscard]] double fill() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
