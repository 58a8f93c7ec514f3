#pragma once

/// Block-arrow Hessians of least squares whose blocks have more coordinates than rows.

#include <optional>
#include <vector>

#include <Eigen/Cholesky>

#include "solvers/arrow_factor.h"

namespace thenar {

/// Symmetric matrix over coordinates with block-arrow structure:
///   H = S + sum over blocks of  (D + P'P - N'N),
/// with S over the shared coordinates, D diagonal over those of the block, and P and N over both.
struct ArrowSquares {
  /// Rows P and N over the shared coordinates, then those of a block (rows, shared + own).
  struct Rows {
    std::vector<Eigen::MatrixXd> plus, minus;
  };

  explicit ArrowSquares(const ArrowLayout& arrow);  // zero matrix

  /// Adds J'J. The columns of J are the shared coordinates, then those of the block (-1: only
  /// shared coordinates). Rows with a single entry, such as those of priors, only change the
  /// diagonal.
  void add(int block, const Eigen::MatrixXd& J);
  /// Subtracts J'J; arguments as for add().
  void subtract(int block, const Eigen::MatrixXd& J);
  /// Multiplies the matrix by a factor > 0.
  void scale(double factor);

  ArrowLayout layout;
  Eigen::MatrixXd shared;    // S (shared, shared)
  Eigen::VectorXd diagonal;  // D of all blocks (own * blocks)
  std::vector<Rows> rows;    // P and N of each block
};

/// Cholesky factor of an ArrowSquares matrix. The cost is proportional to the number of blocks, to
/// the coordinates of a block and to the square of its number of rows; that of a dense
/// factorisation grows with the cube of the coordinates. There is no gain if a block has as many
/// rows as coordinates. If the rows of a Jacobian are available, ArrowFactor is more accurate.
///
/// With U = D^-1/2 over own columns, by Woodbury's formula, a block needs the Cholesky factors of
///   1 + P U U P'  =  L L'   and   1 - N U (1 - A'A) U N',   A = L^-1 P U;
/// H is positive definite over the block's own coordinates if and only if the second factor exists.
/// Source: [GolubVanLoan2013] section 2.1.4; [Haynsworth1968] for its existence.
class ArrowSquaresFactor {
 public:
  /// Factorises the matrix over the free coordinates; the others are held fixed.
  /// @param free  true for each free coordinate (size)
  /// @return nothing if H is not positive definite, or if D of a free own coordinate is not
  ///         positive
  static std::optional<ArrowSquaresFactor> factor(const ArrowSquares& matrix,
                                                  const std::vector<bool>& free);

  /// Returns H^-1 g over the free coordinates, 0 at the others (size).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& g) const;

 private:
  /// Elimination of one block: its inverse over own coordinates is  U (1 - own' W own) U,  and its
  /// Schur complement in S is  shared' W shared,  with W = 1 for the first `plus` rows and -1 for
  /// the others.
  struct Block {
    Eigen::VectorXd u;       // diagonal of U (own)
    Eigen::MatrixXd own;     // (rows, own)
    Eigen::MatrixXd shared;  // (rows, shared)
    Eigen::Index plus = 0;   // number of rows with weight 1
  };
  static std::optional<Block> eliminate(const ArrowSquares& matrix, int block,
                                        const std::vector<bool>& free);

  explicit ArrowSquaresFactor(const ArrowLayout& layout) : layout_(layout) {}

  ArrowLayout layout_;
  std::vector<bool> free_;
  std::vector<Block> blocks_;
  Eigen::LLT<Eigen::MatrixXd> shared_;  // factor of the Schur complement
};

}  // namespace thenar
