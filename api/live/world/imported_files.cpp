#include "api/live/world/imported_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "base/error.h"
#include "base/file_io.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCopied = 1UL << 30U;  // of a file that was dropped [bytes]

fs::path whole_path(const WorldSpec& world, const PlacedHand& hand) {
  return fs::absolute(fs::path(world.folder) / hand.file).lexically_normal();
}

/// Whether two files have the same bytes; false also where one of them cannot be read.
bool same_bytes(const fs::path& a, const fs::path& b) {
  std::error_code failed;
  if (!fs::is_regular_file(b, failed)) return false;
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/// The files below a folder, as seen from it; none where it cannot be read.
std::set<fs::path> files_below(const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code failed;
  fs::recursive_directory_iterator next(folder, failed), end;
  for (; !failed && next != end; next.increment(failed))
    if (!next->is_directory(failed)) files.insert(next->path().lexically_relative(folder));
  return files;
}

/// Whether two folders hold the same files with the same bytes.
bool same_files(const fs::path& a, const fs::path& b) {
  const std::set<fs::path> files = files_below(a);
  return files == files_below(b) &&
         std::all_of(files.begin(), files.end(),
                     [&](const fs::path& file) { return same_bytes(a / file, b / file); });
}

/// Where a folder of imported files goes: to its own number in `folder`, or to the next free one.
fs::path place_of(const fs::path& from, const fs::path& folder, const SavedWorld& saved) {
  for (int number = std::stoi(from.filename().string());; ++number) {
    fs::path to = folder / std::to_string(number);
    const bool taken = std::any_of(saved.copies.begin(), saved.copies.end(), [&](const auto& copy) {
      return copy.second == to && copy.first != from;
    });
    if (!taken && (!fs::exists(fs::symlink_status(to)) || same_files(from, to))) return to;
  }
}

}  // namespace

std::string imported_file(const LiveWorld& live, const PlacedHand& hand) {
  if (hand.file.empty()) return "";
  return live.in_own_folder(whole_path(*live.state().header, hand).string());
}

std::string file_seen_from(const std::string& folder, const std::string& file) {
  return fs::proximate(fs::absolute(file).lexically_normal(),
                       fs::absolute(folder.empty() ? "." : folder).lexically_normal())
      .generic_string();
}

SavedWorld with_files_in(const LiveWorld& live, const fs::path& folder) {
  SavedWorld saved{spec_of(live.state()), {}};
  for (PlacedHand& hand : saved.world.hands) {
    const fs::path inside = imported_file(live, hand);
    if (inside.empty()) continue;
    // OWN/3/robot.urdf stands in OWN/3.
    const fs::path whole = whole_path(saved.world, hand);
    fs::path from = whole;
    for (auto part = std::next(inside.begin()); part != inside.end(); ++part)
      from = from.parent_path();
    const fs::path to = place_of(from, folder, saved);
    saved.copies.emplace_back(from, to);
    hand.file = file_seen_from(saved.world.folder, (to / whole.lexically_relative(from)).string());
  }
  return saved;
}

void write_copies(const SavedWorld& saved, const InsideFolder& folder) {
  for (const auto& [from, to] : saved.copies) {
    const fs::path name = to.lexically_relative(folder.path());
    // The same files, there from before.
    if (folder.entry(name.string()) != InsideFolder::Entry::kNothing) continue;
    try {
      for (const fs::path& file : files_below(from))
        folder.write((name / file).string(), read_file((from / file).string(), kMostCopied));
    } catch (const Error&) {
      std::error_code ignored;
      fs::remove_all(to, ignored);
      throw;
    }
  }
}

}  // namespace thenar
