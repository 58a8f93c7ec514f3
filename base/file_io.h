#pragma once

/// Safe reading and writing of whole files.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Returns true if the path is a regular file or a link to one; false also if that cannot be
/// determined, for example for names that are too long.
[[nodiscard]] bool is_file(const std::string& path);

/// Returns all bytes of a regular file, or of a link to one. Throws for a folder, a pipe, a socket
/// or a device (which may block for ever, or never end) before anything is read.
/// @param most  largest size [bytes]; throws for a longer file before memory is allocated
/// @throws DataError `path:1: ...` if there is no such file, or it is not regular.
[[nodiscard]] std::string read_file(const std::string& path, std::size_t most);

/// Returns the first bytes of a regular file: all of them if it has no more.
/// @param count  number of bytes to read [bytes]
/// @throws DataError like read_file().
[[nodiscard]] std::string read_start(const std::string& path, std::size_t count);

/// Writes a file atomically: to a new temporary file beside `path`, which is renamed when complete.
/// On a full disk an older file at `path` is unchanged, and no temporary file is left. Missing
/// folders are made. If `path` is a symbolic link, its target is written, and the link is kept.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

/// Writes a group of files: all are complete on the disk before the first is renamed, so that a
/// full disk leaves none of them. They appear in order.
/// @param files  path and content of each
/// @throws InputError if one of them cannot be written.
void write_files(const std::vector<std::pair<std::string, std::string>>& files);

/// Makes the missing folders of `path`, and checks that a file can be written there. Call it before
/// long work whose result is written there. Touches no other file.
/// @throws InputError if it cannot.
void require_writable(const std::string& path);

/// Lock that keeps other processes from a file: a lock on an empty file beside the file (or the
/// target of its link) with the added ending ".lock", which is removed at the end. It is released
/// however the process ends.
class FileLock {
 public:
  /// @throws InputError if another process holds it, or the lock cannot be made.
  explicit FileLock(const std::string& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::string name_;
  int file_ = -1;
};

}  // namespace thenar
