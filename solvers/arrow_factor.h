#pragma once

/// Least squares in which blocks of coordinates meet only through shared ones.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Layout of coordinates: `shared` ones first, then `blocks` times `own` of one block each.
/// An ordinary dense problem has shared coordinates alone.
struct ArrowLayout {
  int shared = 0, own = 0, blocks = 0;

  [[nodiscard]] int size() const { return shared + own * blocks; }
  [[nodiscard]] int first(int block) const { return shared + own * block; }  // index of its own
};

/// A symmetric matrix without the entries between two blocks: they are zero, or nobody asks for
/// them. It grows in proportion to the number of blocks.
struct ArrowMatrix {
  ArrowMatrix() = default;
  explicit ArrowMatrix(const ArrowLayout& of);  // zero

  /// The entries of shared coordinates, then of a block (-1: shared ones alone; so they are where
  /// blocks have no coordinates).
  [[nodiscard]] Eigen::MatrixXd of(int block) const;
  [[nodiscard]] Eigen::VectorXd diagonal() const;  // (size)

  ArrowLayout layout;
  Eigen::MatrixXd shared;              // (shared, shared)
  std::vector<Eigen::MatrixXd> own;    // of each block (own, own)
  std::vector<Eigen::MatrixXd> cross;  // of each block with the shared coordinates (own, shared)
};

/// Rows of a Jacobian that depend on the shared coordinates and on those of one block.
struct ArrowRows {
  int block = -1;          // -1: shared coordinates alone
  Eigen::MatrixXd shared;  // (rows, shared)
  Eigen::MatrixXd own;     // (rows, own); unused without a block
};

/// The factor of  J'J = R'R,  R upper triangular, by one QR factorisation a block and one of what
/// is left for the shared coordinates: its cost grows in proportion to the number of blocks, where
/// a dense factorisation grows with their cube. Working on J and not on J'J keeps all digits.
/// Source: [Bjorck1996] section 6.3, block angular problems.
class ArrowFactor {
 public:
  /// J must have full column rank, as it has where every coordinate has a prior.
  ArrowFactor(const ArrowLayout& layout, const std::vector<ArrowRows>& rows);

  /// R^-T g, so that |whiten(g)|^2 = g' (J'J)^-1 g  (size).
  [[nodiscard]] Eigen::VectorXd whiten(const Eigen::VectorXd& g) const;
  /// W = R^-T rows', so that rows (J'J)^-1 rows' = W'W, without the zeros of other blocks; of rows
  /// among those of J no column is longer than 1 (own + shared coordinates, rows).
  [[nodiscard]] Eigen::MatrixXd whiten(const ArrowRows& rows) const;
  /// R^-1 v, of covariance (J'J)^-1 where v is standard normal  (size).
  [[nodiscard]] Eigen::VectorXd colour(const Eigen::VectorXd& v) const;
  [[nodiscard]] Eigen::MatrixXd inverse() const;                      // (J'J)^-1 (size, size)
  [[nodiscard]] ArrowMatrix inverse_blocks() const;                   // the same within blocks
  [[nodiscard]] double log_determinant() const;                       // of J'J
  [[nodiscard]] double squared_norm(const Eigen::VectorXd& v) const;  // |J v|^2

 private:
  struct Block {
    Eigen::MatrixXd R, S;  // rows (R, S) of the factor: own and shared columns
  };
  ArrowLayout layout_;
  std::vector<Block> blocks_;
  Eigen::MatrixXd shared_;  // upper triangular (shared, shared)
};

/// The rows as one matrix (rows, size).
[[nodiscard]] Eigen::MatrixXd dense(const ArrowLayout& layout, const std::vector<ArrowRows>& rows);

/// Directions v, |v| = 1, that the rows do not determine, |J v| < tolerance: orthonormal columns,
/// in which blocks are connected by the shared coordinates only.
struct ArrowNullSpace {
  Eigen::MatrixXd together;            // shared coordinates, answered by every block (size, k)
  std::vector<Eigen::MatrixXd> alone;  // of each block, by itself (own, k of the block)
};

/// Null space of the `rows` of data; all directions of a block without rows are null. The cost
/// grows in proportion to the number of blocks.
/// @param tolerance  singular values below it count as zero; at least rounding of the largest
[[nodiscard]] ArrowNullSpace arrow_null_space(const ArrowLayout& layout,
                                              const std::vector<ArrowRows>& rows, double tolerance);

}  // namespace thenar
