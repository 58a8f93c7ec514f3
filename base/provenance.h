#pragma once

/// Provenance of a number: hashes of its inputs and versions of the programs that computed it.

#include <map>
#include <string>
#include <vector>

namespace thenar {

/// Returns the SHA-256 of a text in hexadecimal digits.
[[nodiscard]] std::string sha256(const std::string& text);

/// Files that an answer came from: path -> SHA-256 of its bytes.
using FileDigests = std::map<std::string, std::string>;

/// Returns the digests of the files in their present state, by their paths without "." and "x/..".
/// @throws DataError as read_file()
[[nodiscard]] FileDigests digests_of(const std::vector<std::string>& paths);

/// Text of a file as it was read, with its path.
struct SourceText {
  std::string path;
  std::string text;
};

/// Returns the digests of texts, by their unchanged paths.
[[nodiscard]] FileDigests source_digests(const std::vector<SourceText>& sources);

/// Returns the versions of thenar, its compiler and the libraries that results depend on, by name;
/// for shared libraries, those found by the build.
[[nodiscard]] std::map<std::string, std::string> versions();

}  // namespace thenar
