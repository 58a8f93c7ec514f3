#include "base/write_file.h"

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace thenar {

void write_file(const std::string& path, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target(path);
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  const std::string temporary = path + ".tmp";
  {
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    require(file.flush().good(), "cannot write '{}'", temporary);
  }
  fs::rename(temporary, target, error);
  require(!error, "cannot rename '{}' to '{}': {}", temporary, path, error.message());
}

}  // namespace thenar
