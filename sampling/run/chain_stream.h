#pragma once

/// Draws on the disk: columns of numbers, appended in blocks that are checked when they are read.

#include <string>

#include <Eigen/Core>

#include "sampling/run/durable_file.h"

namespace thenar::internal {

/// A file of columns. Each block is  rows, columns (64-bit integers), the first 16 hexadecimal
/// digits of the SHA-256 of its numbers, and the numbers, column by column, little endian.
class ChainStream {
 public:
  /// @param rows  numbers of one column
  ChainStream(const std::string& path, Eigen::Index rows) : file_(path), rows_(rows) {}

  /// Keeps the first blocks, `columns` in all, and forgets what stands behind, as left by a
  /// process that was killed within a write.
  /// @throws InputError if there are fewer sound ones, or if no block ends there.
  void resume(long columns);

  void append(const Eigen::Ref<const Eigen::MatrixXd>& columns);
  void sync() { file_.sync(); }

  /// All of it (rows, columns).
  [[nodiscard]] Eigen::MatrixXd read() const;

 private:
  [[nodiscard]] Eigen::MatrixXd read_block(std::int64_t& at) const;

  AppendFile file_;
  Eigen::Index rows_;
};

}  // namespace thenar::internal
