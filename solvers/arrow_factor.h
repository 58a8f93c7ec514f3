#pragma once

/// Least-squares problems with block-arrow structure: blocks of coordinates are coupled only by
/// shared coordinates.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Layout of the coordinates: `shared` ones first, then `own` coordinates for each of `blocks`
/// blocks. A dense problem has only shared coordinates.
struct ArrowLayout {
  int shared = 0, own = 0, blocks = 0;

  [[nodiscard]] int size() const { return shared + own * blocks; }
  /// Returns the index of a block's first own coordinate.
  [[nodiscard]] int first_index(int block) const { return shared + own * block; }
};

/// Symmetric matrix without the entries between two different blocks, which are either zero or not
/// needed. Its storage grows in proportion to the number of blocks.
struct ArrowMatrix {
  ArrowMatrix() = default;
  explicit ArrowMatrix(const ArrowLayout& arrow);  // zero matrix

  /// Returns the entries of the shared coordinates, followed by those of one block
  /// (shared + own, shared + own); only the shared entries for block -1 or if blocks have no
  /// coordinates.
  [[nodiscard]] Eigen::MatrixXd block_entries(int block) const;
  [[nodiscard]] Eigen::VectorXd diagonal() const;  // (size)

  ArrowLayout layout;
  Eigen::MatrixXd shared;            // (shared, shared)
  std::vector<Eigen::MatrixXd> own;  // diagonal block of each block (own, own)
  // Entries of each block with the shared coordinates (own, shared)
  std::vector<Eigen::MatrixXd> cross;
};

/// Rows of a Jacobian that depend on the shared coordinates and on those of one block.
struct ArrowRows {
  int block = -1;          // index of the block; -1: the rows depend on shared coordinates only
  Eigen::MatrixXd shared;  // (rows, shared)
  Eigen::MatrixXd own;     // (rows, own); unused without a block
};

/// Factor R, upper triangular, of  J'J = R'R,  computed by one QR factorisation per block and one
/// of the remaining rows of the shared coordinates. The cost is proportional to the number of
/// blocks; that of a dense factorisation grows with its cube. Factorising J rather than J'J does
/// not square the condition number. Source: [Bjorck1996] section 6.3, block angular problems.
class ArrowFactor {
 public:
  /// Factorises J, which must have full column rank; a prior on every coordinate ensures that.
  ArrowFactor(const ArrowLayout& layout, const std::vector<ArrowRows>& rows);

  /// Returns R^-T g, so that |whiten(g)|^2 = g' (J'J)^-1 g  (size).
  [[nodiscard]] Eigen::VectorXd whiten(const Eigen::VectorXd& g) const;
  /// Returns W = R^-T rows' without the zeros of the other blocks, so that rows (J'J)^-1 rows' =
  /// W'W (own + shared coordinates, rows). If the rows belong to J, no column is longer than 1.
  [[nodiscard]] Eigen::MatrixXd whiten(const ArrowRows& rows) const;
  /// Returns R^-1 v, which has covariance (J'J)^-1 if v is standard normal (size).
  [[nodiscard]] Eigen::VectorXd unwhiten(const Eigen::VectorXd& v) const;
  [[nodiscard]] Eigen::MatrixXd inverse() const;                      // (J'J)^-1 (size, size)
  [[nodiscard]] ArrowMatrix inverse_blocks() const;                   // (J'J)^-1 within blocks
  [[nodiscard]] double log_determinant() const;                       // log det(J'J)
  [[nodiscard]] double squared_norm(const Eigen::VectorXd& v) const;  // |J v|^2

 private:
  struct Block {
    Eigen::MatrixXd R, S;  // rows (R, S) of the factor: own and shared columns
  };
  ArrowLayout layout_;
  std::vector<Block> blocks_;
  Eigen::MatrixXd shared_;  // upper triangular (shared, shared)
};

/// Returns the rows as one dense matrix (rows, size).
[[nodiscard]] Eigen::MatrixXd dense_rows(const ArrowLayout& layout,
                                         const std::vector<ArrowRows>& rows);

/// Orthonormal basis of the directions v, |v| = 1, that the rows do not determine: |J v| <
/// tolerance. Only directions that involve shared coordinates couple blocks.
struct ArrowNullSpace {
  Eigen::MatrixXd coupled;  // directions that involve shared coordinates, with the response of
                            // every block (size, k)
  // Directions within each block, shared coordinates at rest (own, k of the block)
  std::vector<Eigen::MatrixXd> own;
};

/// Computes the null space of the `rows`; all directions of a block without rows belong to it. The
/// cost is proportional to the number of blocks.
/// @param tolerance  singular values below it count as zero; it is at least the rounding of the
///         largest one
[[nodiscard]] ArrowNullSpace arrow_null_space(const ArrowLayout& layout,
                                              const std::vector<ArrowRows>& rows, double tolerance);

}  // namespace thenar
