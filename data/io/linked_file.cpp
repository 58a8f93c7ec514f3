#include "data/io/linked_file.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/outside_path.h"

namespace thenar {

std::string linked_file(const TomlTable& table, const std::string& key, const std::string& name,
                        const std::string& folder, const std::string& kind) {
  std::string path;
  internal::check_here(
      table, [&] { path = linked_path(folder, name); }, key);
  if (!is_file(path)) table.fail(fmt::format("there is no {} '{}'", kind, path), key);
  return path;
}

}  // namespace thenar
