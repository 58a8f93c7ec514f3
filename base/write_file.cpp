#include "base/write_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
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

/// What a path stands for when links are followed, whether it is there or not.
std::string behind_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  fs::path place(path);
  std::error_code error;
  for (int i = 0; fs::is_symlink(place, error); ++i) {
    require(i < kMostLinks, "cannot write '{}': its links lead in a circle", path);
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
  std::vector<std::string> places;
  std::vector<std::unique_ptr<Temporary>> written;  // removed where one of them fails
  for (const auto& [path, content] : files) {
    places.push_back(behind_links(path));
    written.push_back(std::make_unique<Temporary>(ready(places.back())));
    written.back()->write(content);
  }
  for (std::size_t i = 0; i < written.size(); ++i) written[i]->rename(places[i]);
}

}  // namespace thenar
