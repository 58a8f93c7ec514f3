#pragma once

/// The folder of a run: identity of the run, draws so far, and the state to continue from.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sampling/run/chain_stream.h"

namespace thenar::internal {

/// Everything that the draws depend on, by name.
using RunIdentity = std::map<std::string, std::string>;

/// One process at a time works in a folder.
///
///   run.txt           the identity, "name = value" a line
///   group_<k>.draws   a ChainStream for each group
///   state.bin         how many columns of the streams count, and the state after them
///
/// Draws are appended first; then the new state replaces the old one by a rename. At whatever
/// moment a process is killed, the state on the disk and the columns that it counts belong
/// together.
class RunFolder {
 public:
  /// @param rows  of the streams (groups)
  /// @throws CheckpointError naming what differs, if the folder belongs to another run, or is
  /// damaged.
  /// @throws InputError if another process works in it, or nothing can be written there.
  RunFolder(const std::string& folder, const RunIdentity& identity,
            const std::vector<Eigen::Index>& rows);

  /// The state found when the folder was opened; none in a new folder, and none after commit().
  [[nodiscard]] const std::optional<std::string>& state() const { return state_; }

  /// Number of columns of each stream that the state counts.
  [[nodiscard]] long columns() const { return columns_; }

  /// Adds columns to every stream, and makes `state` the state after them.
  /// @param added  of each group, all with as many columns (rows, columns)
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
