#include "data/io/toml_file.h"

#include <utility>

#include "base/error.h"
#include "data/io/sources.h"
#include "data/io/toml_table.h"

namespace thenar {

TomlFile::TomlFile(const std::string& text, std::string path)
    : path_(std::move(path)), root_(parse_toml(text, path_)), sources_(known_sources()) {
  const TomlNode* own = root_.find("sources");
  if (own == nullptr) return;
  for (const auto& [key, reference] : own->members) {
    if (reference.kind != TomlKind::kText)
      throw DataError(path_, reference.line,
                      fmt::format("wanted the reference of source '{}' as a text, got {}", key,
                                  kind_name(reference.kind)));
    sources_.push_back(key);
  }
}

TomlTable TomlFile::top() const {
  TomlTable table(*this, root_, "the top level", {});
  table.ignore("sources");
  return table;
}

}  // namespace thenar
