#pragma once

/// A TOML data file: its tree, its name for messages, and the sources it may cite.

#include <string>
#include <vector>

#include "data/io/toml_node.h"

namespace thenar {

class TomlTable;

/// A parsed file. Its tables point into it, so it must outlive them.
class TomlFile {
 public:
  /// Parses `text`; `path` only names it in messages.
  /// @throws DataError at the first syntax error.
  TomlFile(const std::string& text, std::string path);

  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;

  /// The file's top level. Its `[sources]` table, if any, is already read.
  [[nodiscard]] TomlTable top() const;

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Citation keys of data/sources.bib, then those of the file's own `[sources]`.
  [[nodiscard]] const std::vector<std::string>& sources() const { return sources_; }

 private:
  std::string path_;
  TomlNode root_;
  std::vector<std::string> sources_;
};

}  // namespace thenar
