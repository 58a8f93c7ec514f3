#include "api/named/shipped_data.h"

#include <filesystem>

namespace thenar {

namespace fs = std::filesystem;

std::string installed_data() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  if (unknown) return "";
  return (program.parent_path().parent_path() / "share" / "thenar").string();
}

std::vector<std::string> shipped_data() {
  std::vector<std::string> places;
  if (std::string installed = installed_data(); !installed.empty()) places.push_back(installed);
  places.emplace_back(THENAR_SOURCE_DATA);
  return places;
}

}  // namespace thenar
