#include "data/io/robot/import_warnings.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace thenar::internal {
namespace {

bool holds(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

int weight(const std::string& warning) {
  for (const char* grave : {"MISSING", "UNREADABLE", "INCOMPLETE", "LEFT OUT"})
    if (holds(warning, grave)) return 0;
  for (const char* light : {"is not read", "is not understood", "is not heeded"})
    if (holds(warning, light)) return 2;
  return 1;
}

}  // namespace

std::vector<std::string> by_weight(const std::vector<std::string>& warnings) {
  std::vector<std::string> once;
  std::map<std::string, int> times;
  for (const std::string& warning : warnings)
    if (++times[warning] == 1) once.push_back(warning);
  std::stable_sort(once.begin(), once.end(), [](const std::string& a, const std::string& b) {
    return weight(a) < weight(b);
  });
  for (std::string& warning : once)
    if (const int count = times.at(warning); count > 1)
      warning += fmt::format(" ({} times)", count);
  return once;
}

}  // namespace thenar::internal
