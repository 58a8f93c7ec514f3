#pragma once

/// Token of a server in a private file of the user, where programs of this machine find it.

#include <cstdint>
#include <string>

namespace thenar {

/// File FOLDER/PORT.token with the token and a newline, which exists for the lifetime of the
/// object. The folder has mode 700, the file is created with mode 600.
class TokenFile {
 public:
  /// Writes the file; replaces one that another server left behind.
  /// @throws InputError if it cannot be written to any folder
  TokenFile(int port, const std::string& token);
  /// Removes the file, unless another server has replaced it.
  ~TokenFile();
  TokenFile(const TokenFile&) = delete;
  TokenFile& operator=(const TokenFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::uint64_t device_ = 0, number_ = 0;  // device and inode of the file
};

}  // namespace thenar
