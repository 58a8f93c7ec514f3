#pragma once

/// Small linear systems without the heap.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// The factors  P R = L U  with pivots of the largest size in a column, written over R.
///
/// Eigen's PartialPivLU asks the heap for its permutation on every change of size; this one keeps
/// it. Blocks along the diagonal with nothing beside them, such as contacts of fingers that share
/// no joint, are factored one by one. Meant for up to some hundred rows.
class InPlaceLu {
 public:
  /// @param R  (n, n); overwritten, and has to stay as it is while solve() is used
  /// @returns false where a pivot is zero or not finite
  [[nodiscard]] bool factor(Eigen::Ref<Eigen::MatrixXd> R);

  /// y becomes R^-1 y.
  /// @param factors  what factor() left in R (n, n);  @param y  (n)
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& factors, Eigen::Ref<Eigen::VectorXd> y) const;

 private:
  /// Rows of a block, the end excluded.
  struct Block {
    Eigen::Index begin, end;
  };
  void find_blocks(const Eigen::Ref<const Eigen::MatrixXd>& R);

  std::vector<Eigen::Index> pivots_;
  std::vector<Block> blocks_;
};

}  // namespace thenar
