#pragma once

/// Symmetric matrices of 3 x 3 blocks with a fixed sparsity pattern, and their factorisation.

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// Sparsity pattern of the blocks, including the fill-in of the factorisation. Rows are stored in
/// elimination order.
class BlockPattern {
 public:
  /// @param edges  pairs of coupled rows, numbered from 0 to n - 1
  BlockPattern(int n, const std::vector<std::pair<int, int>>& edges);

  [[nodiscard]] int size() const { return static_cast<int>(place_.size()); }
  [[nodiscard]] int blocks() const { return static_cast<int>(row_.size()); }
  /// Returns the position of a row in elimination order.
  [[nodiscard]] int place(int row) const { return place_[row]; }
  /// Returns the slot of block (i, j), i > j in elimination order; -1 if the block is zero.
  [[nodiscard]] int slot(int i, int j) const;

  /// Returns the rows (i, j) of a slot.
  [[nodiscard]] std::pair<int, int> rows_of(int slot) const { return {row_[slot], column_[slot]}; }

  struct Update {
    int left, right, target;  // block[target] -= W[left] V[right]'; target < 0: diagonal ~target
  };

 private:
  friend class BlockFactor;
  // Column k of row_ spans start_[k] .. start_[k + 1].
  std::vector<int> place_, start_, row_, column_;
  std::vector<Update> update_;
  std::vector<int> update_start_;
};

/// Lower triangle: the diagonal blocks, and the blocks at the slots of a pattern.
struct BlockMatrix {
  explicit BlockMatrix(const BlockPattern& pattern)
      : diagonal(pattern.size()), off(pattern.blocks()) {}
  std::vector<Eigen::Matrix3d> diagonal, off;
};

/// Factorisation L d L' with unit lower triangular L and diagonal d, which has the signs of the
/// matrix's eigenvalues.
class BlockFactor {
 public:
  explicit BlockFactor(const BlockPattern& pattern);

  /// Factorises A after adding `absolute` plus `relative` times the trace of each block to its
  /// diagonal. Pivots below 1e-13 of their block's trace count as not positive.
  /// @return whether all pivots were positive; if not, only negative_direction() may be called
  bool factorise(const BlockMatrix& A, double absolute, double relative = 0);

  /// Solves A x = y in place.
  void solve(std::vector<Eigen::Vector3d>& y) const;

  /// Finds v with v' A v <= 0 from the first non-positive pivot of a failed factorise().
  [[nodiscard]] bool negative_direction(std::vector<Eigen::Vector3d>& v) const;

 private:
  const BlockPattern* pattern_;
  BlockMatrix A_;
  std::vector<Eigen::Matrix3d> W_;      // one column of L d
  std::vector<Eigen::Vector3d> l_, d_;  // (l10, l20, l21) and d of the diagonal blocks
  int bad_block_ = -1, bad_row_ = -1;   // location of the first non-positive pivot; -1: none
};

}  // namespace thenar::internal
