#pragma once

/// Writing of files into a folder under untrusted names.

#include <string>

namespace thenar {

/// Folder in which files are written under names of OutsideUse::kInside. No symbolic link below it
/// is followed, even if another process creates one at the same time.
class InsideFolder {
 public:
  /// Kind of entry under a name.
  enum class Entry { kNothing, kFile, kFolder, kOther };  // kOther: a link, a pipe, a device

  /// @param folder  path chosen by the caller; links in it are followed
  /// @throws InputError if there is no such folder
  explicit InsideFolder(const std::string& folder);
  ~InsideFolder();
  InsideFolder(const InsideFolder&) = delete;
  InsideFolder& operator=(const InsideFolder&) = delete;

  /// Returns the path of the folder, absolute and without links.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Returns the path of a name, absolute and without links. @throws InputError as outside_path()
  [[nodiscard]] std::string path_of(const std::string& name) const;
  /// Returns the kind of entry under a name. @throws InputError for an invalid name, or one behind
  /// a link
  [[nodiscard]] Entry entry(const std::string& name) const;
  /// Writes a file atomically, replacing an existing one. Missing folders are made.
  /// @throws InputError if it cannot be written, or a link, a folder or a device is in its place
  void write(const std::string& name, const std::string& content) const;
  /// Checks that write() would succeed. @throws InputError as write()
  void require_writable(const std::string& name) const;

 private:
  std::string path_;
  int folder_ = -1;
};

}  // namespace thenar
