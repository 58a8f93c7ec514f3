#pragma once

/// File of draws: columns of numbers, appended in blocks that are verified when read.

#include <string>

#include <Eigen/Core>

#include "sampling/run/durable_file.h"

namespace thenar::internal {

/// File of columns. Each block contains rows and columns (64-bit integers), the first 16
/// hexadecimal digits of the SHA-256 of its numbers, and the numbers, column by column, little
/// endian.
class ChainStream {
 public:
  /// @param rows  length of a column
  ChainStream(const std::string& path, Eigen::Index rows) : file_(path), rows_(rows) {}

  /// Keeps the first blocks, `columns` columns in all, and truncates the rest, which a process
  /// killed during a write may have left.
  /// @throws InputError if there are fewer intact columns, or if no block ends there.
  void resume(long columns);

  /// Appends a block of columns.
  void append(const Eigen::Ref<const Eigen::MatrixXd>& columns);
  void sync() { file_.sync(); }

  /// Reads all columns (rows, columns).
  [[nodiscard]] Eigen::MatrixXd read() const;

 private:
  [[nodiscard]] Eigen::MatrixXd read_block(std::int64_t& at) const;

  AppendFile file_;
  Eigen::Index rows_;
};

}  // namespace thenar::internal
