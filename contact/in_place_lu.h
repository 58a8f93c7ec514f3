#pragma once

/// LU factorization of small matrices without memory allocation.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// LU factorization  P R = L U  with partial pivoting, in place.
///
/// Unlike Eigen's PartialPivLU it does not allocate memory on every change of size. Independent
/// diagonal blocks, such as contacts of fingers that share no joint, are factored separately. It is
/// meant for up to some hundred rows.
class InPlaceLu {
 public:
  /// Factors a matrix.
  /// @param R  matrix that is overwritten by its factors, needed by solve() (n, n)
  /// @returns false if a pivot is zero or not finite
  [[nodiscard]] bool factor(Eigen::Ref<Eigen::MatrixXd> R);

  /// Replaces y by R^-1 y.
  /// @param factors  result of factor() (n, n)
  /// @param y        right-hand side, replaced by the solution (n)
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& factors, Eigen::Ref<Eigen::VectorXd> y) const;

 private:
  /// Range of rows of a diagonal block, the end excluded.
  struct Block {
    Eigen::Index begin, end;
  };
  void find_blocks(const Eigen::Ref<const Eigen::MatrixXd>& R);

  std::vector<Eigen::Index> pivots_;
  std::vector<Block> blocks_;
};

}  // namespace thenar
