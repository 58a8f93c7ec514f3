#include "base/cache.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "base/private_folder.h"
#include "base/provenance.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

const std::string kHeading = "thenar cache 1\n";
const std::string kEnding = ".thenar";
const std::string kUnfinished = ".unfinished";
constexpr std::size_t kHashDigits = 64;  // Hexadecimal digits of a hash
// Age from which an unfinished file belongs to no running process [s]
constexpr double kUnfinishedAge = 3600;
constexpr double kKeptShare = 0.9;  // Share of the limit that remains after entries are removed [1]

std::mutex& guard() {
  static std::mutex mutex;
  return mutex;
}

CacheOptions& options_in_use() {
  static CacheOptions options;
  return options;
}

CacheOptions current_options() {
  const std::lock_guard lock(guard());
  return options_in_use();
}

/// Returns an identifier of the build, as another build may compute other results.
const std::string& build_id() {
  static const std::string id = [] {
    // Versions of libraries, and size and time of the program's file, which a rebuild changes.
    std::string text;
    for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
    struct stat program {};
    if (::stat("/proc/self/exe", &program) == 0)
      text += fmt::format("{} {}.{:09}\n", program.st_size, program.st_mtim.tv_sec,
                          program.st_mtim.tv_nsec);
    return text;
  }();
  return id;
}

std::string name_of_entry(const std::string& kind, const std::string& input) {
  return sha256(fmt::format("{}\n{}\n{}\n", build_id(), kind, input.size()) + input);
}

bool has_ending(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

bool is_entry(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() == kHashDigits + kEnding.size() && has_ending(name, kEnding) &&
         name.find_first_not_of("0123456789abcdef") == kHashDigits;
}

struct Entry {
  fs::path path;
  std::uintmax_t size;
  fs::file_time_type used;
};

/// Entries in the folder; files that others left half-written long ago are removed.
std::vector<Entry> entries_in(const std::string& folder) {
  std::vector<Entry> entries;
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now();
  // Entries by their names; others only if they are old leftovers of ours.
  for (fs::directory_iterator at(folder, ignored), end; at != end; at.increment(ignored)) {
    if (ignored) break;
    std::error_code gone;  // another process may remove it
    if (!at->is_regular_file(gone)) continue;
    const fs::file_time_type used = at->last_write_time(gone);
    if (gone) continue;
    if (is_entry(at->path())) entries.push_back({at->path(), at->file_size(gone), used});
    const std::string name = at->path().filename().string();
    const bool unfinished = has_ending(name, kUnfinished) && name.size() > kHashDigits &&
                            name.find_first_not_of("0123456789abcdef") == kHashDigits;
    if (unfinished && std::chrono::duration<double>(now - used).count() > kUnfinishedAge)
      fs::remove(at->path(), gone);
  }
  return entries;
}

/// The least recently used go until all fit.
void make_room(const CacheOptions& options) {
  // Sizes of all entries.
  std::vector<Entry> entries = entries_in(options.folder);
  std::uintmax_t total = 0;
  for (const Entry& entry : entries) total += entry.size;
  if (total <= options.max_bytes) return;
  // The least recently used go first.
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (static_cast<double>(total) <= kKeptShare * static_cast<double>(options.max_bytes)) return;
    std::error_code ignored;
    fs::remove(entry.path, ignored);
    total -= entry.size;
  }
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void write_entry(const CacheOptions& options, const std::string& name, const std::string& result) {
  static std::atomic<int> count{0};
  make_private_folder(options.folder,
                      options.own ? ExistingFolder::kIsClosed : ExistingFolder::kStays);
  const fs::path folder = options.folder;
  // Under a name of this process, renamed when complete.
  const fs::path unfinished =
      folder / fmt::format("{}.{}-{}{}", name, ::getpid(), count++, kUnfinished);
  bool whole = false;
  {
    std::ofstream file(unfinished, std::ios::binary);
    file << kHeading << name << sha256(result) << '\n' << result;
    file.close();
    whole = !file.fail();
  }
  std::error_code failed;
  if (whole) fs::rename(unfinished, folder / (name + kEnding), failed);
  if (!whole || failed) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    return;
  }
  make_room(options);
}

}  // namespace

void use_cache(const CacheOptions& options) {
  const std::lock_guard lock(guard());
  options_in_use() = options;
}

CacheOptions cache_options_of_user() {
  CacheOptions options;
  // The variable of thenar goes before those of the desktop; "off" turns the cache off.
  if (const char* folder = std::getenv("THENAR_CACHE"); folder != nullptr) {
    options.folder = std::string(folder) == "off" ? "" : folder;
  } else if (const std::string cache = environment("XDG_CACHE_HOME"); !cache.empty()) {
    options.folder = cache + "/thenar";
    options.own = true;
  } else if (const std::string home = environment("HOME"); !home.empty()) {
    options.folder = home + "/.cache/thenar";
    options.own = true;
  }
  // Sizes are stated in megabytes of 1e6 bytes.
  const double megabytes = std::strtod(environment("THENAR_CACHE_MB").c_str(), nullptr);
  if (megabytes > 0 && megabytes < 1e9)
    options.max_bytes = static_cast<std::uintmax_t>(1e6 * megabytes);
  return options;
}

std::optional<std::string> find_cached(const std::string& kind, const std::string& input) {
  const CacheOptions options = current_options();
  if (options.folder.empty()) return std::nullopt;
  const std::string name = name_of_entry(kind, input);
  const fs::path path = fs::path(options.folder) / (name + kEnding);
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return std::nullopt;
  try {
    // Heading, name and checksum must all match.
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t start = kHeading.size() + 2 * kHashDigits + 1;
    if (text.size() < start || text.compare(0, kHeading.size(), kHeading) != 0 ||
        text.compare(kHeading.size(), kHashDigits, name) != 0)
      return std::nullopt;
    std::string result = text.substr(start);
    if (text.compare(kHeading.size() + kHashDigits, kHashDigits, sha256(result)) != 0)
      return std::nullopt;
    fs::last_write_time(path, fs::file_time_type::clock::now(),
                        failed);  // marks it as recently used
    return result;
  } catch (const std::exception&) {
    return std::nullopt;  // unreadable
  }
}

void store_cached(const std::string& kind, const std::string& input, const std::string& result) {
  const CacheOptions options = current_options();
  if (options.folder.empty() || result.size() > options.max_bytes / 2) return;
  try {
    write_entry(options, name_of_entry(kind, input), result);
  } catch (const std::exception&) {
    // a cache that cannot be written is no reason to fail
  }
}

}  // namespace thenar
