#pragma once

/// Files that are written into a folder under names from outside.

#include <string>

namespace thenar {

/// A folder in which files are written under names of OutsideUse::kInside. No symbolic link below
/// it is followed, even if another process puts one there meanwhile.
class InsideFolder {
 public:
  /// Kind of entry under a name.
  enum class Entry { kNothing, kFile, kFolder, kOther };  // kOther: a link, a pipe, a device

  /// @param folder  links in its own path are followed: the caller has chosen it
  /// @throws InputError if there is no such folder
  explicit InsideFolder(const std::string& folder);
  ~InsideFolder();
  InsideFolder(const InsideFolder&) = delete;
  InsideFolder& operator=(const InsideFolder&) = delete;

  /// Returns its own path, absolute and without links.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Returns the path of a name, absolute and without links. @throws InputError as outside_path()
  [[nodiscard]] std::string path_of(const std::string& name) const;
  /// @throws InputError for a name that is none, or one behind a link
  [[nodiscard]] Entry entry(const std::string& name) const;
  /// Writes a file, complete or not at all, over one that is there. Missing folders are made.
  /// @throws InputError if it cannot be written, or a link, a folder or a device is in its place
  void write(const std::string& name, const std::string& content) const;
  /// Checks that write() would find its place. @throws InputError as write()
  void require_writable(const std::string& name) const;

 private:
  std::string path_;
  int folder_ = -1;
};

}  // namespace thenar
