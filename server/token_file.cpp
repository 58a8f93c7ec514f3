#include "server/token_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "base/error.h"
#include "base/private_folder.h"

namespace thenar {
namespace {

/// Writes a new file that only the user can read. @return its status by fstat()
struct stat write_private(const std::string& path, const std::string& text) {
  (void)unlink(path.c_str());  // left over by a killed process with the same id
  const int file =
      open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
  require(file >= 0, "'{}' cannot be written: {}", path, std::strerror(errno));
  struct stat about {};
  const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
                       fstat(file, &about) == 0;
  (void)close(file);
  if (!written) (void)unlink(path.c_str());
  require(written, "'{}' cannot be written: is the disk full?", path);
  return about;
}

/// Returns the possible folders for tokens, in order of preference: $XDG_RUNTIME_DIR/thenar,
/// $XDG_CACHE_HOME/thenar, ~/.cache/thenar.
std::vector<std::string> token_folders() {
  std::vector<std::string> folders;
  const auto add = [&](const char* variable, const char* below) {
    const char* place = std::getenv(variable);
    if (place != nullptr && place[0] == '/') folders.push_back(std::string(place) + below);
  };
  add("XDG_RUNTIME_DIR", "/thenar");
  add("XDG_CACHE_HOME", "/thenar");
  add("HOME", "/.cache/thenar");
  return folders;
}

}  // namespace

TokenFile::TokenFile(int port, const std::string& token) {
  std::string reason = "none of XDG_RUNTIME_DIR, XDG_CACHE_HOME and HOME is set";
  // Use the first folder that can be made private.
  for (const std::string& folder : token_folders()) {
    try {
      make_private_folder(folder, ExistingFolder::kIsClosed);
      const std::string path = fmt::format("{}/{}.token", folder, port);
      const std::string temporary = fmt::format("{}.{}", path, getpid());
      const struct stat about = write_private(temporary, token + "\n");
      // Replace the file atomically.
      const bool renamed = std::rename(temporary.c_str(), path.c_str()) == 0;
      const int error = errno;
      if (!renamed) (void)unlink(temporary.c_str());
      require(renamed, "'{}' cannot be written: {}", path, std::strerror(error));
      path_ = path;
      device_ = about.st_dev;
      number_ = about.st_ino;
      return;
    } catch (const InputError& error) {
      reason = error.what();
    }
  }
  throw InputError("the token is kept in no file: " + reason);
}

TokenFile::~TokenFile() {
  struct stat about {};
  if (lstat(path_.c_str(), &about) == 0 && about.st_dev == device_ && about.st_ino == number_)
    (void)unlink(path_.c_str());
}

}  // namespace thenar
