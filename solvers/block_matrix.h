#pragma once

/// Symmetric matrices of 3 x 3 blocks with one fixed pattern, and their factorisation.

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// Pattern of nonzero blocks, fill of the factorisation included. Rows stand in elimination order.
class BlockPattern {
 public:
  /// @param edges  pairs of rows that are joined, rows numbered from 0 to n - 1
  BlockPattern(int n, const std::vector<std::pair<int, int>>& edges);

  [[nodiscard]] int size() const { return static_cast<int>(place_.size()); }
  [[nodiscard]] int blocks() const { return static_cast<int>(row_.size()); }
  /// Returns the position of a row in elimination order.
  [[nodiscard]] int place(int row) const { return place_[row]; }
  /// Slot of the block (i, j), i > j both in elimination order; -1: none.
  [[nodiscard]] int slot(int i, int j) const;

  /// Rows (i, j) of a slot.
  [[nodiscard]] std::pair<int, int> rows_of(int slot) const { return {row_[slot], column_[slot]}; }

  struct Update {
    int left, right, target;  // block[target] -= W[left] V[right]'; target < 0: diagonal ~target
  };

 private:
  friend class BlockFactor;
  std::vector<int> place_, start_, row_, column_;  // columns start_[k] .. start_[k + 1] of row_
  std::vector<Update> update_;
  std::vector<int> update_start_;
};

/// The lower half: diagonal blocks and the blocks of a pattern's slots.
struct BlockMatrix {
  explicit BlockMatrix(const BlockPattern& pattern)
      : diagonal(pattern.size()), off(pattern.blocks()) {}
  std::vector<Eigen::Matrix3d> diagonal, off;
};

/// Factorisation L d L' with unit lower L and d diagonal: the signs of d are those of the matrix.
class BlockFactor {
 public:
  explicit BlockFactor(const BlockPattern& pattern);

  /// Factorises A with `absolute` and `relative` times a block's trace added to its diagonal.
  /// Pivots below 1e-13 of their block's trace count as not positive.
  /// @return whether all pivots were positive; if not, the factor serves negative_direction() only
  bool factorise(const BlockMatrix& A, double absolute, double relative = 0);

  /// Solves in place.
  void solve(std::vector<Eigen::Vector3d>& y) const;

  /// Finds v with v' A v <= 0 after a failed factorise(), from its first bad pivot.
  [[nodiscard]] bool negative_direction(std::vector<Eigen::Vector3d>& v) const;

 private:
  const BlockPattern* pattern_;
  BlockMatrix A_;
  std::vector<Eigen::Matrix3d> W_;      // one column of L d
  std::vector<Eigen::Vector3d> l_, d_;  // (l10, l20, l21) and d of the diagonal blocks
  int bad_block_ = -1, bad_row_ = -1;
};

}  // namespace thenar::internal
