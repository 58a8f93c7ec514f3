#include "base/write_file.h"

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace thenar {

void require_writable(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  const std::string probe = path + ".tmp";
  const bool ok = std::ofstream(probe).good();
  fs::remove(probe, error);
  require(ok, "cannot write '{}'", path);
}

void write_file(const std::string& path, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code error;
  require_writable(path);
  const std::string temporary = path + ".tmp";
  {
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    require(file.flush().good(), "cannot write '{}'", temporary);
  }
  fs::rename(temporary, path, error);
  require(!error, "cannot rename '{}' to '{}': {}", temporary, path, error.message());
}

}  // namespace thenar
