#pragma once

/// TOML as a plain tree that remembers line numbers.

#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Kind of a TOML value.
enum class TomlKind { kText, kNumber, kFlag, kDate, kArray, kTable };

/// One value, with everything below it.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the text
struct TomlNode {
  TomlKind kind = TomlKind::kTable;
  int line = 1;                                           // line in the file, from 1
  std::string text;                                       // value of kText
  double number = 0;                                      // value of kNumber, integers too
  bool flag = false;                                      // value of kFlag
  std::vector<TomlNode> items;                            // entries of kArray
  std::vector<std::pair<std::string, TomlNode>> members;  // members of kTable, in file order
  std::vector<std::size_t> by_name;                       // indices of members, sorted by name

  /// Returns the member of that name, or null; found by bisection.
  [[nodiscard]] const TomlNode* find(const std::string& key) const;
};

/// Parses TOML 1.0 within the limits of data/io/file_guard.h.
/// @throws DataError at the line of the first syntax error.
[[nodiscard]] TomlNode parse_toml(const std::string& text, const std::string& path);

/// Returns the name of a kind in messages: "a number".
[[nodiscard]] std::string kind_name(TomlKind kind);

/// Returns the whole content of a regular file. @throws DataError if it is not one, or cannot be
/// opened.
[[nodiscard]] std::string read_text_file(const std::string& path);

}  // namespace thenar
