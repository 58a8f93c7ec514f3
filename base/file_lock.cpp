#include "base/file_lock.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace thenar {
namespace {

/// Whether an open file still has that name: its last holder removes it.
bool is_named(int file, const std::string& name) {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(name.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Where links lead, also to a file that is yet to come: two names of one file are one lock.
std::string file_behind(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::error_code none;
  std::filesystem::path file = path;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(file, none); ++i)
    file = file.parent_path() / std::filesystem::read_symlink(file, none);
  const std::filesystem::path real = std::filesystem::weakly_canonical(file, none);
  return none ? path : real.string();
}

}  // namespace

FileLock::FileLock(const std::string& path) : name_(file_behind(path) + ".lock") {
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
