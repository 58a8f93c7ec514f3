#pragma once

/// Provenance of a number: hashes of its inputs and versions of the programs that computed it.

#include <map>
#include <string>

namespace thenar {

/// SHA-256 of a text, in hexadecimal digits.
[[nodiscard]] std::string sha256(const std::string& text);

/// Versions of thenar, its compiler and the libraries that answers depend on, by name; of shared
/// libraries the ones that the build found.
[[nodiscard]] std::map<std::string, std::string> versions();

}  // namespace thenar
