#include "sampling/run/durable_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

/// Syncs the folder's entries to the disk. Not every file system supports it.
void sync_folder(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const int id = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0) return;
  (void)::fsync(id);
  (void)::close(id);
}

}  // namespace

AppendFile::AppendFile(std::string path)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (file_ < 0) fail("open");
}

AppendFile::~AppendFile() {
  if (file_ >= 0) (void)::close(file_);
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)), file_(other.file_) {
  other.file_ = -1;
}

void AppendFile::fail(const std::string& what) const {
  throw InputError(fmt::format("cannot {} '{}': {}", what, path_, std::strerror(errno)));
}

void AppendFile::truncate(std::int64_t bytes) {
  if (::ftruncate(file_, bytes) != 0) fail("cut");
}

void AppendFile::append(const std::string& bytes) {
  if (::lseek(file_, 0, SEEK_END) < 0) fail("write");
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("write");
    done += static_cast<std::size_t>(count);
  }
}

void AppendFile::sync() {
  if (::fsync(file_) != 0) fail("write");
}

std::int64_t AppendFile::size() const {
  const off_t size = ::lseek(file_, 0, SEEK_END);
  if (size < 0) fail("read");
  return size;
}

std::string AppendFile::read(std::int64_t from, std::int64_t bytes) const {
  std::string content(static_cast<std::size_t>(bytes), '\0');
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::pread(file_, content.data() + done, content.size() - done,
                                  from + static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read");
    require(count > 0, "'{}' ends too early: wanted {} bytes from {}", path_, bytes, from);
    done += static_cast<std::size_t>(count);
  }
  return content;
}

// NOLINTNEXTLINE(readability-make-member-function-const): it changes the file on disk
bool AppendFile::lock() {
  // Proceed on file systems without locks.
  return ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void replace_file(const std::string& path, const std::string& bytes) {
  // Write all bytes to the disk first.
  const std::string name = path + ".tmp";
  {
    AppendFile file(name);
    file.truncate(0);
    file.append(bytes);
    file.sync();
  }
  // Then replace the old file by a rename.
  std::error_code error;
  fs::rename(name, path, error);
  require(!error, "cannot rename '{}' to '{}': {}", name, path, error.message());
  sync_folder(path);
}

}  // namespace thenar::internal
