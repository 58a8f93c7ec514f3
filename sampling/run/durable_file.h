#pragma once

/// Files that survive a crash: what was said to be written is on the disk, or an error was thrown.

#include <cstdint>
#include <string>

namespace thenar::internal {

/// An open file that is only ever made longer, or cut to a length known to be good.
class AppendFile {
 public:
  /// Opens, or makes, a file. @throws InputError if that is not possible.
  explicit AppendFile(std::string path);
  ~AppendFile();
  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&&) = delete;

  void cut(std::int64_t bytes);             // forgets what stands behind
  void append(const std::string& bytes);    // at the end
  void sync();                              // returns when all of it is on the disk
  [[nodiscard]] std::int64_t size() const;  // [bytes]
  [[nodiscard]] std::string read(std::int64_t from, std::int64_t bytes) const;
  /// False if another process holds it. Given back when this one ends, however it ends.
  [[nodiscard]] bool lock();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  int file_ = -1;
};

/// Puts a file in the place of an older one at once: whoever reads finds the one or the other.
/// @throws InputError if it cannot be written; the older one stays.
void replace_file(const std::string& path, const std::string& bytes);

}  // namespace thenar::internal
