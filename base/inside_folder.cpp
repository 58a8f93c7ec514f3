#include "base/inside_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/outside_path.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_write(const std::string& name, const std::string& why) {
  throw InputError(fmt::format("'{}' cannot be written: {}", name, why));
}

/// An open file or folder.
class OpenEntry {
 public:
  explicit OpenEntry(int file) : file_(file) {}
  ~OpenEntry() {
    if (file_ >= 0) (void)::close(file_);
  }
  OpenEntry(OpenEntry&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  OpenEntry& operator=(OpenEntry&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  OpenEntry(const OpenEntry&) = delete;
  OpenEntry& operator=(const OpenEntry&) = delete;
  [[nodiscard]] int file() const { return file_; }
  /// @returns true if closing reported no error
  [[nodiscard]] bool close() { return ::close(std::exchange(file_, -1)) == 0; }

 private:
  int file_;
};

/// Opens a folder in a folder, unless it is a link. @returns -1 with errno if it cannot be
int open_folder(int folder, const char* name) {
  return openat(folder, name, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

InsideFolder::Entry entry_in(int folder, const std::string& name) {
  struct stat about {};
  if (fstatat(folder, name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0)
    return InsideFolder::Entry::kNothing;
  if (S_ISREG(about.st_mode)) return InsideFolder::Entry::kFile;
  return S_ISDIR(about.st_mode) ? InsideFolder::Entry::kFolder : InsideFolder::Entry::kOther;
}

enum class MissingFolders { kMake, kLeave };

/// The folder of a name, opened part by part. -1 if one is missing and is left so.
OpenEntry folder_of(int root, const std::string& name, MissingFolders missing) {
  OpenEntry folder(open_folder(root, "."));
  for (const fs::path& part : fs::path(name).parent_path()) {
    int next = open_folder(folder.file(), part.c_str());
    if (next < 0 && errno == ENOENT && missing == MissingFolders::kLeave) return OpenEntry(-1);
    // Somebody else may make it at the same time.
    if (next < 0 && errno == ENOENT && mkdirat(folder.file(), part.c_str(), 0777) != 0 &&
        errno != EEXIST)
      refuse_write(name, std::strerror(errno));
    if (next < 0) next = open_folder(folder.file(), part.c_str());
    if (next < 0 && entry_in(folder.file(), part.string()) == InsideFolder::Entry::kOther)
      refuse_write(name, fmt::format("'{}' is a link, and none is followed", part.string()));
    if (next < 0) refuse_write(name, std::strerror(errno));
    folder = OpenEntry(next);
  }
  return folder;
}

/// @throws InputError unless nothing or a file has the name
void require_place(int folder, const std::string& name) {
  const std::string last = fs::path(name).filename().string();
  const InsideFolder::Entry there = entry_in(folder, last);
  if (there == InsideFolder::Entry::kFolder) refuse_write(name, "it is a folder");
  if (there == InsideFolder::Entry::kOther)
    refuse_write(name, "it is a link or a device, and none is followed");
}

/// New file with an unused name; removed unless it is renamed.
class NewFile {
 public:
  NewFile(int folder, const std::string& name) : folder_(folder), whole_(name) {
    constexpr int kMaxNameTrials = 1000;  // Most names tried; killed runs leave some behind
    last_ = fs::path(name).filename().string();
    for (int i = 0; i < kMaxNameTrials && file_.file() < 0; ++i) {
      new_ = last_ + ".tmp" + (i == 0 ? "" : std::to_string(i));
      file_ = OpenEntry(openat(folder_, new_.c_str(),
                               O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
      if (file_.file() < 0 && errno != EEXIST) break;
    }
    if (file_.file() < 0) refuse_write(name, std::strerror(errno));
  }
  ~NewFile() {
    if (!new_.empty()) (void)unlinkat(folder_, new_.c_str(), 0);
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(const std::string& content) {
    for (std::size_t done = 0; done < content.size();) {
      const ssize_t count = ::write(file_.file(), content.data() + done, content.size() - done);
      if (count < 0 && errno != EINTR) refuse_write(whole_, std::strerror(errno));
      if (count > 0) done += static_cast<std::size_t>(count);
    }
    if (!file_.close()) refuse_write(whole_, std::strerror(errno));
    // A link that was put there meanwhile is replaced itself.
    if (renameat(folder_, new_.c_str(), folder_, last_.c_str()) != 0)
      refuse_write(whole_, std::strerror(errno));
    new_.clear();
  }

 private:
  int folder_;
  std::string whole_, last_, new_;
  OpenEntry file_{-1};
};

}  // namespace

InsideFolder::InsideFolder(const std::string& folder) {
  std::error_code failed;
  path_ = fs::canonical(folder.empty() ? "." : folder, failed).string();
  if (!failed) folder_ = open(path_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  require(folder_ >= 0, "there is no folder '{}'", folder);
}

InsideFolder::~InsideFolder() { (void)close(folder_); }

std::string InsideFolder::path_of(const std::string& name) const {
  return (fs::path(path_) / outside_path(name, OutsideUse::kInside)).string();
}

InsideFolder::Entry InsideFolder::entry(const std::string& name) const {
  const std::string path = outside_path(name, OutsideUse::kInside);
  const OpenEntry folder = folder_of(folder_, path, MissingFolders::kLeave);
  if (folder.file() < 0) return Entry::kNothing;
  return entry_in(folder.file(), fs::path(path).filename().string());
}

void InsideFolder::write(const std::string& name, const std::string& content) const {
  const std::string path = outside_path(name, OutsideUse::kInside);
  const OpenEntry folder = folder_of(folder_, path, MissingFolders::kMake);
  require_place(folder.file(), path);
  NewFile file(folder.file(), path);
  file.write(content);
}

void InsideFolder::require_writable(const std::string& name) const {
  const std::string path = outside_path(name, OutsideUse::kInside);
  const OpenEntry folder = folder_of(folder_, path, MissingFolders::kMake);
  require_place(folder.file(), path);
  const NewFile file(folder.file(), path);
}

}  // namespace thenar
