#pragma once

/// Files that survive a crash: after sync() the bytes are on the disk, or an error was thrown.

#include <cstdint>
#include <string>

namespace thenar::internal {

/// Open file that is only appended to, or truncated to a length known to be good.
class AppendFile {
 public:
  /// Opens or creates a file. @throws InputError on failure.
  explicit AppendFile(std::string path);
  ~AppendFile();
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&&) = delete;

  void truncate(std::int64_t bytes);        // keeps the first `bytes` bytes
  void append(const std::string& bytes);    // appends the bytes at the end
  void sync();                              // returns when all bytes are on the disk
  [[nodiscard]] std::int64_t size() const;  // [bytes]
  [[nodiscard]] std::string read(std::int64_t from, std::int64_t bytes) const;
  /// Locks the file; returns false if another process holds the lock. The lock ends with this
  /// process, however it ends.
  [[nodiscard]] bool lock();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  int file_ = -1;
};

/// Replaces a file atomically: a reader finds either the old or the new content.
/// @throws InputError if it cannot be written; the old file stays.
void replace_file(const std::string& path, const std::string& bytes);

}  // namespace thenar::internal
