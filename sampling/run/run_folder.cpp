#include "sampling/run/run_folder.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/provenance.h"
#include "sampling/methods/state_bytes.h"
#include "sampling/run/run_chains.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigestDigits = 64;  // hexadecimal digits of a SHA-256

std::string text_of(const RunIdentity& identity) {
  std::string text;
  for (const auto& [name, value] : identity) text += fmt::format("{} = {}\n", name, value);
  return text;
}

std::string content_of(const std::string& path) {
  // Maximum file size: the state of thousands of chains [bytes]
  constexpr std::size_t kMaxStateBytes = 1'000'000'000;
  try {
    return read_file(path, kMaxStateBytes);
  } catch (const DataError& error) {
    throw InputError(error.what());
  }
}

RunIdentity parse_identity(const std::string& text) {
  RunIdentity identity;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto sign = line.find(" = ");
    if (sign != std::string::npos) identity[line.substr(0, sign)] = line.substr(sign + 3);
  }
  return identity;
}

/// Lists the entries that differ: "seed (was 1, is 2), ...".
std::string differences(RunIdentity was, RunIdentity is) {
  // Entries that only one of them has count as different.
  for (const auto& [name, value] : is) was.emplace(name, "not there");
  std::string text;
  for (const auto& [name, value] : was) {
    const std::string& now = is.emplace(name, "not there").first->second;
    if (value == now) continue;
    text += fmt::format("{}{} (was {}, is {})", text.empty() ? "" : ", ", name, value, now);
  }
  return text;
}

/// Compares the identity of the folder, or stores it in a new folder.
void check_identity(const std::string& folder, const RunIdentity& identity) {
  const std::string path = folder + "/run.txt";
  // A new folder gets the identity; a state without one is an error.
  if (!fs::exists(path)) {
    if (fs::exists(folder + "/state.bin"))
      throw CheckpointError(CheckpointError::Kind::kDamaged,
                            fmt::format("folder '{}' has a checkpoint but no run.txt", folder));
    replace_file(path, text_of(identity));
    return;
  }
  // An existing folder must have the same identity.
  const std::string differing = differences(parse_identity(content_of(path)), identity);
  if (!differing.empty())
    throw CheckpointError(
        CheckpointError::Kind::kOtherRun,
        fmt::format("the checkpoint in '{}' belongs to another run; what differs: {}", folder,
                    differing));
}

}  // namespace

RunFolder::RunFolder(const std::string& folder, const RunIdentity& identity,
                     const std::vector<Eigen::Index>& rows)
    : folder_(folder) {
  // Create and lock the folder.
  std::error_code error, none;
  fs::create_directories(folder, error);
  require(fs::is_directory(folder, none), "cannot make folder '{}' for checkpoints: {}", folder,
          error.message());
  lock_.emplace(folder + "/lock");
  require(lock_->lock(), "another process is sampling in '{}'", folder);
  check_identity(folder, identity);
  // Read the state, and truncate the streams to the valid columns.
  try {
    read_state();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      streams_.emplace_back(fmt::format("{}/group_{:03}.draws", folder, k), rows[k]);
      streams_.back().resume(columns_);
    }
  } catch (const InputError& damage) {
    throw CheckpointError(CheckpointError::Kind::kDamaged, damage.what());
  }
}

void RunFolder::read_state() {
  // Check the digest at the start of the file.
  const std::string path = folder_ + "/state.bin";
  if (!fs::exists(path)) return;
  const std::string content = content_of(path);
  require(content.size() > kDigestDigits &&
              sha256(content.substr(kDigestDigits)) == content.substr(0, kDigestDigits),
          "the checkpoint '{}' is damaged", path);
  StateReader reader(content.substr(kDigestDigits));
  columns_ = reader.integer();
  state_ = reader.bytes();
}

void RunFolder::commit(const std::vector<Eigen::MatrixXd>& added, const std::string& state) {
  // Append columns first: they do not count until the state is updated.
  for (std::size_t k = 0; k < streams_.size(); ++k) {
    if (added[k].cols() == 0) continue;
    streams_[k].append(added[k]);
    streams_[k].sync();
  }
  // Then replace the state.
  const long columns = columns_ + (added.empty() ? 0 : added[0].cols());
  StateWriter writer;
  writer.write(std::int64_t{columns});
  writer.write_bytes(state);
  replace_file(folder_ + "/state.bin", sha256(writer.bytes()) + writer.bytes());
  columns_ = columns;
  state_.reset();  // only needed once
}

}  // namespace thenar::internal
