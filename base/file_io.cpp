#include "base/file_io.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/error.h"

namespace thenar {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw DataError(path, 1, what);
}

std::string kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

/// A regular file, open for reading.
class RegularFile {
 public:
  explicit RegularFile(const std::string& path)
      // A pipe would wait for its writer here, a terminal would become ours.
      : path_(path), file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    if (file_ < 0) refuse(path_, fmt::format("cannot be read: {}", std::strerror(errno)));
    // Regular files only.
    struct stat about {};
    const bool known = fstat(file_, &about) == 0;
    if (known && S_ISREG(about.st_mode)) {
      size_ = static_cast<std::size_t>(about.st_size);
      return;
    }
    (void)close(file_);
    refuse(path_, fmt::format("cannot be read: wanted a file, got {}",
                              known ? kind_of(about.st_mode) : "nothing"));
  }
  ~RegularFile() { (void)close(file_); }
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  /// Returns the size that the file system states; another process may change it while we read
  /// [bytes].
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Returns the first `most` bytes, or as many as there are.
  [[nodiscard]] std::string first(std::size_t most) const {
    std::string bytes(std::min(most, size_ + 1), '\0');
    std::size_t count = 0;
    // Until `most` bytes, or the end.
    while (count < most) {
      if (count == bytes.size()) bytes.resize(std::min(most, 2 * bytes.size()));
      const ssize_t got = ::read(file_, bytes.data() + count, bytes.size() - count);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) refuse(path_, fmt::format("cannot be read: {}", std::strerror(errno)));
      if (got == 0) break;
      count += static_cast<std::size_t>(got);
    }
    bytes.resize(count);
    return bytes;
  }

 private:
  const std::string& path_;
  int file_;
  std::size_t size_ = 0;
};

}  // namespace

bool is_file(const std::string& path) {
  struct stat about {};
  return stat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode);
}

std::string read_file(const std::string& path, std::size_t most) {
  const RegularFile file(path);
  const auto refuse_size = [&](std::size_t size) {
    refuse(path, fmt::format("wanted at most {} bytes, got {}", most, size));
  };
  if (file.size() > most) refuse_size(file.size());
  std::string bytes = file.first(most + 1);  // may have grown since its size was read
  if (bytes.size() > most) refuse_size(bytes.size());
  return bytes;
}

std::string read_start(const std::string& path, std::size_t count) {
  return RegularFile(path).first(count);
}

namespace {

namespace fs = std::filesystem;

/// New file beside `path` with an unused name; removed unless it is renamed.
class Temporary {
 public:
  explicit Temporary(const std::string& path) {
    // The first name that is free.
    // Most names tried; killed runs leave some behind, and other runs hold some now
    constexpr int kMaxTemporaryNames = 1000;
    for (int i = 0; i < kMaxTemporaryNames && !file_; ++i) {
      name_ = path + ".tmp" + (i == 0 ? "" : std::to_string(i));
      file_ = std::fopen(name_.c_str(), "wbx");  // x: fails where the file exists
      if (!file_ && errno != EEXIST) break;
    }
    require(file_ != nullptr, "cannot write '{}'", path);
  }
  ~Temporary() {
    if (file_) (void)std::fclose(file_);
    if (!name_.empty()) (void)std::remove(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// Writes and closes; a full disk may show only then.
  void write(const std::string& content) {
    const bool written = std::fwrite(content.data(), 1, content.size(), file_) == content.size();
    const bool closed = std::fclose(file_) == 0;
    file_ = nullptr;
    require(written && closed, "cannot write '{}': is the disk full?", name_);
  }

  void rename(const std::string& path) {
    std::error_code error;
    fs::rename(name_, path, error);
    require(!error, "cannot rename '{}' to '{}': {}", name_, path, error.message());
    name_.clear();
  }

 private:
  std::string name_;
  std::FILE* file_ = nullptr;
};

/// Returns the target of a path when links are followed, whether it exists or not.
std::string behind_links(const std::string& path) {
  constexpr int kMaxLinks = 40;  // limit of Linux for followed links [1]
  fs::path place(path);
  std::error_code error;
  // One link after the other.
  for (int i = 0; fs::is_symlink(place, error); ++i) {
    require(i < kMaxLinks, "cannot write '{}': its links lead in a circle", path);
    const fs::path target = fs::read_symlink(place, error);
    require(!error, "cannot write '{}': {}", path, error.message());
    place = place.parent_path() / target;
  }
  return place.string();
}

/// A place for a file, with its folder. @param path  without links
const std::string& ready(const std::string& path) {
  std::error_code error;
  require(!fs::exists(path, error) || fs::is_regular_file(path, error),
          "cannot write '{}': it is not a file but a folder or a device", path);
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  return path;
}

}  // namespace

void require_writable(const std::string& path) { const Temporary file(ready(behind_links(path))); }

void write_file(const std::string& path, const std::string& content) {
  const std::string place = behind_links(path);
  Temporary file(ready(place));
  file.write(content);
  file.rename(place);
}

void write_files(const std::vector<std::pair<std::string, std::string>>& files) {
  // All are written before the first is renamed.
  std::vector<std::string> places;
  std::vector<std::unique_ptr<Temporary>> written;  // removed where one of them fails
  for (const auto& [path, content] : files) {
    places.push_back(behind_links(path));
    written.push_back(std::make_unique<Temporary>(ready(places.back())));
    written.back()->write(content);
  }
  for (std::size_t i = 0; i < written.size(); ++i) written[i]->rename(places[i]);
}

namespace {

/// Returns whether an open file still has that name: its last holder removes it.
bool is_named(int file, const std::string& name) {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(name.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Returns the file behind links, also one that does not exist yet, so that two names of one file
/// share one lock.
std::string file_behind(const std::string& path) {
  constexpr int kMaxLinks = 40;  // limit of Linux for followed links [1]
  std::error_code none;
  std::filesystem::path file = path;
  for (int i = 0; i < kMaxLinks && std::filesystem::is_symlink(file, none); ++i)
    file = file.parent_path() / std::filesystem::read_symlink(file, none);
  const std::filesystem::path real = std::filesystem::weakly_canonical(file, none);
  return none ? path : real.string();
}

}  // namespace

FileLock::FileLock(const std::string& path) : name_(file_behind(path) + ".lock") {
  // Repeated if another process removed the file meanwhile.
  do {
    if (file_ >= 0) (void)close(file_);
    file_ = open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    require(file_ >= 0, "cannot open '{}': {}", name_, std::strerror(errno));
    // A file system without locks has to do without.
    if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) continue;
    (void)close(file_);
    throw InputError(fmt::format("another process works on '{}'", path));
  } while (!is_named(file_, name_));
}

FileLock::~FileLock() {
  (void)unlink(name_.c_str());
  (void)close(file_);
}

}  // namespace thenar
