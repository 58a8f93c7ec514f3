#pragma once

/// Symmetric matrices over coordinates whose blocks meet only through shared ones.

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

  /// Adds a matrix over the shared coordinates, then those of a block (-1: shared ones alone).
  void add(int block, const Eigen::MatrixXd& part);
  /// Adds factor times another matrix of the same layout.
  void add(const ArrowMatrix& other, double factor);
  /// The entries of shared coordinates, then of a block (-1: shared ones alone; so they are where
  /// blocks have no coordinates).
  [[nodiscard]] Eigen::MatrixXd of(int block) const;
  [[nodiscard]] Eigen::VectorXd diagonal() const;  // (size)

  ArrowLayout layout;
  Eigen::MatrixXd shared;              // (shared, shared)
  std::vector<Eigen::MatrixXd> own;    // of each block (own, own)
  std::vector<Eigen::MatrixXd> cross;  // of each block with the shared coordinates (own, shared)
};

}  // namespace thenar
