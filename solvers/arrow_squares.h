#pragma once

/// Hessians of least squares in which blocks have more coordinates than rows.

#include <optional>
#include <vector>

#include <Eigen/Cholesky>

#include "solvers/arrow_factor.h"

namespace thenar {

/// A symmetric matrix over coordinates whose blocks meet only through shared ones:
///   H = S + sum over blocks of  (D + P'P - N'N),
/// S over shared coordinates, D diagonal over those of the block, P and N rows over both.
struct ArrowSquares {
  /// Rows over the shared coordinates, then those of a block (rows, shared + own).
  struct Rows {
    std::vector<Eigen::MatrixXd> plus, minus;
  };

  explicit ArrowSquares(const ArrowLayout& of);  // zero

  /// Adds J'J of rows that read the shared coordinates, then those of a block (-1: shared ones
  /// alone). Rows with a single entry, as priors have, cost next to nothing.
  void add(int block, const Eigen::MatrixXd& J);
  /// Subtracts J'J.
  void take(int block, const Eigen::MatrixXd& J);
  /// Multiplies all of it by a factor > 0.
  void scale(double factor);

  ArrowLayout layout;
  Eigen::MatrixXd shared;    // S (shared, shared)
  Eigen::VectorXd diagonal;  // D of all blocks (own blocks)
  std::vector<Rows> rows;    // of each block
};

/// Cholesky factor of such a matrix. Its cost grows with the number of blocks, with the coordinates
/// of one and with the square of its rows, where a factor of its entries grows with the cube of the
/// coordinates; it gains nothing with as many rows as these. Where rows of a Jacobian are at hand,
/// ArrowFactor keeps more digits.
///
/// With U = D^-1/2 over own columns, by Woodbury's formula, a block needs the Cholesky factors of
///   1 + P U U P'  =  L L'   and   1 - N U (1 - A'A) U N',   A = L^-1 P U;
/// H is positive definite over the block's own coordinates just where the second one exists.
/// Source: [GolubVanLoan2013] section 2.1.4; [Haynsworth1968] on when it exists.
class ArrowSquaresFactor {
 public:
  /// Factors the entries of coordinates that are free (size); the others stay where they are.
  /// @return nothing where H is not positive definite, or an own coordinate's D is not positive
  static std::optional<ArrowSquaresFactor> factor(const ArrowSquares& matrix,
                                                  const std::vector<bool>& free);

  /// H^-1 g over the free coordinates, 0 at the others (size).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& g) const;

 private:
  /// The block's inverse over own coordinates is  U (1 - own' W own) U,  what it leaves of S is
  /// shared' W shared,  W = 1 for the first `plus` rows and -1 for the others.
  struct Block {
    Eigen::VectorXd u;       // diagonal of U (own)
    Eigen::MatrixXd own;     // (rows, own)
    Eigen::MatrixXd shared;  // (rows, shared)
    Eigen::Index plus = 0;
  };
  static std::optional<Block> eliminate(const ArrowSquares& matrix, int block,
                                        const std::vector<bool>& free);

  explicit ArrowSquaresFactor(const ArrowLayout& layout) : layout_(layout) {}

  ArrowLayout layout_;
  std::vector<bool> free_;
  std::vector<Block> blocks_;
  Eigen::LLT<Eigen::MatrixXd> shared_;  // of what the blocks leave of it
};

}  // namespace thenar
