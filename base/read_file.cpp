#include "base/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

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

  /// As the file system tells it; another process may change it while we read [bytes].
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The first bytes: `most`, or as many as there are.
  [[nodiscard]] std::string first(std::size_t most) const {
    std::string bytes(std::min(most, size_ + 1), '\0');
    std::size_t count = 0;
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
  std::string bytes = file.first(most + 1);  // it may have grown meanwhile
  if (bytes.size() > most) refuse_size(bytes.size());
  return bytes;
}

std::string read_start(const std::string& path, std::size_t count) {
  return RegularFile(path).first(count);
}

}  // namespace thenar
