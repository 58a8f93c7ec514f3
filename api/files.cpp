#include "api/files.h"

#include <filesystem>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/checked_file.h"
#include "data/io/file_kind.h"
#include "data/io/toml_node.h"

namespace thenar {

SourceText read_source(const std::string& path) { return {path, read_text_file(path)}; }

std::vector<std::string> checksum_warnings(const std::string& path) {
  if (!has_hdf5_start(path) || has_checksum(path)) return {};
  return {path + ": it has no checksum, so that damage cannot be noticed"};
}

void require_result_path(const std::string& path) {
  const auto is_result = [&] {
    try {
      return find_file_kind(path) == FileKind::kResult;
    } catch (const DataError&) {
      return false;
    }
  };
  std::error_code none;
  require(!std::filesystem::exists(path, none) || is_result(),
          "'{}' exists and is no result file of thenar; it is not overwritten", path);
  require_writable(path);
}

}  // namespace thenar
