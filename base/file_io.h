#pragma once

/// Reading and writing of whole files, without trust in what stands under their names.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Returns whether a regular file, or a link to one, is there; false also where that cannot be
/// found out, as of names that are too long.
[[nodiscard]] bool is_file(const std::string& path);

/// Returns all bytes of a regular file, or of a link to one. A folder, a pipe, a socket or a device
/// (which may block for ever, or never end) is refused before anything is read from it.
/// @param most  bytes; a longer file is refused before memory is taken for it
/// @throws DataError `path:1: ...` if there is no such file, or it is none of these.
[[nodiscard]] std::string read_file(const std::string& path, std::size_t most);

/// Returns the first bytes of a regular file: all of them if it has no more.
/// @param count  how many are wanted [bytes]
/// @throws DataError like read_file().
[[nodiscard]] std::string read_start(const std::string& path, std::size_t count);

/// Writes a file so that nothing half-written is ever left: first a new file of its own beside
/// `path`, renamed when complete. A full disk leaves an older file at `path` as it was, and
/// nothing beside it. Missing folders are made. Where `path` is a symbolic link, what it points to
/// is written, and the link stays.
/// @throws InputError if it cannot be written.
void write_file(const std::string& path, const std::string& content);

/// Writes files that belong together: all are complete on the disk before the first is renamed, so
/// that a full disk leaves none of them. They appear in their order.
/// @param files  path and content of each
/// @throws InputError if one of them cannot be written.
void write_files(const std::vector<std::pair<std::string, std::string>>& files);

/// Makes the missing folders of `path`, and checks that a file can be written there: to be called
/// before long work whose result goes to it. Touches no other file.
/// @throws InputError if it cannot.
void require_writable(const std::string& path);

/// Keeps other processes from a file while this one works on it: a lock on an empty file beside it
/// (where links lead), its name and ".lock", which is removed at the end. It is released however
/// the process ends.
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
