#pragma once

#include <string>

namespace thenar {

/// Keeps other processes from a file while one works on it: a lock on an empty file beside it
/// (where links lead), its name and ".lock", which is removed at the end. It is given back however
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
