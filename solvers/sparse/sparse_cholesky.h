#pragma once

/// Sparse symmetric positive definite systems whose pattern stays while their values change.

#include <memory>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Lower triangle of a symmetric matrix, compressed by columns; rows rise within each column, the
/// diagonal first.
struct SymmetricPattern {
  int size = 0;
  std::vector<int> starts;  // of columns (size + 1)
  std::vector<int> rows;    // (entries)
};

/// L L' of a sparse matrix, by CHOLMOD: the fill-in is found once for a pattern.
/// Source: [Chen2008].
class SparseCholesky {
 public:
  /// @throws InputError if the pattern is no lower triangle
  explicit SparseCholesky(SymmetricPattern pattern);
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;
  ~SparseCholesky();

  [[nodiscard]] const SymmetricPattern& pattern() const;
  /// @param values  of the pattern's entries
  /// @return whether all are finite and the matrix positive definite to rounding; otherwise there
  /// is no factor
  [[nodiscard]] bool factor(const std::vector<double>& values);
  /// x of  A x = b. Its room is shared: one thread at a time.
  /// @param b  (size, systems)
  /// @throws InputError without a factor, or if b has another size
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  /// Entries of the factor.
  [[nodiscard]] double fill() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
