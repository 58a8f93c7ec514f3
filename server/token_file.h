#pragma once

/// The token of a server in a file of the user's own, from which programs of this machine take it.

#include <cstdint>
#include <string>
#include <vector>

namespace thenar {

/// FOLDER/PORT.token, which holds the token and the end of a line, for as long as it lives. The
/// folder is of mode 700, the file of mode 600 from its beginning.
class TokenFile {
 public:
  /// A file that a server left behind at the same port is replaced.
  /// @throws InputError if it can be written to no folder.
  TokenFile(int port, const std::string& token);
  /// Removes it, unless another server has put its own there.
  ~TokenFile();
  TokenFile(const TokenFile&) = delete;
  TokenFile& operator=(const TokenFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::uint64_t device_ = 0, number_ = 0;  // of the file, by which it is known again
};

}  // namespace thenar
