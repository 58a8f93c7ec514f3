#include "base/write_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>

#include "base/error.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// A new file beside `path`, under a name that nobody uses; removed unless it is renamed.
class Temporary {
 public:
  explicit Temporary(const std::string& path) {
    constexpr int kNames = 1000;  // left behind by runs that were killed, or of others just now
    for (int i = 0; i < kNames && !file_; ++i) {
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

Temporary beside(const std::string& path) {
  std::error_code error;
  require(!fs::exists(path, error) || fs::is_regular_file(path, error),
          "cannot write '{}': it is not a file but a folder or a device", path);
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  return Temporary(path);
}

}  // namespace

void require_writable(const std::string& path) { (void)beside(path); }

void write_file(const std::string& path, const std::string& content) {
  Temporary file = beside(path);
  file.write(content);
  file.rename(path);
}

}  // namespace thenar
