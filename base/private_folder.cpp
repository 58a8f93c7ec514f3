#include "base/private_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/error.h"

namespace thenar {

void make_private_folder(const std::string& path, ExistingFolder existing) {
  constexpr mode_t kOwnerMode = 0700;  // Permissions: all for the owner, none for others
  // Parents first.
  std::filesystem::path made;
  bool is_new = false;
  for (const auto& part : std::filesystem::path(path).lexically_normal()) {
    made /= part;
    is_new = mkdir(made.c_str(), kOwnerMode) == 0;
    const int why = errno;
    std::error_code none;
    require(is_new || std::filesystem::exists(made, none), "the folder '{}' cannot be made: {}",
            path, std::strerror(why));
  }
  if (is_new || existing == ExistingFolder::kStays) return;
  // Change the mode of the checked folder itself, even if its path is replaced at the same time.
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  require(folder >= 0, "the folder '{}' cannot be used: {}", path, std::strerror(errno));
  struct stat about {};
  const bool own = fstat(folder, &about) == 0 && about.st_uid == geteuid();
  const bool closed =
      own && ((about.st_mode & 0777) == kOwnerMode || fchmod(folder, kOwnerMode) == 0);
  (void)close(folder);
  require(closed, "the folder '{}' belongs to somebody else", path);
}

}  // namespace thenar
