#pragma once

/// Folder of a run: identity of the run, draws so far, and the state to resume from.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sampling/run/chain_stream.h"

namespace thenar::internal {

/// Everything that the draws depend on, by name.
using RunIdentity = std::map<std::string, std::string>;

/// Run folder; only one process at a time can open it.
///
///   run.txt           the identity, one "name = value" per line
///   group_<k>.draws   a ChainStream for each group
///   state.bin         the number of valid columns of the streams, and the state after them
///
/// Draws are appended first; then the new state replaces the old one by a rename. So the state on
/// the disk and the columns that it counts are consistent at whatever moment a process is killed.
class RunFolder {
 public:
  /// @param rows  length of a column of each stream (groups)
  /// @throws CheckpointError that names the difference if the folder belongs to another run, or is
  ///         damaged.
  /// @throws InputError if another process uses it, or it is not writable.
  RunFolder(const std::string& folder, const RunIdentity& identity,
            const std::vector<Eigen::Index>& rows);

  /// Returns the state found when the folder was opened; none in a new folder, and none after
  /// commit().
  [[nodiscard]] const std::optional<std::string>& state() const { return state_; }

  /// Returns the number of columns of each stream that the state counts.
  [[nodiscard]] long columns() const { return columns_; }

  /// Appends columns to every stream, and stores `state` as the state after them.
  /// @param added  new columns of each group, equal in number (rows, columns)
  void commit(const std::vector<Eigen::MatrixXd>& added, const std::string& state);

  [[nodiscard]] Eigen::MatrixXd read(std::size_t group) const { return streams_[group].read(); }

 private:
  void read_state();

  std::string folder_;
  std::optional<AppendFile> lock_;
  std::vector<ChainStream> streams_;
  std::optional<std::string> state_;
  long columns_ = 0;
};

}  // namespace thenar::internal
